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
programs="dem_benchmark"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DTAMP_BENCHMARKS=ON >"${TMPDIR:-/tmp}/tamp_benchmark_configure.log" || {
  echo "configuring failed:" \
    "see ${TMPDIR:-/tmp}/tamp_benchmark_configure.log" >&2
  exit 1
}
# shellcheck disable=SC2086
cmake --build "$build" --parallel "$(nproc)" --target $programs >&2

lines=$(mktemp)
trap 'rm -f "$lines"' EXIT
for program in $programs; do
  "$build/tests/benchmark/$program" "$filter" >>"$lines"
done
# Runs of whole programs whose times are lines of the result, too, go here:
# append "name,value,unit" to "$lines" where the name contains "$filter".

{
  echo "# date: $(date -u +%Y-%m-%dT%H:%M:%SZ)"
  echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo |
    head -n 1), $(nproc) cores, $(uname -sm)"
  echo "# version: $(git -C "$root" describe --always --dirty 2>/dev/null ||
    echo unknown)"
  echo "# load: $(cut -d ' ' -f 1-3 /proc/loadavg)"
  echo "name,value,unit"
  cat "$lines"
} >"$result"

awk -F, '{ printf "%-40s %14s  %s\n", $1, $2, $3 }' "$lines"
echo "written: $result"
