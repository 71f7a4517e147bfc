#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds tamp, and runs a die compaction whose
# material points are cells of grains.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1

apps/install_packages.sh
apps/build.sh tamp

results=results/die_default
build/apps/tamp die apps/examples/die_default/die_default.prm \
  -o "$results" --force

cat << END

Done. Everything is in $root/$results:
  summary.txt               what came out, on one page
  curve.csv                 punch forces, wall forces, densities, step by step
  fields.pvd                for ParaView: the compact, step by step
  grains.pvd                for ParaView: grains and force chains of some points
Pictures (SVG beside each PNG):
END
find "$root/$results/plots" -name '*.png' 2> /dev/null | sort | sed 's/^/  /'
