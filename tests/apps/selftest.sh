#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The program finds what is known in every room. Usage: selftest.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

"$tamp" selftest > out.txt || { cat out.txt; fail "exit code $?"; }
cat out.txt
for room in 'contacts of grains' 'unit cells' 'cells as material points' \
  'continuum laws' 'dies'; do
  grep -q "^$room (" out.txt || fail "no table of $room"
done
checks=$(grep -c '  passed  ' out.txt)
grep -q "^$checks checks, 0 failed" out.txt || fail "the checks do not add up"
[ "$checks" -ge 50 ] || fail "only $checks checks"
[ "$(ls | grep -cv '^granules\|^out.txt$')" -eq 0 ] || fail "it wrote files"
