#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes measured.csv: no measurement, but a simulation with known values (p_y =
# 80 MPa, mu = 0.4) and 1000 other grains, whose pressures have 2 % of noise.
# Usage: make_data.sh TAMP [SEED [FILE]]: seed of the noise and of the packing.
set -euo pipefail
export LC_ALL=C

tamp=$1
seed=${2:-1}
here=$(dirname "${BASH_SOURCE[0]}")
file=${3:-$here/measured.csv}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$tamp" probe "$here/calibrate_granules.prm" -o "$work/truth" -q --no-plots \
  --set 'Grains/Count = 1000' --set "Packing/Seed = $((100 + seed))" \
  --set 'Contact/Limiting contact pressure = 80 MPa' \
  --set 'Contact/Friction coefficient = 0.4' \
  --set 'Path/Stages = uniaxial to strain 0.3; unload to 5 % of peak'
awk -F, -v seed="$seed" '
  function normal() {
    return sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand())
  }
  BEGIN {
    srand(seed)
    print "# Synthetic: p_y = 80 MPa, mu = 0.4, noise of pressures 2 %."
    print "relative_density[-],pressure[MPa],lateral_pressure[MPa]"
  }
  /^#/ { next }
  /^step/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  {
    axial = $column["stress_zz[Pa]"]
    lateral = ($column["stress_xx[Pa]"] + $column["stress_yy[Pa]"]) / 2
    printf "%.5f,%.4g,%.4g\n", $column["relative_density[-]"],
      axial / 1e6 * (1 + 0.02 * normal()), lateral / 1e6 * (1 + 0.02 * normal())
  }' "$work/truth/curve.csv" > "$file"
