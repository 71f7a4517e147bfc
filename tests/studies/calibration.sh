#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Recovers p_y = 80 MPa and mu = 0.4 from synthetic curves of three seeds (of
# noise and of packing), with and without lateral pressure, and prints a table.
# Usage: calibration.sh [TAMP [FOLDER]]
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tamp=${1:-$root/build/apps/tamp}
folder=${2:-$root/results/calibration}
example=$root/apps/examples/calibrate_granules
mkdir -p "$folder"

# result RUN NAME: a key result, whatever its unit.
result() {
  sed -n "s|^ *\"$2\[[^]]*\]\": \([^,]*\),*\$|\1|p" "$1/run.json"
}

# row RUN: the values with their 95 % intervals, and what they took.
row() {
  local entry line=''
  for entry in 'Contact/Limiting contact pressure' \
    'Contact/Friction coefficient'; do
    line+=$(awk -v best="$(result "$1" "$entry best")" \
      -v from="$(result "$1" "$entry 95 % from")" \
      -v to="$(result "$1" "$entry 95 % to")" 'BEGIN {
        unit = best > 1e5 ? 1e6 : 1
        printf " %.4g | %.4g to %.4g |", best / unit, from / unit, to / unit }')
  done
  awk -v seed="$2" -v lateral="$3" -v line="$line" \
    -v misfit="$(result "$1" misfit)" -v runs="$(result "$1" runs)" 'BEGIN {
      printf "| %s | %s |%s %.1f %% | %.0f |\n", seed, lateral, line,
        100 * misfit, runs }'
}

echo '| seed | lateral | p_y [MPa] | 95 % | mu | 95 % | misfit | runs |'
echo '|---|---|---|---|---|---|---|---|'
for seed in 1 2 3; do
  data=$folder/data_$seed.csv
  "$example/make_data.sh" "$tamp" "$seed" "$data"
  sed '/^#/d' "$data" | cut -d, -f1,2 > "$folder/axial_$seed.csv"
  for lateral in yes no; do
    run=$folder/fit_${seed}_$lateral
    [ $lateral = yes ] || data=$folder/axial_$seed.csv
    "$tamp" calibrate "$example/calibrate_granules.prm" --data "$data" \
      --fit 'Contact/Limiting contact pressure = 10 MPa .. 300 MPa' \
      --fit 'Contact/Friction coefficient = 0.1 .. 0.9' \
      -o "$run" --force -q --no-plots
    row "$run" "$seed" "$lateral"
  done
done
