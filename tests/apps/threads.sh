#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The number of threads changes the time a die takes and nothing else, and the
# forces on the powder balance. Usage: threads.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

cat > die.prm << 'END'
include granules_die.prm
subsection Schedule
  set Stages = press to density 0.61; unload to 50 % of peak
end
END

for threads in 1 2; do
  "$tamp" die die.prm -o "threads_$threads" -q --no-plots --threads "$threads"
  grep -v '^#' "threads_$threads/curve.csv" > curve.txt
  head -n 1 curve.txt | grep -q ',wall_time\[s\]$' || fail "the last column"
  sed 's/,[^,]*$//' curve.txt > "threads_$threads.txt"
done
cmp threads_1.txt threads_2.txt || fail "threads change the results"
cmp threads_1/grains/point_0000.csv threads_2/grains/point_0000.csv ||
  fail "threads change the path of a point"

# The first line is the compact as it was filled in, before any equilibrium.
tolerance=1e-3 # the default for unit cells
awk -F, -v tolerance="$tolerance" '
  function size(x) { return x < 0 ? -x : x }
  function larger(a, b) { return a > b ? a : b }
  NR == 1 { for (i = 1; i <= NF; ++i) place[$i] = i; next }
  $1 == 0 { next }
  { upper = $place["upper_force[N]"]; lower = $place["lower_force[N]"]
    wall = $place["wall_friction_force[N]"]
    normal = $place["wall_normal_force[N]"]
    tool = larger(larger(size(upper), size(lower)), size(normal))
    off = size(upper - lower - wall) / tool
    worst = larger(worst, off); ++steps }
  END { print steps " steps, worst force balance " worst
    exit !(steps > 3 && worst <= tolerance) }' curve.txt ||
  fail "the forces do not balance"
echo "all well"
