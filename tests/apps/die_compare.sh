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
  all/fit_cap/{law_abaqus.inp,unloading.csv,plots/unloading.png} \
  all/fit_cam_clay/{law_abaqus.inp,plots/bands.csv}

# Every row of the table in the README is found in compare.csv, within 5 %:
# rounding, as another friction by 1e-12 makes it, moves ratios by 2 %.
"$tamp" examples copy die_compare . > out.txt
awk -F "[|,]" '
  FILENAME ~ /README/ {
    checked = checked && !/^## / || /^## Numbers that a test checks/
    if (!checked || NF != 7)
      next
    gsub(/[` ]/, "")
    for (i = 3; i < 7; ++i)
      if ($2 ~ /\[/ && $i + 0 > 0) {
        wanted[$2, i] = $i
        ++rows
      }
    next
  }
  {
    for (i = 3; i < 7; ++i) {
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
# Secants of the whole unloading leave the compact with less than moduli of
# small probes do: half the wall pressure, more or less, of two packings.
awk -F, '$1 ~ /^residual_wall_pressure/ { found = 1; wrong = $4 > 0.65 * $3 }
  END { exit wrong || !found }' all/compare/compare.csv || fail "the soft cap is stiff"
# Tables have room for the powder to dilate as it is first loaded.
for law in cap soft_cap; do
  grep -q 'doubtful points  *0$' "all/$law/summary.txt" ||
    fail "doubtful points of $law"
done
awk '/largest difference of loading/ { found = 1; wrong = $NF > 0.05 }
  END { exit wrong || !found }' all/fit_cap/summary.txt ||
  fail "the cap does not follow the probes within 5 %"
# What a law cannot do is said.
grep -q 'warning .* off that of the probes, more than 5 %' \
  all/fit_cam_clay/summary.txt || fail "a law that is off in silence"
echo "all well"
