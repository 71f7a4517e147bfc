#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Figures 1 to 12 of Sheng et al. (2004): makes all runs, draws the figures,
# tests the trends that the paper tells, and writes one page, paper.md.
# Usage: run.sh [TAMP [FOLDER]]
#   JOBS=N    runs at a time, one thread each; default: as many as cores
#   COARSE=1  a quick look: few grains, one packing, the ends of each range
#   FORCE=1   overwrite what is in FOLDER, by default results/paper
set -euo pipefail
export LC_ALL=C

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
examples=$(dirname "$here")
tamp=$(realpath "${1:-$examples/../../build/apps/tamp}")
folder=${2:-results/paper}
jobs=${JOBS:-$(nproc)}
for name in paper_fig01 paper_fig02 paper_fig04 paper_fig10 square_die_cells; do
  [ -d "$examples/$name" ] || {
    echo "run.sh: the example $name is missing beside ${here##*/}" >&2
    exit 2
  }
done
if [ -e "$folder" ] && [ -z "${FORCE:-}" ]; then
  echo "run.sh: '$folder' exists already; FORCE=1 overwrites it" >&2
  exit 2
fi
if [ -n "$(ls -A "$folder" 2> /dev/null)" ] && [ ! -e "$folder/done" ]; then
  echo "run.sh: '$folder' is not a folder of this script; it stays as it is" >&2
  exit 2
fi
rm -rf "$folder"/{runs,data,done,failed,paper.md} "$folder"/fig??.png \
  "$folder"/{states,grid,trends,reference}.csv
mkdir -p "$folder/runs"
folder=$(cd "$folder" && pwd)
touch "$folder/done" # names of runs that ended

packings="1 2 3"
frictions="0.3 0.5 0.7 0.9"
limits="20 50 200" # of the granules [MPa]
grains=1000
granules=3200
shape=0.583
if [ -n "${COARSE:-}" ]; then
  packings=1
  frictions="0.3 0.9"
  limits=50
  grains=200
  granules=300
  shape=0 # flat, so few grains would end as a sheet
fi
export packings frictions limits

# start COMMAND...: in the background, when fewer than the allowed are running.
start() {
  while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do
    wait -n || true
  done
  "$@" &
}
# Whoever stops this script stops what it started.
stop() {
  for job in $(jobs -rp); do
    pkill -P "$job" || true
    kill "$job" 2> /dev/null || true
  done
}
trap stop EXIT

# one COMMAND NAME INPUT SETTING...: a run into runs/NAME.
one() {
  local command=$1 name=$2 input=$3 settings=()
  shift 3
  for setting in "$@"; do
    settings+=(--set "$setting")
  done
  if "$tamp" "$command" "$examples/$input.prm" -o "$folder/runs/$name" --force \
    --threads 1 -q --no-plots --set "Output/Grain output = none" \
    "${settings[@]}" 2> "$folder/runs/$name.txt"; then
    echo "$name" >> "$folder/done"
  else
    echo "$name: $(tail -n 1 "$folder/runs/$name.txt")" >> "$folder/failed"
  fi
}
# table_one NAME INPUT SETTING...: with each packing.
table_one() {
  local name=$1 input=$2
  shift 2
  for packing in $packings; do
    start one probe "${name}_$packing" "$input" \
      "Packing/Seed = $packing" "Grains/Count = $grains" "$@"
  done
}
scaling() {
  SEED=$1 SCALINGS="1e13 1e14 1e16 1e18 1e20 1e22 1e23" FORCE=1 \
    bash "$examples/paper_fig01/run.sh" "$tamp" "$folder/runs/scaling_$1" \
    > "$folder/runs/scaling_$1.txt" 2>&1 ||
    echo "scaling_$1" >> "$folder/failed"
}

# Figure 1, the longest.
if [ -z "${COARSE:-}" ]; then
  for packing in $packings; do
    start scaling "$packing"
  done
fi

# Figures 2 to 9: to 40 MPa and back.
second=paper_fig02/paper_fig02
for friction in $frictions; do
  table_one "mu$friction" "$second" "Contact/Friction coefficient = $friction"
