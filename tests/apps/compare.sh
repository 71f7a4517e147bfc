#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs laid side by side: what must vanish does, closed forms are met, what
# cannot be compared is said. Usage: compare.sh TAMP dies|materials|probes|refused|damaged
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"
part=$2

cat > die.prm << 'END'
subsection Material
  set Type = drucker-prager cap
end
subsection Die
  set Elements = 3, 4
  set Wall friction coefficient = 0.1
end
subsection Schedule
  set Stages = press to density 0.5; unload to 5 % of peak; \
               eject by 0.2 mm holding 5 % of peak
end
subsection Solver
  set Maximum step = 4e-2
end
subsection Output
  set Field interval = 3
end
END
die() { "$tamp" die die.prm -q --no-plots --threads 1 -o "$@"; }
compare() {
  "$tamp" compare "$@" > said.txt 2> err.txt || fail "compare $*: $(cat err.txt)"
}
# value FOLDER QUANTITY COLUMN: of compare.csv; fails if it is not there.
value() {
  awk -F, -v row="$2" -v name="$3" '/^#/ { next }
    !place { for (k = 1; k <= NF; ++k) if ($k == name) place = k
      if (!place) exit 1
      next }
    $1 == row { print $place; found = 1 }
    END { exit !found }' "$1/compare.csv" || fail "$1: no '$2' of $3"
}
# holds CONDITION VALUE...: an awk condition of a, b, c.
holds() {
  awk -v a="$2" -v b="${3:-0}" -v c="${4:-0}" "BEGIN { exit !($1) }" ||
    fail "not $1 for ${*:2}"
}
# says FILE TEXT...
says() {
  local file=$1
  shift
  for text in "$@"; do
    grep -qF -- "$text" "$file" || fail "$file lacks '$text'"
  done
}
over='upper_pressure[Pa] over mean_relative_density[-] in stage 1 (press)'
norm="$over: relative_L2_difference[-]"

if [ "$part" = dies ]; then
  die slick
  die rough --set 'Die/Wall friction coefficient = 0.3'
  cp -r slick twin
  die fine --set 'Die/Elements = 4, 6'
  compare slick twin rough fine -o out
  has out/{compare.csv,difference.vtu,summary.txt,run.json,log.txt}
  has out/plots/curve_{1,2,3,4}.csv
  grep -q '"status": "done"' out/run.json || fail status
  # What is equal has no difference, in no quantity and to the bit.
  awk -F, '/^#/ { next }
    !place { for (k = 1; k <= NF; ++k) if ($k == "twin_difference") place = k
      next }
    $place != "nan" { ++known; if ($place != 0) { print; wrong = 1 } }
    END { exit wrong || known < 100 }' out/compare.csv || fail 'the twin differs'
  # Friction lets less of the force through and costs ejection force.
  holds 'a < 0' "$(value out 'transmission_at_peak[-]' rough_difference)"
  holds 'a > 20' "$(value out 'peak_ejection_force[N]' 'rough_difference[%]')"
  # The table has the numbers of the runs.
  peak=$(sed -n 's|^ *"peak_upper_force\[N\]": \(.*\),$|\1|p' rough/run.json)
  holds 'a == b' "$(value out 'peak_upper_force[N]' rough)" "$peak"
  # At one mean density dies of one fill differ by nothing but quadrature, of
  # second order in the elements: 1e-3 of the solid volume of 250 mm3.
  for run in rough fine; do
    for when in pressed end; do
      holds 'a < 1e-3 * b && -a < 1e-3 * b' \
        "$(value out "${when}_solid_volume_difference_of_maps[m3]" $run)" \
        "$(value out "${when}_solid_volume[m3]" slick)"
      holds 'a == 0' "$(value out "${when}_points_outside[-]" $run)"
    done
  done
  # One die on another mesh is nearer than one with another friction.
  field='pressed_relative_density_difference_root_mean_square[-]'
  holds 'a > 0 && 2 * a < b' "$(value out "$field" fine)" \
    "$(value out "$field" rough)"
  says out/summary.txt 'point for point' 'resampled' 'end of stage 1 (press)' \
    'the last common state' 'stage 3, eject: lower force over travel'
  if command -v gnuplot > /dev/null; then
    for plot in compaction pressure_displacement wall_pressure wall_friction \
      density_range ejection density_difference_{pressed,end}_{3,4} \
      axial_stress_difference_end_3; do
      has out/plots/$plot.{gp,svg,png}
    done
    [ ! -e out/plots/density_difference_end_2.gp ] ||
      fail 'a map of no difference'
    ! grep -sv 'degree sign' out/plots/gnuplot.log || fail 'gnuplot complains'
  fi
  # Again with --force, the same to the byte but for times.
  cp out/compare.csv first.csv
  cp out/difference.vtu first.vtu
  compare slick twin rough fine -o out --force --no-plots
  cmp -s first.csv out/compare.csv || fail 'the table differs'
  cmp -s first.vtu out/difference.vtu || fail 'the fields differ'
  [ ! -e out/plots ] || fail 'plots of the run before stay'
