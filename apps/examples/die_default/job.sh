#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# A die of unit cells on several nodes, for Slurm; the last lines serve any
# scheduler whose mpirun knows its nodes.
#
#   sbatch job.sh die_default.prm        one rank per node, threads in it
#   sbatch job.sh die_default.prm core   one rank per core
#
# The results are the same, to the bit. Threads balance the cells of a node
# better and hold the finite elements once; ranks per core are for launchers
# that bind processes to cores. More cores than a quarter of the cells do not
# pay: each should have several to balance.
#SBATCH --job-name=tamp
#SBATCH --nodes=2
#SBATCH --exclusive
#SBATCH --time=02:00:00
# Five minutes before the end this script is told, which tells the ranks of this
# node, which tell all: the step at hand is finished, a checkpoint written. The
# same job, started again, goes on from there. mpirun, told instead, may kill
# before: see apps/run/README.md.
#SBATCH --signal=B:TERM@300
set -eu
input=$1
per=${2:-node}
cores=${SLURM_CPUS_ON_NODE:-$(env -u OMP_NUM_THREADS nproc)}
results=${RESULTS:-results}
again=
[ -z "$(ls "$results"/checkpoint/step_*.tamp 2> /dev/null)" ] || again=--resume
# Threads are the program's own.
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

case $per in
node) layout="--map-by ppr:1:node --bind-to none" threads=$cores ;;
core) layout="--map-by core --bind-to core" threads=1 ;;
*)
  echo "job.sh: '$per': expected node or core" >&2
  exit 2
  ;;
esac
# shellcheck disable=SC2086
mpirun $layout -x OMP_NUM_THREADS -x OPENBLAS_NUM_THREADS \
  "${TAMP:-tamp}" die "$input" --threads "$threads" -o "$results" $again &
run=$!
trap 'pkill -TERM -P "$run" -x tamp' TERM
status=0
wait "$run" || status=$?
# The signal ends the first wait, not the run.
if kill -0 "$run" 2> /dev/null; then
  status=0
  wait "$run" || status=$?
fi
exit "$status"
