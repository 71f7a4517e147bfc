#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The example die_compare, coarse (probes of 120 granules, a die of 2 x 3
# elements): grains to curves, curves to laws, both in the same die.
# Usage: die_compare.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

COARSE=1 "$tamp" examples run die_compare -o all > out.txt 2> err.txt ||
  { cat out.txt err.txt; fail "the example"; }
has all/compare/{compare.csv,difference.vtu,summary.txt} \
  all/compare/plots/{compaction,wall_pressure,ejection}.png \
  all/fit_drucker-prager-cap/law_abaqus.inp

# Every row of the table in the README is found in compare.csv, within 5 %:
# rounding, as another friction by 1e-12 makes it, moves ratios by 2 %.
"$tamp" examples copy die_compare . > out.txt
awk -F "[|,]" '
  FILENAME ~ /README/ {
    checked = checked && !/^## / || /^## Numbers that a test checks/
    if (!checked || NF != 6)
      next
    gsub(/[` ]/, "")
    for (i = 3; i < 6; ++i)
      if ($2 ~ /\[/ && $i + 0 > 0) {
        wanted[$2, i] = $i
        ++rows
      }
    next
  }
  {
    for (i = 3; i < 6; ++i) {
      if (!(($1, i) in wanted))
        continue
      ratio = $i / $2
      wrong = (ratio / wanted[$1, i] - 1)^2 > 0.05^2
      print $1, ratio, "README:", wanted[$1, i], wrong ? "WRONG" : ""
      bad += wrong
      found++
    }
  }
  END { exit bad || !found || found != rows }' \
  die_compare/README.md all/compare/compare.csv ||
  fail "not what the README says"
awk '/largest difference of loading/ { found = 1; exit $NF > 0.05 }
  END { exit !found }' all/fit_drucker-prager-cap/summary.txt ||
  fail "the cap does not follow the probes within 5 %"
# What a law cannot do is said.
grep -q 'warning .* off that of the probes, more than 5 %' \
  all/fit_modified-cam-clay/summary.txt || fail "a law that is off in silence"
echo "all well"
