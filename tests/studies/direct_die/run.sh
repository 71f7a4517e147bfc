#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A die filled with some 3000 grains and pressed, grain by grain, by LAMMPS,
# against the same die of finite elements with cells of such grains, by tamp:
# pressures and forces against the strain since both bore 0.5 MPa, mean and
# standard deviation over seeds. Six minutes of one core.
#
#   [TAMP=PROGRAM] tests/studies/direct_die/run.sh [SEEDS [RATE]]
#
# RATE: of the direct die [1/s].
source "$(dirname "$0")/../common.sh"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
powder=$here/die.prm
seeds=${1:-3}
rate=${2:-40}
if ! command -v lmp > /dev/null; then
  echo "skipped: the direct die needs the package of Debian 12 that" \
    "'apt-get install --no-install-recommends lammps' installs"
  exit 0
fi

# The case; die.prm holds the same numbers.
radius=5e-3
way="0.62 mm"

# Lines "strain density upper/Pa lower/upper wall_normal/N wall_friction/N
# density_off_walls".
direct() { # SEED
  local log=$scratch/log.$1 means=$scratch/means.$1
  nice -n 10 lmp -log none -in "$here/die.lammps" -var seed "$1" \
    -var grains 3000 -var radius $radius -var filling 9.8e-3 \
    -var pressure 5e5 -var strain 0.11 -var rate "$rate" -var friction 0.35 \
    -var wall_friction 0.2 -var drag 3e-3 -var youngs 3.5e9 -var poisson 0.3 \
    -var thinnest 0.45e-3 -var thickest 0.65e-3 -var lines 110 \
    -var results "$means" > "$log" < /dev/null || {
    tail -n 5 "$log" >&2
    exit 1
  }
  awk '$1 == "height" { print $2 }' "$log" > "$scratch/height.$1"
  awk -v radius=$radius '
    NR == FNR { start = $1; next }
    /^#/ { next }
    {
      area = 4 * atan2(1, 1) * radius ^ 2
      print 1 - $2 / start, $3, -$4 / area, -$5 / $4, $6, $7, $8
    }' "$scratch/height.$1" "$means"
}

cells() { # SEED HEIGHT
  run die "cells_$1" "Packing/Seed = $1" "Die/Fill height = $2" \
    "Schedule/Stages = press to displacement $way"
  columns "$scratch/cells_$1/curve.csv" upper_displacement \
    mean_relative_density upper_pressure lower_force upper_force \
    wall_normal_force wall_friction_force |
    awk -v height="$2" '{ print $1 / height, $2, $3, $4 / $5, $6, $7, $2 }'
}

for seed in $(seq "$seeds"); do
  direct "$seed" > "$scratch/direct.$seed"
done
height=$(cat "$scratch"/height.* | awk '{ sum += $1 } END { print sum / NR }')
for seed in $(seq "$seeds"); do
  cells "$seed" "$height" > "$scratch/cells.$seed"
done
echo "Height at 0.5 MPa: $(sort "$scratch"/height.* | tr '\n' ' ')m," \
  "mean $height m"
echo
awk -f "$here/table.awk" "$scratch"/direct.* "$scratch"/cells.*