fi

if [ "$part" = materials ]; then
  # Unit cells, a law on another mesh, and a run that did not get as far.
  sed 's/drucker-prager cap/unit cell/; s/^$//' die.prm > cells.prm
  echo 'include granules.prm' >> cells.prm
  short=(--set 'Schedule/Stages = press to density 0.63')
  "$tamp" die cells.prm -q --no-plots -o cells "${short[@]}" \
    --set 'Die/Elements = 1, 2'
  law='Material/Drucker-Prager cap/Initial relative density'
  start=$(sed -n 's|^ *"start_relative_density\[-\]": \(.*\),$|\1|p' cells/run.json)
  die law "${short[@]}" --set "$law = $start" --set 'Die/Elements = 2, 2'
  compare cells law -o out --no-plots --names 'FE2,a law'
  says out/summary.txt 'FE2 (the reference)' 'a law less FE2, resampled'
  holds 'a > 0' "$(value out "$norm" 'a law')"
  # Equal fill, equal density: 60 grains meet it to a per cent, quadrature to
  # less.
  holds 'a < 0.01 * b && -a < 0.01 * b' \
    "$(value out 'pressed_solid_volume_difference_of_maps[m3]' 'a law')" \
    "$(value out 'pressed_solid_volume[m3]' FE2)"
  # Half-way: the nearest state that both have written, and it is said.
  die whole
  status=0
  die stopped --set \
    'Schedule/Stages = press to density 0.45; unload to force 9 kN' 2> err.txt || status=$?
  [ "$status" -eq 3 ] || fail "stopped: exit code $status"
  compare whole stopped -o half --no-plots
  says half/summary.txt 'warning: stopped did not finish' 'not converged' \
    'stages are of one kind'
  holds 'a < 0.46' "$(value half "$over: to[-]" stopped)"
  # Without fields the rest is compared.
  cp -r whole bare
  rm -r bare/fields bare/fields.pvd
  compare whole bare -o curves --no-plots
  says curves/summary.txt 'warning: bare has no fields.pvd'
  [ ! -e curves/difference.vtu ] || fail 'fields that are not there'
  holds 'a == 0' "$(value curves "$norm" bare)"
fi

if [ "$part" = probes ]; then
  # Hertz: at equal overlap the force is proportional to the modulus.
  cat > pair.prm << 'END'
subsection Contact
  set Normal law = hertz
end
subsection Pair
  set First diameter  = 200 um
  set Second diameter = 300 um
  set Stages          = overlap to 2 um in 100; overlap to 0 in 60
end
END
  "$tamp" contact pair.prm -q --no-plots -o soft \
    --set "Grains/Young's modulus = 2 GPa"
  "$tamp" contact pair.prm -q --no-plots -o stiff \
    --set "Grains/Young's modulus = 2.4 GPa"
  compare soft stiff -o pairs
  name='normal_force[N] over overlap[m] in stage'
  for stage in '1 (overlap)' '2 (overlap)'; do
    # Sums of a hundred numbers: rounding.
    for what in relative_L2_difference largest_difference_over_largest_value; do
      holds 'a > 0.2 - 1e-12 && a < 0.2 + 1e-12' \
        "$(value pairs "$name $stage: $what[-]" stiff)"
    done
  done
  cat > probe.prm << 'END'
include granules.prm
subsection Path
  set Stages = uniaxial to strain 0.02; unload to 10 % of peak
