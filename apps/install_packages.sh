#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages that tamp is built with and that are missing.
# Does nothing, and needs no rights, if all of them are there.
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache git ca-certificates
  libdeal.ii-dev gmsh libeigen3-dev libhwy-dev libvtk9-dev
  libopenblas0-serial libceres-dev libcli11-dev nlohmann-json3-dev libspdlog-dev
  libfmt-dev libgtest-dev libbenchmark-dev gnuplot-nox clang-format-14
  libceres-dev zlib1g-dev
)

if ! command -v dpkg-query > /dev/null; then
  echo "install_packages.sh: this is not a Debian system. Please install" \
    "what corresponds to these Debian 12 packages: ${packages[*]}" >&2
  exit 4
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null ||
    true)
  if ! grep -qx installed <<< "$state"; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "All packages are installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo > /dev/null; then
    echo "install_packages.sh: packages are missing and only root can install" \
      "them. As root, run: apt-get install ${missing[*]}" >&2
    exit 4
  fi
  as_root=(sudo)
fi

echo "Installing: ${missing[*]}"
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    apt-get "$@"
}
if ! apt update -q; then
  echo "install_packages.sh: 'apt-get update' failed. Check the network and" \
    "/etc/apt/sources.list, then run this again." >&2
  exit 4
fi
if ! apt install -q -y --no-install-recommends "${missing[@]}"; then
  echo "install_packages.sh: apt-get could not install: ${missing[*]}. tamp is" \
    "made for Debian 12 (bookworm); see the messages above." >&2
  exit 4
fi
