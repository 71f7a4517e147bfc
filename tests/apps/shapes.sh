#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# An example of a shape runs to its end on a coarse mesh, draws its pictures, and
# its compact leaves the die without a force. Usage: shapes.sh TAMP EXAMPLE
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
example=$2

"$tamp" examples copy "$example" .
has "$example"/{"$example.prm",README.md,density_map.png}
case $example in
  stepped) coarse="Solver/Maximum step = 1e-2" ;; # the mesh is a file
  square_die) coarse="Die/Elements = 3, 2" ;;
  *) coarse="Die/Elements = 4, 6" ;;
esac
"$tamp" die "$example/$example.prm" --set "$coarse" -o out --threads 1 -q ||
  fail "$example ended with $?"
grep -q '"status": "done"' out/run.json || fail "status"
if command -v gnuplot > /dev/null; then
  has out/plots/{compaction,density_map,forces}.{svg,png}
fi
# The section reaches from the lower to the upper punch and has a value
# everywhere.
awk '/^#/ || NF == 0 { next }
  NF != 3 || !($3 > 0 && $3 < 1.2) { exit 1 }
  !n++ || $2 < low { low = $2 } n == 1 || $2 > high { high = $2 }
  END { exit !(n > 0 && high - low > 2) }' out/plots/density_map.dat ||
  fail "density_map.dat is no section of some millimetres"
# The punch has pressed, and in the end no tool presses: less than 1e-6 of that.
awk -F, '/^#/ { next }
  !width { for (i = 1; i <= NF; ++i) column[$i] = i; width = NF; next }
  { upper = $column["upper_force[N]"]; lower = $column["lower_force[N]"]
    wall = $column["wall_normal_force[N]"] }
  upper > peak { peak = upper }
  END { small = 1e-6 * peak; exit !(peak > 100 && upper < small &&
    lower * lower < small * small && wall * wall < small * small) }' \
  out/curve.csv || fail "the compact is not free at the end"
echo "all well"