end
END
  "$tamp" probe probe.prm -q --no-plots -o cell \
    --set 'Material/Type = unit cell'
  "$tamp" probe probe.prm -q --no-plots -o law \
    --set 'Material/Type = drucker-prager cap'
  compare cell law -o probes
  says probes/summary.txt 'stage 1, uniaxial: stress zz over strain zz' \
    'stage 2, unload' 'relative density over pressure'
  grep -q 'coordination_number' probes/compare.csv &&
    fail 'a law has no coordination number'
  if command -v gnuplot > /dev/null; then
    has probes/plots/{stress_strain,lateral_stress,density_pressure,stress_path}.svg
    has probes/plots/coordination.svg pairs/plots/force_overlap.svg
    ! grep -sv 'degree sign' p*s/plots/gnuplot.log || fail 'gnuplot complains'
  fi
  "$tamp" pack probe.prm -q --no-plots -o loose
  "$tamp" pack probe.prm -q --no-plots -o dense --set 'Packing/Pressure = 1 MPa'
  compare loose dense -o packs --no-plots
  says packs/summary.txt '2 runs of tamp pack'
fi

if [ "$part" = refused ]; then
  die one --set 'Schedule/Stages = press to density 0.4'
  cp -r one two
  expect 2 'one' 'at least two' -- "$tamp" compare one -o out
  expect 2 'FOLDER' -- "$tamp" compare -o out
  expect 2 "'none'" 'no folder' -- "$tamp" compare one none -o out
  mkdir empty
  expect 2 "'empty'" 'run.json' -- "$tamp" compare one empty -o out
  expect 2 "'die.prm'" 'no folder' -- "$tamp" compare one die.prm -o out
  printf 'subsection Material\n  set Type = elastic\nend\n' > probe.prm
  "$tamp" probe probe.prm -q --no-plots -o probe \
    --set 'Path/Stages = uniaxial to strain 0.01'
  expect 2 'tamp die' 'tamp probe' 'one command' -- \
    "$tamp" compare one probe -o out
  "$tamp" compare one two -o done -q --no-plots
  expect 2 "'done'" 'tamp compare' 'contact, die, pack or probe' -- \
    "$tamp" compare done one -o out
  expect 2 '--names' '2 names' 'found 1' -- \
    "$tamp" compare one two -o out --names a
  expect 2 '--names' "'a'" 'differ' -- "$tamp" compare one two -o out --names a,a
  expect 2 '--names' 'quotes' -- "$tamp" compare one two -o out --names 'a,b"'
  expect 2 "'done'" '--force' -- "$tamp" compare one two -o done
  # The folders that are compared are never touched.
  find one two -type f -exec sha1sum {} + | sort > before.txt
  expect 2 'would remove' 'one' -- "$tamp" compare one two -o one --force
  find one two -type f -exec sha1sum {} + | sort | cmp -s - before.txt ||
    fail 'a run was changed'
fi

if [ "$part" = damaged ]; then
  # Damage is named, with its line where it has one.
  die one --set 'Schedule/Stages = press to density 0.36'
  cp -r one two
  head -c -40 one/curve.csv > two/curve.csv
  lines=$(grep -c . two/curve.csv)
  expect 2 "two/curve.csv:$lines" 'expected' -- "$tamp" compare one two -o out
  rm two/curve.csv
  expect 2 "'two'" 'no curve.csv' -- "$tamp" compare one two -o out
  sed '/^step,/d' one/curve.csv > two/curve.csv
  expect 2 'two/curve.csv:3' 'header' -- "$tamp" compare one two -o out
  sed 's/wall_pressure/pressure/' one/curve.csv > two/curve.csv
  "$tamp" compare one two -o lacking -q --no-plots ||
    fail 'a column that is not needed'
  sed 's/upper_displacement/displacement/' one/curve.csv > two/curve.csv
  expect 2 'two/curve.csv' 'upper_displacement[m]' -- \
    "$tamp" compare one two -o out
  cp one/curve.csv two
  file=$(basename "$(ls two/fields/*.vtu | tail -n 1)")
  head -c 3000 one/fields/$file > two/fields/$file
  expect 2 "$file" 'damaged' -- "$tamp" compare one two -o out
  rm "two/fields/$file"
  expect 2 "$file" 'missing' -- "$tamp" compare one two -o out
  cp one/fields/$file two/fields
  sed 's/"status"/"state"/' one/run.json > two/run.json
  expect 2 'two/run.json' 'status' -- "$tamp" compare one two -o out
  # A half section and three dimensions.
  "$tamp" die die.prm -q --no-plots -o whole --set 'Die/Symmetry = quarter' \
    --set 'Die/Elements = 2, 2' --set 'Schedule/Stages = press to density 0.36'
  cp one/run.json two
  expect 2 'half section' -- "$tamp" compare one whole -o out
  [ ! -e out ] || fail 'something was written'
fi
[ "$failures" -eq 0 ] || fail "$failures messages"
echo "all well"
