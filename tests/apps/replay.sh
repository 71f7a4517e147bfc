#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A die of one element and a probe of one of its points are the same material
# under the same deformation. Usage: replay.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
# columns FILE NAME...: these columns of all lines, characters untouched.
columns() {
  local file=$1
  shift
  awk -F, -v names="$*" '/^#/ { next }
    !found { found = split(names, name, " ")
      for (i = 1; i <= NF; ++i) place[$i] = i
      for (i = 1; i <= found; ++i) if (!place[name[i]]) exit 1
      next }
    { line = $place[name[1]]
      for (i = 2; i <= found; ++i) line = line "," $place[name[i]]
      print line }' "$file" || fail "$file lacks one of $*"
}
stresses='stress_xx[Pa] stress_yy[Pa] stress_zz[Pa] stress_yz[Pa] stress_xz[Pa] stress_xy[Pa]'

cat > cell.prm << 'END'
include granules.prm
subsection Grains
  set Count = 100
end
subsection Contact
  set Friction coefficient = 0.35
end
subsection Cell
  set Warm start = false
end
subsection Die
  set Elements                  = 1, 1
  set Wall friction coefficient = 0
end
subsection Schedule
  set Stages = press to density 0.64
end
subsection Output
  set Grain output = chosen points
  set Grain points = 0
end
END

# The tools prescribe all displacements of one element. The same deformations
# give the same stresses, character by character.
"$tamp" die cell.prm -o die -q --no-plots
"$tamp" probe cell.prm -o probe -q --no-plots \
  --set 'Path/Stages = csv die/grains/point_0000.csv'
columns die/grains/point_0000.csv $stresses 'relative_density[-]' > die.txt
# The probe starts with a line for the start itself.
columns probe/curve.csv $stresses 'relative_density[-]' | tail -n +2 > probe.txt
[ "$(wc -l < die.txt)" -gt 5 ] || fail "only $(wc -l < die.txt) steps"
cmp die.txt probe.txt || fail "the replay of a point has other stresses"

# So do those of any point of a die with friction, cell and path its own.
"$tamp" die cell.prm -o friction -q --no-plots --set 'Die/Elements = 1, 2' \
  --set 'Die/Wall friction coefficient = 0.2' --set 'Output/Grain points = 5'
"$tamp" probe cell.prm -o sample -q --no-plots --set 'Packing/Sample = 5' \
  --set 'Path/Stages = csv friction/grains/point_0005.csv'
columns friction/grains/point_0005.csv $stresses > die.txt
columns sample/curve.csv $stresses | tail -n +2 > probe.txt
[ "$(wc -l < die.txt)" -gt 5 ] || fail "only $(wc -l < die.txt) steps"
cut -d, -f1-6 die.txt | cmp - probe.txt ||
  fail "the replay of a point of many has other stresses"

# With the same packing everywhere and no friction the punch feels what one
# cell feels.
"$tamp" die cell.prm -o same -q --no-plots \
  --set 'Packing/Same at all points = true'
"$tamp" probe cell.prm -o cell -q --no-plots \
  --set 'Path/Stages = csv same/grains/point_0000.csv'
columns same/curve.csv 'upper_pressure[Pa]' | tail -n +2 > punch.txt
columns cell/curve.csv 'stress_zz[Pa]' | tail -n +2 > axial.txt
paste punch.txt axial.txt | awk '{
    off = ($1 - $2) / $2; if (off < 0) off = -off
    if (off > worst) worst = off }
  END { print NR " steps, largest relative difference " worst
    exit !(NR > 5 && worst <= 1e-10) }' ||
  fail "the punch pressure is not the stress of the cell"
echo "all well"
