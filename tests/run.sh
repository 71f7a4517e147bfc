#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds everything in build/, and runs all tests.
# Further arguments go to ctest, for example: tests/run.sh -L style
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1

"$root/apps/install_packages.sh"
"$root/apps/build.sh"
exec ctest --test-dir "$root/build" --output-on-failure -j2 "$@"
