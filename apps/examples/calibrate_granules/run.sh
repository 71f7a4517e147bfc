#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fits the limiting contact pressure and the friction of the granules to
# measured.csv.
# Usage: run.sh [TAMP [FOLDER]]
#   FORCE=1  overwrite what is in FOLDER, by default results/calibrate_granules
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tamp=${1:-$here/../../../build/apps/tamp}
exec "$tamp" calibrate "$here/calibrate_granules.prm" \
  --data "$here/measured.csv" -o "${2:-results/calibrate_granules}" \
  ${FORCE:+--force} \
  --fit "Contact/Limiting contact pressure = 10 MPa .. 300 MPa" \
  --fit "Contact/Friction coefficient = 0.1 .. 0.9"
