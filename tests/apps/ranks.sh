#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Several ranks give the curve that one gives, one of them writes and speaks,
# and whatever ends one ends all. Usage: ranks.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
export OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1
export OPENBLAS_NUM_THREADS=1

cat > die.prm << 'END_OF_INPUT'
subsection Material
  set Type = drucker-prager cap
end
subsection Die
  set Elements = 3, 5
end
subsection Schedule
  set Stages = press to displacement 1.5 mm; unload to nothing; eject by 1 mm
end
subsection Solver
  set Force tolerance = 1e-8
  set Maximum step    = 2e-2
  set Maximum unloading step = 5e-3
end
subsection Output
  set Plot format = svg
end
END_OF_INPUT

# on RANKS OPTION...: the die on so many ranks; the exit code in $status.
on() {
  local ranks=$1
  shift
  status=0
  timeout 60 mpirun -np "$ranks" "$tamp" die "$@" > out.txt 2> err.txt ||
    status=$?
}

# says CODE TEXT: the last run ended so, with one message of the program on
# stderr; mpirun adds its own.
says() {
  [ "$status" -eq "$1" ] || { cat out.txt err.txt; fail "code $status, not $1"; }
  [ "$(grep -c '^tamp: ' err.txt)" -eq 1 ] ||
    { cat err.txt; fail "expected one message"; }
  grep -q "^tamp: .*$2" err.txt || { cat err.txt; fail "no '$2'"; }
}

on 1 die.prm -o one
[ "$status" -eq 0 ] || { cat err.txt; fail "one rank: exit code $status"; }
on 2 die.prm -o two
[ "$status" -eq 0 ] || { cat err.txt; fail "two ranks: exit code $status"; }
[ ! -s err.txt ] || { cat err.txt; fail "two ranks: a message"; }
[ "$(grep -c 'Results are in' out.txt)" -eq 1 ] || fail "two summaries"
lines=$(grep -vc '^#' two/curve.csv)
[ "$(grep -c '^step ' out.txt)" -eq $((lines - 1)) ] ||
  fail "expected one line a step"
grep -q 'on 2 ranks' two/log.txt || fail "log.txt does not tell the ranks"
grep -q '"ranks": 2' two/run.json || fail "run.json does not tell the ranks"
grep -q '"ranks": 1' one/run.json || fail "run.json does not tell one rank"
(cd one && find . -type f | sort) > one.txt
(cd two && find . -type f | sort) > two.txt
cmp one.txt two.txt || fail "other files"

# same A B: the curves agree to 1e-9 of each column's largest value, but for
# the residual, which is rounding at its end, and the time.
same() {
  paste -d, <(grep -v '^#' "$1/curve.csv") <(grep -v '^#' "$2/curve.csv") |
    awk -F, '
    function size(x) { return x < 0 ? -x : x }
    NR == 1 { fields = NF / 2; split($0, name); next }
    { if (NF != 2 * fields) exit 1
      for (i = 1; i <= fields; ++i) {
        off = size($i - $(fields + i))
        if (off > worst[i]) worst[i] = off
        if (size($i) > largest[i]) largest[i] = size($i) } }
    END { bad = NR < 20
      for (i = 1; i <= fields; ++i)
        if (name[i] !~ /^wall_time|_residual|^displacement_change/ &&
            worst[i] > 1e-9 * largest[i]) {
          print name[i] " differs by " worst[i] " of " largest[i]; bad = 1 }
      exit bad }' || fail "$1 and $2 differ"
}
same one two

# A run of two ranks that was stopped goes on with one, and that one with two.
long=(die.prm -q --no-plots --set 'Solver/Maximum step = 3e-3'
  --set 'Output/Checkpoint interval = 1 us')
on 1 "${long[@]}" -o long
# newest: the name of the newest checkpoint.
newest() {
  find stopped/checkpoint -name '*.tamp' -printf '%f\n' 2> /dev/null |
    sort | tail -n 1 || true
}
# stop RANKS OPTION...: stops the run a few steps after its begin.
stop() {
  local ranks=$1 run before
  shift
  before=$(newest)
  mpirun -np "$ranks" "$tamp" die "${long[@]}" -o stopped "$@" > out.txt \
    2> err.txt &
  run=$!
  while [[ ! $(newest) > $before ]]; do
    kill -0 "$run" 2> /dev/null || { cat err.txt; fail "ended too soon"; }
    sleep 0.01
  done
  # mpirun itself passes the signal on a second later.
  pkill -TERM -P "$run" -x tamp || fail "not running"
  wait "$run" && fail "not stopped"
  return 0
}
stop 2
stop 1 --resume
on 2 "${long[@]}" -o stopped --resume
[ "$status" -eq 0 ] || { cat err.txt; fail "resumed: exit code $status"; }
[ "$(grep -c 'going on after step' stopped/log.txt)" -eq 2 ] ||
  fail "log.txt does not tell where the run went on"
same long stopped

# Wrong inputs: one message, nothing written.
on 2 die.prm -o bad --set 'Die/Radius = -1'
says 2 'Die/Radius'
on 2 missing.prm -o bad
says 2 'missing.prm'
on 2 die.prm -o bad --wrong
says 2 '--wrong'
[ ! -e bad ] || fail "wrong inputs make a folder"
on 2 die.prm -o two
says 2 '--force'
# What ends all ranks alike, and what ends one of them only.
on 2 die.prm -o short --set 'Solver/Maximum iterations = 2' \
  --set 'Solver/Minimum step = 9e-4'
says 3 'did not converge'
has short/{curve.csv,summary.txt,fields.pvd}
grep -q '"status": "not converged"' short/run.json || fail "short/run.json"
echo 'a file' > file
on 2 die.prm -o file/results
says 4 'file/results'
# A folder that becomes a file while the first rank writes to it.
(
  on 2 die.prm -o lost --no-plots -q --set 'Solver/Maximum step = 1e-3' \
    --set 'Output/Field interval = 1'
  exit "$status"
) &
run=$!
until [ -s lost/fields/step_0002.vtu ]; do
  kill -0 "$run" 2> /dev/null || fail "lost: the run ended too soon"
  sleep 0.05
done
until [ -f lost/fields ]; do
  mv lost/fields "fields_$RANDOM"
  touch lost/fields
done
status=0
wait "$run" || status=$?
says 4 'lost/fields.*results so far'
grep -q '^2,' lost/curve.csv || fail "lost: results so far"
grep -q '"status": "failed"' lost/run.json || fail "lost/run.json"
echo "all well"
