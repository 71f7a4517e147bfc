#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Presses a cell of 1000 grains by 30 % with the quasi-static map, in increments
# of 1e-3 and 5e-3, and with damped dynamics at three strain rates, and prints
# the axial stress [MPa] over strain as a table.
# Usage: methods.sh [granules|table1 [TAMP [FOLDER]]]
#   granules  the grains of die_default, packed to 0.5 MPa (the default)
#   table1    the grains of this example, packed to 100 kPa
# Results go to FOLDER, by default results/methods. Two runs at a time.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
cell=${1:-granules}
tamp=${2:-$root/build/apps/tamp}
folder=${3:-$root/results/methods}/$cell
mkdir -p "$folder"
case $cell in
  granules) example=die_default rates="2e-4 5e-5 1e-5" ;;
  table1) example=probe_uniaxial rates="3e-3 5e-4 1e-4" ;;
  *) echo "methods.sh: '$cell': expected granules or table1" >&2; exit 2 ;;
esac
read -r fast middle slow <<< "$rates"

# run NAME INCREMENT SETTING...
run() {
  local name=$1 increment=$2
  shift 2
  local settings=(--set "Grains/Count = 1000"
    --set "Path/Stages = uniaxial to strain 0.357"
    --set "Path/Maximum strain increment = $increment")
  for setting in "$@"; do
    settings+=(--set "$setting")
  done
  "$tamp" probe "$root/apps/examples/$example/$example.prm" \
    -o "$folder/$name" --force -q --no-plots --threads 1 "${settings[@]}"
}
moving="Cell/Method = dynamics"
run "dynamics_$slow" 1e-3 "$moving" "Cell/Strain rate = $slow 1/s" &
{
  run map_1e-3 1e-3
  run map_5e-3 5e-3
  run "dynamics_$fast" 1e-3 "$moving" "Cell/Strain rate = $fast 1/s"
  run "dynamics_$middle" 1e-3 "$moving" "Cell/Strain rate = $middle 1/s"
} &
wait

levels="0.01 0.02 0.05 0.1 0.15 0.2 0.25 0.3 0.357"
echo "| method | ${levels// / | } | evaluations |"
echo "|---|$(for level in $levels; do printf -- '---|'; done)---|"
for name in map_1e-3 map_5e-3 "dynamics_$fast" "dynamics_$middle" \
  "dynamics_$slow"; do
  awk -F, -v name="$name" -v levels="$levels" '
    BEGIN { count = split(levels, level, " "); next_level = 1 }
    /^#/ { next }
    !strain {
      for (k = 1; k <= NF; ++k) {
        if ($k == "strain_zz[-]") strain = k
        if ($k == "stress_zz[Pa]") stress = k
        if ($k == "sweeps[-]") sweeps = k
      }
      next
    }
    {
      # Between two rows the stress is taken as linear.
      while (next_level <= count && $strain >= level[next_level] - 1e-9) {
        share = (level[next_level] - e) / ($strain - e)
        line = line sprintf(" %.3f |", (s + share * ($stress - s)) / 1e6)
        ++next_level
      }
      e = $strain; s = $stress; total += $sweeps
    }
    END { printf "| %s |%s %d |\n", name, line, total }' \
    "$folder/$name/curve.csv"
done
