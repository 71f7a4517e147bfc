#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Takes two grains along the path of contact_load_unload.prm with every contact
# law, and draws normal force over overlap and tangential force over slip.
# Usage: run.sh [TAMP [FOLDER]]
# Results go to FOLDER, by default results/contact_load_unload.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tamp=${1:-$here/../../../build/apps/tamp}
folder=${2:-results/contact_load_unload}
mkdir -p "$folder"

# run NAME SETTING...
run() {
  local name=$1 settings=()
  shift
  for setting in "$@"; do
    settings+=(--set "$setting")
  done
  "$tamp" contact "$here/contact_load_unload.prm" -o "$folder/$name" --force \
    -q --no-plots "${settings[@]}"
}
plain="Contact/Work of adhesion = 0"
for law in hertz thornton-ning storakers mdr; do
  run "$law" "Contact/Normal law = $law" "$plain"
done
for law in jkr thornton-ning-jkr; do
  run "$law" "Contact/Normal law = $law"
done
for law in mindlin mindlin-deresiewicz; do
  run "$law" "Contact/Tangential law = $law" \
    "Contact/Normal law = thornton-ning" "$plain"
done

cd "$folder"
gnuplot << 'PLOT'
set terminal pngcairo size 1200,540 enhanced font "Sans,14"
set output "laws.png"
set datafile separator comma
set datafile columnheaders
set border 3 linewidth 1.5 linecolor rgb "#444444"
set tics nomirror out scale 0.6
set grid linecolor rgb "#dddddd" linetype 1 linewidth 1
set linetype 1 linecolor rgb "#0b6e99"
set linetype 2 linecolor rgb "#d1495b"
set linetype 3 linecolor rgb "#edae49"
set linetype 4 linecolor rgb "#3b8132"
set linetype 5 linecolor rgb "#7b4b94"
set linetype 6 linecolor rgb "#666666"
set key noenhanced left top Left reverse
set multiplot layout 1,2
set xlabel "overlap [nm]"
set ylabel "normal force [{/Symbol m}N]"
plot for [law in "hertz thornton-ning jkr thornton-ning-jkr storakers mdr"] \
  law."/curve.csv" using (column("overlap[m]") * 1e9):(column("normal_force[N]") * 1e6) with lines linewidth 2 title law
set xlabel "slip [nm]"
set ylabel "tangential force [{/Symbol m}N]"
plot for [law in "mindlin mindlin-deresiewicz"] \
  law."/curve.csv" using (column("slip_x[m]") * 1e9):(column("tangential_force_x[N]") * 1e6) with lines linewidth 2 title law
PLOT
echo "$folder/laws.png"
