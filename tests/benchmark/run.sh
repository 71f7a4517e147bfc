    echo "$(value 'time_model\[s\]' "$name")" \XX      "$(value 'steps\[-\]' "$name") $updates" |#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds Release, runs the benchmarks whose names match the regular expression
# FILTER (all without one), prints a table beside what targets.csv asks for,
# and writes benchmark.csv in the current folder. Times are processor times,
# the median of REPETITIONS (7 if not set).
#
#   tests/benchmark/run.sh [FILTER]
set -eu

filter=${1:-}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build
result=$PWD/benchmark.csv
# Programs of Google Benchmark; further ones are added here.
programs="dem_benchmark coupling_benchmark"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DTAMP_BENCHMARKS=ON >"${TMPDIR:-/tmp}/tamp_benchmark_configure.log" || {
  echo "configuring failed:" \
    "see ${TMPDIR:-/tmp}/tamp_benchmark_configure.log" >&2
  exit 1
}
# shellcheck disable=SC2086
cmake --build "$build" --parallel "$(env -u OMP_NUM_THREADS nproc)" --target $programs tamp >&2

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
lines=$scratch/lines
: >"$lines"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
for program in $programs; do
  "$build/tests/benchmark/$program" --benchmark_filter="${filter:-.}" \
    --benchmark_repetitions="${REPETITIONS:-7}" --benchmark_min_time=0.1 \
    --benchmark_display_aggregates_only=true \
    --benchmark_out="$scratch/$program.json" --benchmark_out_format=json >&2
  awk -f "$here/rows.awk" "$scratch/$program.json" >>"$lines"
done

# value NAME FOLDER: of a key result of a run.
value() {
  sed -n "s/^ *\"$1\": \([0-9.eE+-]*\),*\$/\1/p" "$scratch/$2/run.json"
}

# run_die NAME RANKS INPUT [OPTION...]: wall time of a die, cell updates per load
# step, seconds per update (of laws: a step of Newton's method), and where the
# time went, from its run.json. Runs if FILTER matches any name of its rows.
run_die() {
  name=$1
  ranks=$2
  input=$3
  shift 3
  parts="packing material assembly contact linear_solver model"
  printf "%s\n" "$name.wall" "$name.cell_updates_per_step" \
    "$name.seconds_per_update" "$name.time." |
    grep -Eq -- "${filter:-.}" || return 0
  set -- "$build/apps/tamp" die "$input" -o "$scratch/$name" -q --no-plots "$@"
  [ "$ranks" -eq 1 ] || set -- mpirun -np "$ranks" --oversubscribe "$@"
  "$@"
  updates=$(value 'cell_updates_per_step\[-\]' "$name")
  {
    echo "$name.wall,$(value 'wall_time\[s\]' "$name"),s"
    echo "$name.cell_updates_per_step,$updates,-"
    echo "$(value 'time_model\[s\]' "$name")" \
      "$(value 'steps\[-\]' "$name") $updates" |
      awk -v name="$name" \
        '{ printf "%s.seconds_per_update,%.4g,s\n", name, $1 / ($2 * $3) }'
    for part in $parts; do
      seconds=$(value "time_$part\[s\]" "$name")
      [ -z "$seconds" ] || echo "$name.time.$part,$seconds,s"
    done
  } >>"$lines"
}
examples=$root/apps/examples
run_die die_dpc 1 "$examples/mcc_tablet/mcc_tablet.prm" \
  --set "Die/Elements = 28, 50" --threads 1
run_die die_3d 2 "$here/die_3d.prm" --threads 1
run_die die_default 1 "$examples/die_default/die_default.prm"

# seconds_in_cells RANKS THREADS: wall time of the evaluations of all cells in
# the first steps of die_default.
seconds_in_cells() {
  mpirun --bind-to none -np "$1" "$build/apps/tamp" die \
    "$examples/die_default/die_default.prm" \
    -o "$scratch/cells" --force -q --no-plots --threads "$2" \
    --set "Schedule/Stages = press to density 0.66" >&2
  value 'time_material\[s\]' cells
}

# The share of two cores' time that is used, on two threads and on two ranks:
# one core's over twice that of two, each the least of three, taken in turn, as
# other work on the machine only adds to it.
run_efficiency() {
  printf "%s\n" coupling.thread_efficiency.2 coupling.rank_efficiency.2 |
    grep -Eq -- "${filter:-.}" || return 0
  for _ in 1 2 3; do
    echo "$(seconds_in_cells 1 1) $(seconds_in_cells 1 2)" \
      "$(seconds_in_cells 2 1)"
  done | awk '
    { for (i = 1; i <= 3; ++i) if (NR == 1 || $i < least[i]) least[i] = $i }
    END { print "coupling.thread_efficiency.2," least[1] / (2 * least[2]) ",-"
      print "coupling.rank_efficiency.2," least[1] / (2 * least[3]) ",-" }' \
    >>"$lines"
}
run_efficiency

# The processor, its clock if the system knows it, and how many.
machine() {
  model=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)
  clock=$(sed -n 's/^cpu MHz[^:]*: \([0-9]*\).*/, \1 MHz/p' /proc/cpuinfo |
    head -n 1)
  echo "${model:-$(uname -m)}$clock, $(env -u OMP_NUM_THREADS nproc) cores," \
    "$(uname -sm)"
}
{
  echo "# date: $(date -u +%Y-%m-%dT%H:%M:%SZ)"
  echo "# machine: $(machine)"
  echo "# version: $(git -C "$root" describe --always --dirty 2>/dev/null ||
    echo unknown)"
  echo "# load: $(cut -d ' ' -f 1-3 /proc/loadavg)"
  echo "name,value,unit"
  cat "$lines"
} >"$result"

grep '^#' "$result"
awk -f "$here/table.awk" "$here/targets.csv" "$lines"
echo "written: $result"
