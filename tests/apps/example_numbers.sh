#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What the READMEs of quick examples say comes out, at full size.
# Usage: example_numbers.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

# result FOLDER NAME VALUE OFF: the key result is VALUE within OFF.
result() {
  awk -v name="\"$2\":" -v wanted="$3" -v off="$4" '
    $1 == name { x = $2 + 0; found = 1 }
    END { print name, x
      exit !(found && x - wanted <= off && wanted - x <= off) }' \
    "$1/run.json" || fail "$1: expected $2 = $3 within $4"
}
run() {
  "$tamp" examples run "$1" -o "$1" > out.txt 2> err.txt ||
    { cat out.txt err.txt; fail "the example $1"; }
}

# Off by half of the last digit that the READMEs print, and by 1e-3 of the force,
# to which the die is balanced.
run die_default_dpc
result die_default_dpc 'peak_upper_pressure[Pa]' 52.7e6 0.1e6
result die_default_dpc 'peak_lower_pressure[Pa]' 49.5e6 0.1e6
result die_default_dpc 'minimum_relative_density_at_peak[-]' 0.810 1e-3
result die_default_dpc 'maximum_relative_density_at_peak[-]' 0.884 1e-3
result die_default_dpc 'residual_wall_pressure_after_unloading[Pa]' 14.9e6 0.07e6
result die_default_dpc 'peak_ejection_force[N]' 558 1
result die_default_dpc 'axial_spring_back[m]' 55e-6 0.6e-6

# Tables end in free ejection over a sharp rim: the path of its steps, 2 of which
# are cut, moves the ejection force by a few tenths of a per cent.
run agcusnin_compact
result agcusnin_compact 'peak_upper_force[N]' 11113.57 11.2
result agcusnin_compact 'peak_lower_force[N]' 10524.2 10.6
result agcusnin_compact 'peak_ejection_force[N]' 330.7 2
result agcusnin_compact 'axial_spring_back_ejected[-]' 3.1e-3 6e-5
result agcusnin_compact 'radial_spring_back[-]' 6.9e-4 2e-5

# The same grains on every machine but for rounding, which packing makes larger:
# three times the scatter of packings over the root of three.
run pack_granules
result pack_granules 'relative_density[-]' 0.6025 0.0045
result pack_granules 'mechanical_coordination_number[-]' 5.44 0.03
result pack_granules 'lateral_over_axial_stress[-]' 0.528 0.027
echo "all well"
