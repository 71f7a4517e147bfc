#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Presses the cell of paper_fig01.prm by 10 % by dynamics, with the density of
# the grains scaled by 1e12 to 1e23, and draws the axial stress over the scaling
# number: Sheng et al. (2004), fig. 1.
# Usage: run.sh [TAMP [FOLDER]]
# Results go to FOLDER, by default results/paper_fig01: scaling.csv, scaling.png.
# SEED=N takes another packing; FORCE=1 overwrites what is there.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
tamp=${1:-$root/build/apps/tamp}
folder=${2:-$root/results/paper_fig01}
if [ -e "$folder" ] && [ -z "${FORCE:-}" ]; then
  echo "run.sh: '$folder' exists already; FORCE=1 overwrites it" >&2
  exit 2
fi
mkdir -p "$folder"
scalings=${SCALINGS:-"1e12 1e13 1e14 1e15 1e16 1e17 1e18 1e19 1e20 1e21 1e22
  1e23"}

# The strain of a time step is 0.09 times the scaling number times the fraction
# over 0.2: from a scaling number of about 1e-3 on, the fraction keeps it.
fraction() {
  awk -v s="$1" 'BEGIN { f = 0.2 * sqrt(4e17 / s); print f < 0.2 ? f : 0.2 }'
}

for scaling in $scalings; do
  "$tamp" probe "$here/paper_fig01.prm" -o "$folder/$scaling" --force -q \
    --no-plots --set "Packing/Seed = ${SEED:-7}" \
    --set "Cell/Density scaling = $scaling" \
    --set "Cell/Time step fraction = $(fraction "$scaling")"
done

# The first row that a run comes to beyond 1 %, and the last, at 10 %.
{
  echo "density_scaling[-],scaling_number[-],inertial_number[-],stress_1[Pa],stress_10[Pa]"
  for scaling in $scalings; do
    awk -F, -v scaling="$scaling" '
      /^#/ { next }
      !strain {
        for (k = 1; k <= NF; ++k) {
          if ($k == "strain_zz[-]") strain = k
          if ($k == "stress_zz[Pa]") stress = k
          if ($k == "scaling_number[-]") number = k
          if ($k == "inertial_number[-]") inertial = k
        }
        next
      }
      !early && $strain >= 0.01 - 1e-9 { early = $stress }
      { last = $stress; s = $number; i = $inertial }
      END { printf "%s,%s,%s,%s,%s\n", scaling, s, i, early, last }' \
      "$folder/$scaling/curve.csv"
  done
} > "$folder/scaling.csv"
cat "$folder/scaling.csv"

cd "$folder"
gnuplot <<'END'
set terminal pngcairo size 900,600 font ",14"
set output "scaling.png"
set datafile separator ","
set logscale xy
set format x "10^{%L}"
set xlabel "scaling number (strain rate^2 density R_{min}^2 / p_y)^{1/2}"
set ylabel "axial stress [MPa]"
set key top left
set grid
plot "scaling.csv" every ::1 using 2:($5/1e6) with linespoints pt 7 \
  title "at a strain of 10 %", \
  "scaling.csv" every ::1 using 2:($4/1e6) with linespoints pt 6 \
  title "at a strain of 1 %"
END
