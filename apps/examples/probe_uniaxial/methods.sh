#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Presses the cell of this example by 30 % with the quasi-static map, in
# increments of 1e-3 and 5e-3, and with damped dynamics at three strain rates,
# and prints the axial stress [MPa] over strain as a table.
# Usage: methods.sh [TAMP [FOLDER]]; results go to FOLDER, by default
# results/methods. Two runs at a time.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
tamp=${1:-$root/build/apps/tamp}
folder=${2:-$root/results/methods}
mkdir -p "$folder"

# run NAME INCREMENT SETTING...
run() {
  local name=$1 increment=$2
  shift 2
  local settings=(--set "Path/Stages = uniaxial to strain 0.357"
    --set "Path/Maximum strain increment = $increment")
  for setting in "$@"; do
    settings+=(--set "$setting")
  done
  "$tamp" probe "$here/probe_uniaxial.prm" -o "$folder/$name" --force -q \
    --no-plots --threads 1 "${settings[@]}"
}
moving="Cell/Method = dynamics"
{
  run dynamics_1e-4 1e-3 "$moving" "Cell/Strain rate = 1e-4 1/s"
} &
{
  run map_1e-3 1e-3
  run map_5e-3 5e-3
  run dynamics_3e-3 1e-3 "$moving" "Cell/Strain rate = 3e-3 1/s"
  run dynamics_5e-4 1e-3 "$moving" "Cell/Strain rate = 5e-4 1/s"
} &
wait

# column CURVE NAME: number of the column
column() {
  grep -v '^#' "$1" | head -n 1 | tr ',' '\n' | grep -nxF "$2" | cut -d: -f1
}
first=$folder/map_1e-3/curve.csv
strain=$(column "$first" 'strain_zz[-]')
stress=$(column "$first" 'stress_zz[Pa]')
sweeps=$(column "$first" 'sweeps[-]')
levels="0.02 0.05 0.1 0.15 0.2 0.25 0.3 0.357"
echo "| method | $(echo "$levels" | sed 's/ / | /g') | evaluations |"
echo "|---|$(echo "$levels" | sed 's/[^ ]* */---|/g')---|"
for name in map_1e-3 map_5e-3 dynamics_3e-3 dynamics_5e-4 dynamics_1e-4; do
  grep -v '^#' "$folder/$name/curve.csv" | awk -F, -v name="$name" \
    -v strain="$strain" -v stress="$stress" -v sweeps="$sweeps" \
    -v levels="$levels" '
    BEGIN { count = split(levels, level, " "); next_level = 1 }
    NR == 1 { next }
    {
      # Between two rows the stress is taken as linear.
      while (next_level <= count && $strain >= level[next_level] - 1e-9) {
        share = (level[next_level] - e) / ($strain - e)
        line = line sprintf(" %.3f |", (s + share * ($stress - s)) / 1e6)
        ++next_level
      }
      e = $strain; s = $stress; total += $sweeps
    }
    END { printf "| %s |%s %d |\n", name, line, total }'
done
