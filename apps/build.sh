#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds tamp in build/ (Release). Usage: build.sh [TARGET...];
# without a target everything is built.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cores=$(env -u OMP_NUM_THREADS nproc) # which counts threads otherwise
jobs=$((cores < 2 ? 2 : cores))

if ! cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release; then
  echo "build.sh: the build could not be configured. Run" \
    "apps/install_packages.sh; if it still fails, delete build/ and try" \
    "again." >&2
  exit 4
fi
command=(cmake --build "$root/build" --parallel "$jobs")
if [ $# -gt 0 ]; then
  command+=(--target "$@")
fi
if ! "${command[@]}"; then
  echo "build.sh: the build failed; the first error above says where." >&2
  exit 4
fi
