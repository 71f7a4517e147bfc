#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# How much a cell's stress depends on the increments it is taken along, and on
# how well it is balanced: uniaxial strain of 0.2, several packings of 200
# grains. A minute or two.
#
#   [TAMP=PROGRAM] tests/studies/cell_increments.sh [SEEDS [VARIANTS]]
#
# A variant is INCREMENT/UNBALANCE; "1e-4/1e-3 1e-5/1e-3" is what explicit
# dynamics of a die would take.
#
# The reference of a packing is its answer with the smallest increments and the
# sharpest balance. Bias: mean difference from it over seeds; noise: the
# standard deviation of these differences.
source "$(dirname "$0")/common.sh"
seeds=${1:-10}

# path NAME SEED INCREMENT TOLERANCE [SETTING...]
path() {
  local name=$1 seed=$2 increment=$3 tolerance=$4
  shift 4
  run probe "$name" "Packing/Seed = $seed" \
    "Path/Stages = uniaxial to strain 0.2" \
    "Path/Maximum strain increment = $increment" \
    "Cell/Maximum strain increment = $increment" \
    "Cell/Unbalance tolerance = $tolerance" \
    "Cell/Maximum evaluations = 30000" "$@"
}

# Lines: strain, axial stress, evaluations so far, at the strains looked at.
answers() {
  columns "$scratch/$1/curve.csv" strain_zz stress_zz sweeps | awk '
    { sweeps += $3 }
    ($1 > 0.04 - 1e-6 && $1 < 0.04 + 1e-6) ||
    ($1 > 0.1 - 1e-6 && $1 < 0.1 + 1e-6) ||
    ($1 > 0.2 - 1e-6 && $1 < 0.2 + 1e-6) { printf "%.2f %s %s\n", $1, $2, sweeps }'
}

variants=${2:-"2e-2/1e-3 1e-2/1e-3 5e-3/1e-3 2e-3/1e-3 1e-3/1e-3 5e-4/1e-3 \
  2e-4/1e-3 5e-3/1e-2 1e-3/1e-2 5e-3/1e-4 1e-3/1e-4"}
for seed in $(seq "$seeds"); do
  path "reference_$seed" "$seed" 2e-4 1e-4
  for variant in $variants; do
    name=$variant-$seed
    path "${name/\//_}" "$seed" "${variant%/*}" "${variant#*/}"
    paste -d ' ' <(answers "${name/\//_}") <(answers "reference_$seed") |
      sed "s|^|$variant |"
  done
done > "$scratch/values"

echo "| increment | unbalance | strain | bias % | ± | noise % |" \
  "evaluations |"
echo "|---|---|---|---|---|---|---|"
for variant in $variants; do
  grep "^$variant " "$scratch/values"
done | awk '
  { key = $1 " " $2
    if (!(key in n)) order[++keys] = key
    difference = 100 * ($3 / $6 - 1)
    ++n[key]; sum[key] += difference; of2[key] += difference ^ 2
    evaluations[key] += $4 }
  END {
    for (i = 1; i <= keys; ++i) {
      key = order[i]
      split(key, part, /[ \/]/)
      mean = sum[key] / n[key]
      square = n[key] > 1 ? (of2[key] - n[key] * mean ^ 2) / (n[key] - 1) : 0
      noise = square > 0 ? sqrt(square) : 0
      printf "| %s | %s | %s | %+.2f | %.2f | %.2f | %.0f |\n", part[1],
        part[2], part[3], mean, noise / sqrt(n[key]), noise,
        evaluations[key] / n[key]
    }
  }'
