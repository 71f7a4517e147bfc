#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Isotropic packings of Sheng et al. (2004), Table I, with E = 70 GPa, at
# 100 kPa: relative density and mechanical coordination for other friction and
# laws, mean and deviation of seeds. Usage: table.sh [TAMP [SEEDS [GRAINS]]]
set -euo pipefail

tamp=${1:-build/apps/tamp}
seeds=${2:-5}
grains=${3:-1000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

touch "$work/empty.prm"

# row TITLE OPTION...: packs and prints a line of the table.
row() {
  local title=$1 folder
  shift
  folder=$(mktemp -d -p "$work")
  "$tamp" pack "$work/empty.prm" -o "$folder/run" -q --no-plots \
    --set "Grains/Count = $grains" --set "Packing/Replicas = $seeds" "$@"
  awk -v title="$title" '
    match($0, /"[a-z_]*\[/) {
      name = substr($0, RSTART + 1, RLENGTH - 2)
      sub(/.*: /, ""); sub(/,$/, "")
      value[name] = $0
    }
    END {
      printf "| %s | %.4f ± %.4f | %.2f ± %.2f | %.2f |\n", title,
        value["relative_density"], value["relative_density_deviation"],
        value["mechanical_coordination_number"],
        value["mechanical_coordination_number_deviation"],
        value["plastic_share"]
    }' "$folder/run/run.json"
}

echo '| case | relative density | Z_m | plastic |'
echo '|---|---|---|---|'
for mu in 0.3 0.6 0.9; do
  row "μ $mu, p_y 0.5 GPa" --set "Contact/Friction coefficient = $mu"
done
elastic=(--set 'Contact/Normal law = hertz')
for mu in 0 0.1 0.3 0.5 1; do
  row "μ $mu, elastic" "${elastic[@]}" \
    --set "Contact/Friction coefficient = $mu"
done
smooth=(--set 'Contact/Tangential law = none')
row 'smooth, elastic, 10 kPa' "${elastic[@]}" "${smooth[@]}" \
  --set 'Packing/Pressure = 10 kPa'
row 'smooth, elastic, one size, 10 kPa' "${elastic[@]}" "${smooth[@]}" \
  --set 'Packing/Pressure = 10 kPa' --set 'Grains/Minimum diameter = 200 um' \
  --set 'Grains/Maximum diameter = 200 um'
