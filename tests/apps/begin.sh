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
# result FOLDER NAME: a key result, named with its unit.
result() {
  awk -F'": ' -v name="    \"$2" '
    $1 == name { sub(",", "", $2); print $2; found = 1 }
    END { exit !found }' "$1/run.json" || fail "$1/run.json has no $2"
}
# near VALUE WANTED SHARE: not farther off than this share.
near() {
  awk -v a="$1" -v b="$2" -v share="$3" '
    BEGIN { d = a / b - 1; exit !(a != "" && d <= share && -d <= share) }' ||
    fail "$1 is not within $3 of $2"
}
# has FILE...: all are there and not empty.
has() {
  for name in "$@"; do
    [ -s "$name" ] || fail "$name is missing or empty"
  done
}
