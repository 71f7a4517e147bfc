#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The README of every example shows a picture, a command, how long it takes on
# which machine, and numbers that a test checks.
set -euo pipefail
export LC_ALL=C
tests=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
failures=0

# Those whose tables are checked, and those with tests of their own.
checked="$(sed -n '/^# The numbers in the READMEs/,/^endforeach/p' \
  "$tests/CMakeLists.txt") die_compare probe_yield_surface"

# lacks WHAT: an example's README has none.
lacks() {
  echo "FAILED: the README of $example has no $1"
  failures=$((failures + 1))
}
cd "$tests/../../apps/examples"
for example in *; do
  readme=$example/README.md
  pictures=$(grep -o '!\[[^]]*\]([^)]*)' "$readme" | sed 's/.*(//; s/)//') ||
    lacks "picture"
  for picture in $pictures; do
    [ -s "$example/$picture" ] || lacks "picture $picture beside it"
  done
  grep -Eq '^    (COARSE=1 )?(tamp |apps/examples/)' "$readme" ||
    lacks "command"
  words=$(tr '\n' ' ' < "$readme")
  grep -Eq '[0-9] (s|min|minutes)\b' <<< "$words" || lacks "time"
  grep -Eq '(cores?|threads) of an? [^.]*EPYC' <<< "$words" || lacks "machine"
  case $example in
    # Figures of one page, which a test of its own makes.
    paper*) ;;
    *)
      grep -q '^## Numbers that a test checks$' "$readme" ||
        lacks "numbers that a test checks"
      grep -qw "$example" <<< "$checked" || lacks "test of its numbers"
      ;;
  esac
done
echo "$failures failures"
[ "$failures" -eq 0 ]
