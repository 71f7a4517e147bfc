#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# How much a cell's stress depends on the rate at which damped dynamics strains
# it: uniaxial strain of 0.02, several packings of 200 grains. Two minutes.
#
#   [TAMP=PROGRAM] tests/studies/cell_rate.sh [SEEDS]
#
# Error: mean over seeds of the stress against what the two slowest rates
# extrapolate to rate zero, if the error is of first order; and the map's.
source "$(dirname "$0")/common.sh"
seeds=${1:-10}
rates="1e-3 5e-4 2e-4 1e-4 5e-5 2e-5 1e-5 5e-6 2.5e-6"

# stress NAME SEED SETTING...: axial stress at the end and sweeps per cell.
stress() {
  local name=$1 seed=$2
  shift 2
  run probe "$name" "Packing/Seed = $seed" \
    "Path/Stages = uniaxial to strain 0.02" "$@"
  columns "$scratch/$name/curve.csv" stress_zz sweeps |
    awk '{ stress = $1; sweeps += $2 } END { print stress, sweeps }'
}

for seed in $(seq "$seeds"); do
  for rate in $rates; do
    echo "$seed $rate $(stress "rate_${rate}_$seed" "$seed" \
      "Cell/Method = dynamics" "Cell/Strain rate = $rate")"
  done
  echo "$seed map $(stress "map_$seed" "$seed" "Cell/Method = quasi-static")"
done > "$scratch/values"

echo "| rate 1/s | strain per step | error % | ± | noise % |" \
  "error / strain per step |"
echo "|---|---|---|---|---|---|"
awk -v rates="$rates map" '
  { stress[$1, $2] = $3; sweeps[$2] = $4; if ($1 > seeds) seeds = $1 }
  END {
    count = split(rates, rate, " ")
    slow = rate[count - 1]
    slower = rate[count - 2]
    for (k = 1; k <= count; ++k) {
      sum = of2 = 0
      for (s = 1; s <= seeds; ++s) {
        limit = stress[s, slow] - (stress[s, slower] - stress[s, slow]) \
          * slow / (slower - slow)
        error = stress[s, rate[k]] / limit - 1
        sum += error
        of2 += error ^ 2
      }
      mean = sum / seeds
      square = seeds > 1 ? (of2 - seeds * mean ^ 2) / (seeds - 1) : 0
      noise = square > 0 ? sqrt(square) : 0
      step = 0.02 / sweeps[rate[k]]
      if (rate[k] == "map")
        printf "| map | - | %+.2f | %.2f | %.2f | - |\n", 100 * mean,
          100 * noise / sqrt(seeds), 100 * noise
      else
        printf "| %s | %.1e | %+.2f | %.2f | %.2f | %.0f |\n", rate[k], step,
          100 * mean, 100 * noise / sqrt(seeds), 100 * noise, mean / step
    }
  }' "$scratch/values"
