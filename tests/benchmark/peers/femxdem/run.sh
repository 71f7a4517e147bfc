#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The same triaxial compression by FEMxDEM (YADE and escript) and by tamp:
# prints a table of what a load step costs and how well it is balanced, and
# writes femxdem.csv in the current folder. Ten minutes of one core, nearly all
# of them the peer's.
#
#   tests/benchmark/peers/femxdem/run.sh
#
# The environment may change: STEPS (load steps, 4), START (a packing, see
# README.md).
set -euo pipefail
export LC_ALL=C

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../../.." && pwd)
build=$root/build
result=$PWD/femxdem.csv
escript=/usr/lib/python3-escript

# The case. peer_cell.cc holds the numbers of the grains.
export youngs=70e6 poisson=0.3 density=2650 friction=0.3
export width=0.05 height=0.1 pressure=1e5 increment=1e-3
export steps=${STEPS:-4}
export tolerance=1e-2 # of the peer: of the displacement, its example's
export processes=2    # of the peer, which wants more than one
tamp_tolerance=2e-5 # of tamp: of the forces, tighter than the peer ends with

# One thread each, whatever the libraries would like.
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

fail() {
  echo "run.sh: $*" >&2
  exit 4
}

if ! command -v yade > /dev/null || [ ! -d "$escript/esys" ]; then
  echo "skipped: FEMxDEM needs the packages of Debian 12 that" \
    "'apt-get install --no-install-recommends yade python3-escript' installs"
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run() { # COMMAND...: its output is added to $work/out
  echo "running: $(basename "$1") ${*:2}" >&2
  "$@" < /dev/null > "$work/last" 2>&1 || {
    tail -n 20 "$work/last" >&2
    fail "'$*' failed; its last lines are above"
  }
  cat "$work/last" >> "$work/out"
}

run cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DTAMP_BENCHMARKS=ON
run cmake --build "$build" --target peer_case femxdem_case

# Without friction the packing's places are all that is behind its equilibrium:
# both codes start from the same stress.
export start=$work/start.txt
"$build/tests/benchmark/peer_case" jam "${START:-$here/../jammed_1000.txt}" \
  "$pressure" 0 > "$start"

run "$build/tests/benchmark/femxdem_case" "$start" "$friction" "$width" \
  "$height" "$pressure" "$increment" "$tamp_tolerance" "$steps"
cd "$work"
run yade -n -x -j1 "$here/cell.py"
LD_LIBRARY_PATH=$escript/lib PYTHONPATH=$escript \
  run yade -n -x -j1 "$here/triaxial.py"

{
  echo "# date: $(date -u +%Y-%m-%dT%H:%M:%SZ)"
  echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo |
    head -n 1), $(env -u OMP_NUM_THREADS nproc) cores, $(uname -sm)"
  echo "# version: $(git -C "$root" describe --always --dirty 2> /dev/null ||
    echo unknown)"
  echo "# load: $(cut -d ' ' -f 1-3 /proc/loadavg)"
  echo "name,value,unit"
  awk '$1 == "step" {
    seconds[$2] += $5
    updates[$2] += $4
    if ($6 > residual[$2]) residual[$2] = $6
    ++count[$2]
  }
  END {
    for (code in count) {
      name = code == "tamp" ? "peer.femxdem.tamp" : "peer.femxdem"
      print name ".cpu_seconds_per_point_step.1000," \
        seconds[code] / count[code] ",s"
      print name ".updates_per_step.1000," updates[code] / count[code] ",-"
      print name ".worst_force_residual.1000," residual[code] ",-"
    }
  }' "$work/out"
} > "$result"
awk -f "$here/table.awk" "$work/out"
echo
echo "written: $result"
