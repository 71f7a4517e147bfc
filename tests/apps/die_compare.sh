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

# ratio QUANTITY RUN LOW HIGH: of a run over that of the cells.
ratio() {
  awk -F, -v name="$1" -v run="$2" -v low="$3" -v high="$4" '
    $1 == "quantity" { for (i = 2; i <= NF; ++i) if ($i == run) column = i }
    $1 == name { x = $column / $2; found = 1 }
    END { print name, run, x; exit !(found && x > low && x < high) }' \
    all/compare/compare.csv || fail "expected $1 of $2 from $3 to $4"
}
# A cap that follows the probes presses as the cells do: 5 %, and 5 % for the
# scatter of packings of 80 and 120 granules.
ratio 'peak_upper_pressure[Pa]' cap 0.9 1.1
ratio 'transmission_at_peak[-]' cap 0.95 1.05
# Elasticity that does not soften while it is unloaded holds the compact in the
# die: at full size three laws leave 1.7 to 2.1 times the wall pressure; secants
# of the whole unloading leave 0.9 times.
for law in cap Cam-Clay FKM-Gurson; do
  ratio 'residual_wall_pressure_after_unloading[Pa]' "$law" 1.2 3
  ratio 'axial_spring_back[m]' "$law" 0.3 0.9
done
ratio 'residual_wall_pressure_after_unloading[Pa]' 'soft cap' 0.6 1.15
ratio 'peak_ejection_force[N]' 'soft cap' 0.75 1.2
# Tables have room for the powder to dilate as it is first loaded.
for law in cap soft_cap; do
  grep -q 'doubtful points  *0$' "all/$law/summary.txt" ||
    fail "doubtful points of $law"
done
awk '/largest difference of loading/ { found = 1; exit $NF > 0.05 }
  END { exit !found }' all/fit_cap/summary.txt ||
  fail "the cap does not follow the probes within 5 %"
# What a law cannot do is said.
grep -q 'warning .* off that of the probes, more than 5 %' \
  all/fit_cam_clay/summary.txt || fail "a law that is off in silence"
echo "all well"
