#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unit cells of grains that adhere are released, ejected freely and pushed out
# of the die, and it is told how they spring back; loose grains that are to be
# treated so are refused. Usage: cohesive.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

cat > die.prm << 'END'
subsection Grains
  set Count            = 60
  set Minimum diameter = 4 um
  set Maximum diameter = 6 um
  set Young's modulus  = 5 GPa
end
subsection Contact
  set Normal law                = thornton-ning-jkr
  set Limiting contact pressure = 50 MPa
  set Work of adhesion          = 0.1 J/m2
end
subsection Packing
  set Pressure           = 1 MPa
  set Same at all points = true
end
subsection Die
  set Elements = 1, 1
end
subsection Schedule
  set Stages = press to density 0.62; unload to nothing; eject to out
end
subsection Solver
  set Maximum unloading step = 2e-3
end
END

"$tamp" die die.prm -o free > out.txt 2> err.txt || { cat err.txt; fail "exit code $?"; }
peak=$(result free 'peak_upper_force[N]')
for name in 'residual_wall_pressure_after_unloading[Pa]' \
  'axial_spring_back[m]' 'peak_ejection_force[N]' \
  'axial_spring_back_ejected[-]' 'radial_spring_back[-]'; do
  awk -v x="$(result free "$name")" 'BEGIN { exit !(x > 0) }' ||
    fail "$name is not above 0"
done
# What is left is unbalanced: 1e-3 of reactions that count as 10 % of the peak.
awk -v x="$(result free 'remaining_tool_force[N]')" -v peak="$peak" \
  'BEGIN { exit !(x <= 2e-4 * peak) }' || fail "a tool still bears a force"

for stages in 'unload to nothing' 'eject to rim freely' \
  'eject to out holding 5 % of peak'; do
  status=0
  "$tamp" die die.prm -o loose --set 'Contact/Work of adhesion = 0 J/m2' \
    --set "Schedule/Stages = press to density 0.62; $stages" \
    > out.txt 2> err.txt || status=$?
  [ "$status" -eq 2 ] || fail "$stages: exit code $status"
  grep -q 'grains without adhesion.*holding 5 %.*Work of adhesion' err.txt ||
    grep -q 'grains without adhesion.*unload to 5 %.*Work of adhesion' err.txt ||
    { cat err.txt; fail "$stages: the message does not say what to do"; }
  [ ! -e loose ] || fail "$stages: a folder was made"
done
