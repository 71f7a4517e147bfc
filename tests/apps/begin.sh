# SPDX-License-Identifier: BSD-3-Clause
# How every test of the program begins: in an empty folder of its own, which is
# removed at the end. Sourced with the path of the program as $1.
set -euo pipefail
export LC_ALL=C OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

tamp=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The grains of most tests, and a die of them, for "include granules.prm".
cp "$(dirname "${BASH_SOURCE[0]}")"/granules{,_die}.prm "$work"
cd "$work"

fail() {
  echo "FAILED: $*"
  exit 1
}
# has FILE...: all are there and not empty.
has() {
  for name in "$@"; do
    [ -s "$name" ] || fail "$name is missing or empty"
  done
}
