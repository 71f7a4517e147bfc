#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From grains to curves, from curves to continuum laws, and all in the same die:
# probes of unit cells, three laws fitted to them, one of them twice, five dies,
# one comparison.
# Usage: run.sh [TAMP [FOLDER]]
#   COARSE=1  a quick look: few grains, few elements
#   FORCE=1   overwrite what is in FOLDER, by default results/die_compare
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tamp=$(realpath "${1:-$here/../../../build/apps/tamp}")
folder=${2:-results/die_compare}
if [ -e "$folder" ] && [ -z "${FORCE:-}" ]; then
  echo "run.sh: '$folder' exists already; FORCE=1 overwrites it" >&2
  exit 2
fi
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
probe=() die=() cells=() replicas=3
if [ -n "${COARSE:-}" ]; then
  replicas=2
  probe=(--set "Grains/Count = 120"
    --set "Scan/Densities = 0.62, 0.66, 0.72, 0.78, 0.84, 0.9")
  die=(--set "Die/Elements = 2, 3" --set "Solver/Maximum step = 0.01")
  cells=(--set "Grains/Count = 80")
fi

"$tamp" probe "$here/probe.prm" --replicas "$replicas" "${probe[@]}" --force \
  -o "$folder/probe"
"$tamp" die "$here/die_cells.prm" "${die[@]}" "${cells[@]}" --force \
  -o "$folder/cells"

# press NAME LAW [OPTIONS]: fits a law, and presses the die with it as it is.
press() {
  "$tamp" fit "$folder/probe" --law "${@:2}" --force -o "$folder/fit_$1"
  { cat "$here/die.prm"; echo; cat "$folder/fit_$1/law.prm"; } \
    > "$folder/$1.prm"
  "$tamp" die "$folder/$1.prm" "${die[@]}" --force -o "$folder/$1"
}
press cap drucker-prager-cap
press soft_cap drucker-prager-cap --moduli unloading
press cam_clay modified-cam-clay
press fkm_gurson fkm-gurson
"$tamp" compare "$folder"/{cells,cap,soft_cap,cam_clay,fkm_gurson} \
  --names "FE2,cap,soft cap,Cam-Clay,FKM-Gurson" --force -o "$folder/compare"
echo "Read $folder/compare/summary.txt; plots are in $folder/compare/plots"
