#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# An example of unit cells in three dimensions is pressed, unloaded and ejected
# on a coarse mesh of small cells; its forces balance, and it is the same on two
# ranks, to the bit. Usage: cell_shapes.sh TAMP EXAMPLE
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
example=$2
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

"$tamp" examples copy "$example" .
has "$example"/{"$example.prm",README.md,density_map.png}

# on FOLDER COMMAND...: the example, coarse, with one packing for all points.
on() {
  local folder=$1
  shift
  "$@" die "$example/$example.prm" -o "$folder" --threads 1 -q --no-plots \
    --set "Die/Elements = 2, 1" --set "Grains/Count = 100" \
    --set "Packing/Same at all points = true" \
    --set "Schedule/Stages = press to density 0.64; unload to 20 % of peak;
      eject by 0.05 mm holding 20 % of peak" 2> err.txt ||
    { cat err.txt; fail "$example does not end well as $folder"; }
}
on on_1 "$tamp"
grep -q '"status": "done"' on_1/run.json || fail "status"

# After the start punches and wall balance along the axis. Nodes balance to 1e-3
# of the reactions, which count as 10 % of the peak at least; a sum over the 18
# nodes may be off by sqrt(18) times as much. The wall takes a part of it.
# The punch goes back to 20 % of its peak and keeps that, to a hundredth of it.
awk -F, '/^#/ { next }
  !width { for (i = 1; i <= NF; ++i) column[$i] = i; width = NF; next }
  { upper = $column["upper_force[N]"]; lower = $column["lower_force[N]"]
    friction = $column["wall_friction_force[N]"]; ++lines
    if (upper > peak) { peak = upper; transmitted = lower }
    scale = upper > lower ? upper : lower
    if (scale < 0.1 * peak) scale = 0.1 * peak
    off = upper - lower - friction
    if ($column["step"] > 0 && off * off > (4.3e-3 * scale)^2) unbalanced = $0 }
  END { exit !(!unbalanced && lines > 20 && peak > 100 &&
    transmitted < 0.99 * peak && transmitted > 0.5 * peak &&
    upper > 0.198 * peak && upper < 0.202 * peak && lower > upper) }' \
  on_1/curve.csv ||
  fail "the forces are not those of a compact in its die"

# Released, it is higher than at the peak and still presses on the wall.
for name in "axial_spring_back\\[m\\]" \
  "residual_wall_pressure_after_unloading\\[Pa\\]"; do
  value=$(sed -n "s/^ *\"$name\": \([^,]*\),*$/\1/p" on_1/run.json)
  awk -v x="$value" 'BEGIN { exit !(x > 0) }' || fail "$name is not above 0"
done

on on_2 mpirun -np 2 "$tamp"
for ranks in 1 2; do # all but the last column, the wall time
  grep -v '^#' "on_$ranks/curve.csv" | sed 's/,[^,]*$//' > "curve_$ranks.txt"
done
cmp curve_1.txt curve_2.txt || fail "another curve on two ranks"
for field in on_1/fields/*; do
  cmp "$field" "on_2/fields/${field##*/}" || fail "$field differs on two ranks"
done
echo "all well"
