#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From the runs of run.sh: states, figures, trends, comparison, page. Needs
# packings, frictions and limits from run.sh.
# Usage: evaluate.sh FOLDER
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$1"
mkdir -p data

# Where states are compared, and where curves are drawn.
wanted="loading start 0;unloading peak 1"
for strain in 0.01 0.05 0.1 0.15; do
  wanted+=";loading strain $strain"
done
for stress in 1e7 2e7 3e7; do
  wanted+=";loading axial $stress"
done
for density in 0.6 0.7 0.8; do
  wanted+=";loading density $density"
done
for share in 0.01 0.02 0.1 0.25 0.5; do
  wanted+=";loading share $share"
done
for share in 0.5 0.1 0.02; do
  wanted+=";unloading share $share"
done
# numbers FIRST LAST STEP
numbers() {
  awk -v a="$1" -v b="$2" -v s="$3" \
    'BEGIN { for (x = a; (x - b) / s < 0.5; x += s) print x }'
}
grid="loading start 0"
for share in 0.0001 0.0002 0.0005 0.001 0.002 0.005 0.01 0.015 \
  $(numbers 0.02 0.98 0.02); do
  grid+=";loading share $share"
done
grid+=";unloading peak 1"
for share in $(numbers 0.96 0.04 -0.04) 0.02; do
  grid+=";unloading share $share"
done

# In the order of the names, whatever the order of the runs.
for folder in runs/*; do
  [ -s "$folder/curve.csv" ] || continue
  name=${folder#runs/}
  [ "$name" != square_die ] || continue
  for table in states grid; do
    [ "$table" = states ] && places=$wanted || places=$grid
    awk -v run="${name%_[0-9]}" -v packing="${name##*_}" -v wanted="$places" \
      -f "$here/states.awk" "$folder/curve.csv" >> "$table.csv"
  done
done
for folder in runs/scaling_?; do
  [ -s "$folder/scaling.csv" ] || continue
  sed 1d "$folder/scaling.csv" > "data/${folder#runs/}.csv"
done

# band FIGURE X Y ACROSS RUN...
band() {
  local figure=$1 x=$2 y=$3 across=$4
  shift 4
  for run in "$@"; do
    awk -v run="$run" -v x="$x" -v y="$y" -v across="$across" \
      -f "$here/band.awk" grid.csv > "data/${figure}_$run.dat"
  done
}
# of_die VALUE: of the die, over the pressure of its punch, as band does, with a
# polygon that is there and back; VALUE in the language of awk.
of_die() {
  awk -F, '/^#/ { next }
    !width { for (k = 1; k <= NF; ++k) column[$k] = k; width = NF; next }
    { density = column["mean_relative_density[-]"]
      line = $column["upper_pressure[Pa]"] " " ('"$1"') "\n"
      all = all line
      back = line back }
    END { printf "%s%s\n\n%s", all, back, all }' runs/square_die/curve.csv
}

of_friction=()
for friction in $frictions; do
  of_friction+=("mu$friction")
done
of_limit=(mu0.3 py1)
of_granules=()
for limit in $limits; do
  of_granules+=("granules$limit")
done
[ -d runs/square_die ] && of_granules+=(granules_mdr)
of_cells="${of_granules[*]}"
band fig02 strain axial x "${of_friction[@]}"
band fig03 axial lateral y "${of_friction[@]}"
band fig04 strain axial x "${of_limit[@]}"
band fig05 axial lateral y "${of_limit[@]}"
band fig06 strain Zm y "${of_friction[@]}"
band fig07 strain Zm y "${of_limit[@]}"
band fig08 strain plastic y "${of_friction[@]}"
band fig09 strain plastic y "${of_limit[@]}"
band fig10 axial void y "${of_granules[@]}"
band fig11 axial density y "${of_granules[@]}"
band fig12 axial Zm y "${of_granules[@]}"
if [ -s runs/square_die/curve.csv ]; then
  of_granules+=(die)
  of_die '1 / $density - 1' > data/fig10_die.dat
  of_die '$density' > data/fig11_die.dat
fi
if command -v gnuplot > /dev/null; then
  gnuplot -e "of_friction='${of_friction[*]}'; of_limit='${of_limit[*]}'; \
    of_granules='${of_granules[*]}'; of_cells='$of_cells'; \
    packings='$packings'" "$here/figures.gp"
else
  echo "evaluate.sh: gnuplot is missing; no figures were drawn" >&2
fi

awk -v packings="$packings" -v frictions="$frictions" -v limits="$limits" \
  -f "$here/trends.awk" states.csv $(ls data/scaling_?.csv 2> /dev/null) \
  > trends.csv
awk -v packings="$packings" -f "$here/reference.awk" states.csv \
  "$here/reference.csv" "$here/reference.csv" > reference.csv
bash "$here/page.sh" > paper.md
cat trends.csv
echo "The page is $PWD/paper.md"