done
table_one py1 paper_fig04/paper_fig04
# The same with all packings made alike, with mu = 0.3: what friction does while
# they are pressed.
for friction in ${frictions#* }; do
  table_one "alike$friction" "$second" \
    "Contact/Friction coefficient = $friction" \
    "Packing/Friction during packing = 0.3"
done

# The table of an independent code: to an engineering strain of 15 % and back.
to_15="Path/Stages = uniaxial to strain 0.16252; unload to 1.5 % of peak"
to_10="Path/Stages = uniaxial to strain 0.10537; unload to 1.5 % of peak"
table_one ref_mu0.3 "$second" "$to_15"
table_one ref_py1 paper_fig04/paper_fig04 "$to_15"
if [ -z "${COARSE:-}" ]; then
  table_one ref_mu0.6 "$second" "$to_15" "Contact/Friction coefficient = 0.6"
  table_one ref_mu0.9 "$second" "$to_15" "Contact/Friction coefficient = 0.9"
  table_one ref_packed "$second" "$to_15" \
    "Contact/Friction coefficient = 0.9" "Packing/Friction during packing = 0.3"
  table_one ref_elastic "$second" "$to_10" "Contact/Normal law = hertz"
fi

# The same by the protocol of that code, as far as it is told: packed and
# pressed by dynamics, 1e-6 of strain in a time step, with local damping only.
hitting=("Packing/Method = dynamics" "Cell/Time step fraction = 0.25"
  "Cell/Global damping = 0" "Cell/Local damping = 0.3"
  "Cell/Precision = mixed")
motion=("${hitting[@]}" "Cell/Method = dynamics"
  "Cell/Strain rate = 5.5e-5 1/s")
table_one dyn_py1 paper_fig04/paper_fig04 "$to_15" "${motion[@]}"
if [ -z "${COARSE:-}" ]; then
  table_one dyn_mu0.3 "$second" "$to_15" "${motion[@]}"
  table_one dyn_mu0.6 "$second" "$to_15" "${motion[@]}" \
    "Contact/Friction coefficient = 0.6"
  table_one dyn_mu0.9 "$second" "$to_15" "${motion[@]}" \
    "Contact/Friction coefficient = 0.9"
  table_one dyn_packed "$second" "$to_15" "${motion[@]}" \
    "Contact/Friction coefficient = 0.9" "Packing/Friction during packing = 0.3"
  table_one dyn_elastic "$second" "$to_10" "${motion[@]}" \
    "Contact/Normal law = hertz"
  # The same grains, denser: packed with a little less friction.
  table_one den_elastic "$second" "$to_10" "Contact/Normal law = hertz" \
    "Packing/Friction during packing = 0.26"
  # How fast grains are packed, from five times slower to ten times faster.
  for rate in 1.1e-5 2.2e-5 5.5e-4; do
    table_one "packed$rate" paper_fig04/paper_fig04 \
      "Path/Stages = uniaxial to strain 1e-3" "${hitting[@]}" \
      "Cell/Strain rate = $rate 1/s"
  done
fi

# Figures 10 to 12: a cell of granules; by a law in which contacts of a grain
# know of each other; and the die with its walls, coarse.
tenth=paper_fig10/paper_fig10
grains=$granules
for limit in $limits; do
  table_one "granules$limit" "$tenth" \
    "Packing/Cell shape = $shape" \
    "Contact/Limiting contact pressure = $limit MPa"
done
if [ -z "${COARSE:-}" ]; then
  # p_y raised while the granules are pressed, over the range of Table II.
  table_one granules_adjusted "$tenth" "Packing/Cell shape = $shape" \
    "Contact/Normal law = thornton-ning-adjusted" \
    "Contact/Limiting contact pressures = 20, 200 MPa" \
    "Contact/Densities of limiting contact pressures = 0.7, 0.85"
  grains=1000
  table_one granules_mdr "$tenth" "Packing/Cell shape = 0" \
    "Contact/Normal law = mdr" "Contact/Bulk onset = 0.3" \
    "Path/Stages = uniaxial to strain 0.95" \
    "Path/Maximum strain increment = 5e-3"
  start one die square_die square_die_cells/square_die_cells \
    "Grains/Count = 100" "Die/Elements = 3, 3" \
    "Schedule/Stages = press to density 0.85; unload to 5 % of peak"
fi
start one probe literal paper/table1_literal
while [ -n "$(jobs -rp)" ]; do
  wait -n || true
done
if [ -s "$folder/failed" ]; then
  echo "run.sh: these runs failed:" >&2
  cat "$folder/failed" >&2
  exit 3
fi

bash "$here/evaluate.sh" "$folder"
