#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds Release, runs the benchmarks whose names contain FILTER (all without
# one), prints a table and writes benchmark.csv in the current folder.
#
#   tests/benchmark/run.sh [FILTER]
set -eu

filter=${1:-}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build
result=$PWD/benchmark.csv
# Programs that print lines "name,value,unit"; each takes FILTER. Further ones
# are added here.
programs="dem_benchmark coupling_benchmark"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DTAMP_BENCHMARKS=ON >"${TMPDIR:-/tmp}/tamp_benchmark_configure.log" || {
  echo "configuring failed:" \
    "see ${TMPDIR:-/tmp}/tamp_benchmark_configure.log" >&2
  exit 1
}
# shellcheck disable=SC2086
cmake --build "$build" --parallel "$(env -u OMP_NUM_THREADS nproc)" --target $programs tamp >&2

lines=$(mktemp)
trap 'rm -f "$lines"' EXIT
for program in $programs; do
  "$build/tests/benchmark/$program" "$filter" >>"$lines"
done

# run_die NAME EXAMPLE: wall time of a die example, cell updates per load step,
# and where the time went, from its run.json.
run_die() {
  case "$1" in *"$filter"*) ;; *)
    [ -n "$filter" ] && [ "${filter#"$1"}" = "$filter" ] && return 0 ;;
  esac
  out=$(mktemp -d)
  "$build/apps/tamp" die "$root/apps/examples/$2/$2.prm" -o "$out/result" \
    -q --no-plots
  value() {
    sed -n "s/^ *\"$1\": \([0-9.eE+-]*\),*\$/\1/p" "$out/result/run.json"
  }
  {
    echo "$1.wall,$(value 'wall_time\[s\]'),s"
    echo "$1.cell_updates_per_step,$(value 'cell_updates_per_step\[-\]'),-"
    for part in packing material assembly linear_solver model; do
      seconds=$(value "time_$part\[s\]")
      [ -z "$seconds" ] || echo "$1.time.$part,$seconds,s"
    done
  } >>"$lines"
  rm -rf "$out"
}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
run_die die_dpc die_default_dpc
run_die die_default die_default

{
  echo "# date: $(date -u +%Y-%m-%dT%H:%M:%SZ)"
  echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo |
    head -n 1), $(env -u OMP_NUM_THREADS nproc) cores, $(uname -sm)"
  echo "# version: $(git -C "$root" describe --always --dirty 2>/dev/null ||
    echo unknown)"
  echo "# load: $(cut -d ' ' -f 1-3 /proc/loadavg)"
  echo "name,value,unit"
  cat "$lines"
} >"$result"

awk -F, '{ printf "%-40s %14s  %s\n", $1, $2, $3 }' "$lines"
echo "written: $result"
