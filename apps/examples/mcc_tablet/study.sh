#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Presses, unloads and ejects the tablet with three friction laws on three
# meshes and prints what came out as a table.
# Usage: study.sh [TAMP [FOLDER]]
# Results go to FOLDER, by default results/mcc_tablet. One run at a time, about
# 3 minutes on one core.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
tamp=${1:-$root/build/apps/tamp}
folder=${2:-$root/results/mcc_tablet}
mkdir -p "$folder"

constant="0.161"
# 0.1612 + 0.7568 exp(-16.8 (D - 0.3)), within 1e-3
lubricated_die="of density 0.300: 0.9180, 0.306: 0.8454, 0.312: 0.7798,
0.318: 0.7205, 0.325: 0.6585, 0.332: 0.6033, 0.340: 0.5477, 0.348: 0.4991,
0.357: 0.4517, 0.367: 0.4067, 0.377: 0.3688, 0.388: 0.3338, 0.401: 0.2999,
0.415: 0.2708, 0.431: 0.2450, 0.450: 0.2221, 0.473: 0.2026, 0.501: 0.1870,
0.538: 0.1751, 0.592: 0.1668, 0.694: 0.1622, 0.9: 0.1612"
# 0.0601 + 0.1593 D
lubricated_powder="of density 0.3: 0.1079, 1: 0.2194"

# value NAME FOLDER FACTOR FORMAT: a result of a run
value() {
  awk -v name="\"$1\":" -v factor="$3" -v format="$4" \
    '$1 == name { printf format, $2 * factor }' "$2/run.json"
}

echo "| friction | mesh | peak force [N] | transmission | density at peak: min | mean | max | ejection force [N] | spring-back axial [mm] | CPU time [s] |"
echo "|---|---|---|---|---|---|---|---|---|---|---|"
for friction in constant lubricated_die lubricated_powder; do
  law=${!friction//$'\n'/ }
  for mesh in "7, 12" "14, 25" "28, 50"; do
    run="$folder/${friction}_${mesh%%,*}"
    "$tamp" die "$here/mcc_tablet.prm" -o "$run" --force -q --no-plots \
      --threads 1 --set "Die/Elements = $mesh" \
      --set "Die/Wall friction coefficient = $law" \
      --set "Die/Punch friction coefficient = $law"
    echo "| ${friction/_/ } | ${mesh/, / x }" \
      "| $(value "peak_upper_force[N]" "$run" 1 "%.2f")" \
      "| $(value "transmission_at_peak[-]" "$run" 1 "%.4f")" \
      "| $(value "minimum_relative_density_at_peak[-]" "$run" 1 "%.3f")" \
      "| $(value "mean_relative_density_at_peak[-]" "$run" 1 "%.3f")" \
      "| $(value "maximum_relative_density_at_peak[-]" "$run" 1 "%.3f")" \
      "| $(value "peak_ejection_force[N]" "$run" 1 "%.1f")" \
      "| $(value "axial_spring_back[m]" "$run" 1000 "%.4f")" \
      "| $(value "cpu_time[s]" "$run" 1 "%.0f") |"
  done
done
