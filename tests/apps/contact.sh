#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A pair of grains along a path and through an impact: the folder, the columns,
# closed forms, and wrong inputs. Usage: contact.sh TAMP
. "$(dirname "$(realpath "$0")")/expect.sh"

# column FILE NAME: all values of a column.
column() {
  awk -F, -v name="$2" '/^#/ { next }
    !place { for (k = 1; k <= NF; ++k) if ($k == name) place = k
      if (!place) exit 1
      next }
    { print $place }' "$1" || fail "$1 has no column $2"
}

cat > path.prm << 'EOF'
subsection Contact
  set Normal law = hertz
end
subsection Pair
  set First diameter  = 200 um
  set Second diameter = 300 um
  set Stages          = overlap to 2 um in 100; slip_x to 1 um in 50; \
                        overlap to 0 in 100 steps
end
EOF
"$tamp" contact path.prm -o path > said.txt
has path/{run.json,input.prm,log.txt,curve.csv,summary.txt}
grep -q '"status": "done"' path/run.json || fail "status"
grep -q '^step,overlap\[m\],slip_x\[m\],slip_y\[m\],normal_force\[N\],tangential_force_x\[N\],tangential_force_y\[N\],contact_radius\[m\],maximum_overlap\[m\],plastic\[-\],sliding\[-\]' \
  path/curve.csv || fail "header"
[ "$(column path/curve.csv step | tail -n 1)" -eq 250 ] || fail "steps"
if command -v gnuplot > /dev/null; then
  has path/plots/{force_overlap,force_slip}.{svg,png,gp}
fi
# Hertz: N = 4/3 E* sqrt(R*) overlap^1.5, all along; at 1 um of slip mu N.
column path/curve.csv 'overlap[m]' > overlap.txt
column path/curve.csv 'normal_force[N]' > force.txt
paste overlap.txt force.txt | awk 'BEGIN {
    modulus = 70e9 / (2 * (1 - 0.09)); radius = 1e-4 * 1.5e-4 / 2.5e-4 }
  { wanted = 4 / 3 * modulus * sqrt(radius) * $1 * sqrt($1)
    d = $2 - wanted
    if ((d < 0 ? -d : d) > 1e-9 * wanted) exit 1
    if (wanted > 0) ++compared }
  END { exit !(compared > 200) }' || fail "not the force of Hertz"
near "$(result path 'largest_tangential_force[N]')" \
  "$(awk '$1 > m { m = $1 } END { print 0.3 * m }' force.txt)" 1e-5
column path/curve.csv 'sliding[-]' | grep -q '^1' || fail "nothing slides"

# The echo is an input that gives the same run.
"$tamp" contact path/input.prm -o again -q --no-plots
cmp path/curve.csv again/curve.csv || fail "the echo gives another run"

# A sphere on a rigid wall: V2, V3 and the spin of V6.
impact=(--set 'Pair/Impact = true' --set 'Pair/Partner = rigid wall'
  --set "Grains/Young's modulus = 70 GPa" --set 'Grains/Density = 2699 kg/m3'
  --set 'Pair/First diameter = 200 mm' --set 'Pair/Normal speed = 0.2 m/s')
"$tamp" contact path.prm -o hit "${impact[@]}" --no-plots > said.txt
near "$(result hit 'largest_normal_force[N]')" 11370 2e-3
near "$(result hit 'largest_overlap[m]')" 49.717e-6 2e-3
near "$(result hit 'contact_time[s]')" 731.7e-6 2e-3
near "$(result hit 'restitution_normal[-]')" 1 1e-6
column hit/curve.csv 'time[s]' > time.txt
column hit/curve.csv 'velocity_z[m/s]' > velocity.txt
column hit/curve.csv 'spin_y[rad/s]' > spin.txt
grep -q 'restitution normal' hit/summary.txt || fail "no rebound in summary.txt"
"$tamp" contact path.prm -o spun "${impact[@]}" --no-plots -q \
  --set "Grains/Poisson's ratio = 0.33" --set 'Grains/Density = 2700 kg/m3' \
  --set 'Contact/Restitution coefficient = 0.5' \
  --set 'Contact/Friction coefficient = 0.4' --set 'Pair/Spin = 2 rad/s'
near "$(result spun 'restitution_normal[-]')" 0.5 1e-3
near "$(result spun 'rebound_spin[rad/s]')" 0.3946 2e-2
# Slow grains stick.
"$tamp" contact path.prm -o stuck -q --no-plots --set 'Pair/Impact = true' \
  --set 'Pair/Normal speed = 1 mm/s' --set 'Contact/Normal law = jkr' \
  --set 'Contact/Work of adhesion = 1 J/m2' 2> said.txt
near "$(result stuck 'sticks[-]')" 1 1e-12
# Without adhesion its laws say so, and are those without.
"$tamp" contact path.prm -o none --no-plots --set 'Contact/Normal law = jkr' \
  > said.txt 2>&1
grep -q 'Work of adhesion is 0' none/summary.txt || fail "no warning"

wrong() {
  local setting=$1
  shift
  expect 2 "$@" -- "$tamp" contact path.prm -o results --set "$setting"
}
wrong 'Pair/Stages = overlap to 2 um' 'Pair/Stages' 'stage 1' "'in'"
wrong 'Pair/Stages = overlp to 2 um in 5' "'overlp'" "'overlap'"
wrong 'Pair/Stages = overlap to 2 GPa in 5' "'2'" 'a length'
wrong 'Pair/Stages = spin to 2 um in 5' 'an angle'
wrong 'Pair/Stages = overlap to 2 mm in 5' 'twice the reduced radius'
wrong 'Pair/Stages = ' 'there is no stage'
wrong 'Pair/Partner = wal' "'wal'" 'wall'
wrong 'Contact/Work of adhesion = -1' '>= 0'
wrong 'Contact/Work of adhesion = 1 GPa' 'J/m2'
wrong 'Contact/Restitution coefficient = 1.5' '1.5' '<= 1'
wrong 'Pair/Angle = 90 deg' '90 deg' 'an angle'
expect 2 'Pair/Angle' 'Tangential speed' -- "$tamp" contact path.prm \
  -o results "${impact[@]}" --set 'Pair/Angle = 30 deg' \
  --set 'Pair/Tangential speed = 1 m/s'
expect 2 'Pair/Partner' 'mdr' -- "$tamp" contact path.prm -o results \
  --set 'Contact/Normal law = mdr' --set 'Pair/Partner = wall'
printf 'subsection Pair\n  set Stags = overlap to 1 um in 2\nend\n' > bad.prm
expect 2 'bad.prm:2' 'Stags' 'Stages' -- "$tamp" contact bad.prm -o results
[ ! -e results ] || fail "results were written"

echo "$failures failures"
[ "$failures" -eq 0 ]
