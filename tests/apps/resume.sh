#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A die that was killed, stopped or had its checkpoints damaged goes on with
# --resume and leaves what an uninterrupted one leaves; what cannot be resumed is
# refused, and touched by nothing.
# Usage: resume.sh TAMP [cells|ranks|law|refused|failing]
command=die key_results=21
source "$(dirname "${BASH_SOURCE[0]}")/resumed.sh"
part=$2

cat > cells.prm << 'END_OF_INPUT'
include granules_die.prm
subsection Solver
  set Maximum step = 4e-3
end
subsection Output
  set Checkpoint interval = 1 us
  set Grain points        = 0, 5
  set Bias interval       = 2
end
END_OF_INPUT
cat > law.prm << 'END_OF_INPUT'
subsection Material
  set Type = drucker-prager cap
end
subsection Die
  set Elements = 3, 4
end
subsection Schedule
  set Stages = press both to density 0.5; unload to nothing; eject to out
  set Floating die = true
end
subsection Output
  set Checkpoint interval = 1 us
end
END_OF_INPUT

case $part in
  cells) goes_on cells run.json 7 14 ;; # also asked while it packs
  law) goes_on law fields/step_0005.vtu 7 14 ;;
  refused)
    refuses 12 'Die/Wall friction coefficient = 0.3' \
      'Die/Wall friction coefficient = 0.3, was 0.2'
    ;;
esac

# Cells go on to the bit on any number of ranks.
if [ "$part" = ranks ]; then
  export OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1
  export OPENBLAS_NUM_THREADS=1
  "$tamp" die cells.prm -o cells --no-plots -q
  last=$(tail -n 1 cells/curve.csv | cut -d, -f1)
  die=("$tamp" die cells.prm -o killed --no-plots -q)
  # killed_on RANKS TWENTIETH OPTION...: ends it without warning on the way.
  killed_on() {
    local ranks=$1 step=$((last * $2 / 20)) run
    shift 2
    nice mpirun -np "$ranks" "${die[@]}" "$@" 2> err.txt &
    run=$!
    until step_of killed && [ "$newest" -ge "$step" ]; do
      kill -0 "$run" 2> /dev/null || { cat err.txt; fail "before step $step"; }
      sleep 0.002
    done
    pkill -KILL -P "$run" -x tamp || fail "it had ended before step $step"
    ! wait "$run" || fail "it ended well"
  }
  killed_on 2 5
  killed_on 4 9 --resume
  killed_on 1 13 --resume --threads 2
  mpirun -np 2 "${die[@]}" --resume --threads 2
  [ "$(grep -c 'going on after step' killed/log.txt)" -eq 3 ] ||
    fail "log.txt does not tell where the run went on"
  leaves cells killed
  echo "all well"
fi

if [ "$part" = failing ]; then
  # No room for checkpoints, whoever runs the test: files end at 64 kB.
  (
    trap '' XFSZ
    ulimit -f 64
    export PMIX_MCA_gds=hash # MPI's shared memory is a larger file
    "$tamp" die cells.prm -o full --no-plots -q
  ) || fail "no room: exit code $?"
  grep -q 'warning: no checkpoint of step 1: .*File too large; the run goes on' \
    full/log.txt || fail "no room: log.txt does not tell"
  grep -q 'no checkpoint of step' full/summary.txt || fail "no room: summary.txt"
  [ "$(find full/checkpoint -type f | wc -l)" -eq 0 ] || fail "no room: a file"
  # A folder that cannot be written keeps what it has.
  kill_after TERM 8 cells.prm barred
  step_of barred
  before=$newest
  mkdir -p "barred/checkpoint/$(
    printf 'step_%04d.tamp.part' $((before + 1))
  )/x"
  "$tamp" die cells.prm -o barred --no-plots -q --resume
  grep -q "warning: no checkpoint of step $((before + 1)): " barred/log.txt ||
    fail "barred: log.txt does not tell"
  step_of barred
  [ "$newest" -gt "$((before + 1))" ] || fail "barred: no later ones"
  # What stands where the folder should be.
  asked_in plain fields/step_0005.vtu touch plain/checkpoint
  grep -q "warning: no checkpoint of step .*'plain/checkpoint'" plain/log.txt ||
    fail "plain: log.txt does not tell"
  rm plain/checkpoint
  for folder in plain barred; do
    sed -i '/"warnings"/,/\],/d' $folder/run.json
  done
  leaves plain barred
  echo "all well"
fi
