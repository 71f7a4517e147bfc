#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What is said of a die run holds whoever presses: key results, pictures, and
# why a schedule cannot be done. Usage: die_results.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

cat > die.prm << 'END'
subsection Material
  set Type = drucker-prager cap
end
subsection Die
  set Elements = 3, 4
end
subsection Solver
  set Force tolerance = 1e-8
  set Maximum step    = 2e-2
end
subsection Output
  set Plot format = svg
end
END

# column FOLDER NAME: the largest value of a column of the curve.
column() {
  awk -F, -v name="$2" '/^#/ { next }
    !field { for (i = 1; i <= NF; ++i) if ($i == name) field = i; next }
    $field > most || most == "" { most = $field }
    END { print most }' "$1/curve.csv"
}
# holds FOLDER CONDITION VALUE...: an awk condition of the values a, b, c.
holds() {
  awk -v a="$3" -v b="${4:-0}" -v c="${5:-0}" "BEGIN { exit !($2) }" ||
    fail "$1: not $2 for ${*:3}"
}

for who in upper lower both; do
  travel=4; [ "$who" = both ] && travel=2
  "$tamp" die die.prm -o "$who" --set "Schedule/Stages = press $who to \
displacement $travel mm; unload to nothing; eject to out" > out.txt ||
    fail "press $who"
  presser=$who; [ "$who" = both ] && presser=upper
  peak=$(result "$who" "peak_${presser}_force[N]")
  # The peak is that of the punch that presses.
  holds "$who" 'a == b' "$peak" "$(column "$who" "${presser}_force[N]")"
  # A single action loses force to the wall; a double one is symmetric.
  if [ "$who" = both ]; then
    holds "$who" 'a > 0.9999 && a < 1.0001' \
      "$(result "$who" 'transmission_at_peak[-]')"
  else
    holds "$who" 'a > 0.3 && a < 0.95' \
      "$(result "$who" 'transmission_at_peak[-]')"
  fi
  # Elastic strain of the compact is between a few thousandths and a tenth.
  height=$(result "$who" 'height_at_peak[m]')
  unloaded=$(result "$who" 'axial_spring_back[m]')
  axial=$(result "$who" 'axial_spring_back_ejected[-]')
  radial=$(result "$who" 'radial_spring_back[-]')
  for value in "$axial" "$radial"; do
    holds "$who" 'a > 1e-3 && a < 0.1' "$value"
  done
  holds "$who" 'a > 1e-3 * b && a < 0.1 * b' "$unloaded" "$height"
  # Free of the die, the compact springs back to the sides as well.
  holds "$who" 'a > b - 1e-6' "$(result "$who" 'final_height[m]')" "$height"
  holds "$who" 'a - b * (1 + c) < 1e-12 && b * (1 + c) - a < 1e-12' \
    "$(result "$who" 'final_height[m]')" "$height" "$axial"
  # No tool holds it.
  holds "$who" 'a < 1e-6 * b' \
    "$(result "$who" 'remaining_tool_force[N]')" "$peak"
  holds "$who" 'a > 0' \
    "$(result "$who" 'residual_wall_pressure_after_unloading[Pa]')"
  ! grep -qE '(^|[ :])-0([ ,]|$)' "$who"/{summary.txt,run.json,log.txt} ||
    fail "$who: minus zero"
  for heading in Pressing Unloading Ejection; do
    grep -qx "$heading" "$who/summary.txt" || fail "$who: no $heading"
  done
  grep -qE '^  time contact .* s .*\([0-9]+ %\)$' "$who/summary.txt" ||
    fail "$who: no share of time"
  if command -v gnuplot > /dev/null; then
    has "$who"/plots/{compaction,pressures,forces,radial_stress,transmission}.svg
    has "$who"/plots/{ejection,spring_back,density_map,density_map_final}.svg
    has "$who"/plots/{axial_stress_final,hoop_stress_final}.svg
    # In the C locale gnuplot complains of a degree sign, which nobody uses.
    ! grep -sv 'degree sign' "$who/plots/gnuplot.log" ||
      fail "$who: gnuplot complains"
  fi
done
# Pressing from below is pressing from above, upside down.
for name in 'height_at_peak[m]' 'transmission_at_peak[-]' \
  'axial_spring_back[m]'; do
  holds mirrored 'a / b > 1 - 1e-6 && a / b < 1 + 1e-6' \
    "$(result upper "$name")" "$(result lower "$name")"
done
holds mirrored 'a / b > 1 - 1e-6 && a / b < 1 + 1e-6' \
  "$(result upper 'peak_upper_force[N]')" \
  "$(result lower 'peak_lower_force[N]')"

# What cannot be done is said as it is; a law is not told about grains.
status=0
"$tamp" die die.prm -o impossible --no-plots --set \
  'Schedule/Stages = press to density 0.5; unload to force 9 kN' \
  > out.txt 2> err.txt || status=$?
[ "$status" -eq 3 ] || fail "impossible: exit code $status"
grep -q 'stage 2 cannot be done' err.txt || fail "impossible: $(cat err.txt)"
for words in 'did not converge' grains Smaller; do
  ! grep -q "$words" err.txt || fail "impossible: $(cat err.txt)"
done
echo "all well"
