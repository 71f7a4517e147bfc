#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tamp inspect replays a point of a die from what the run has recorded: through
# cut steps, unloading and ejection, of runs that were killed or failed; what it
# cannot look into it refuses. Usage: inspect.sh TAMP [replay|ended|refused|damaged]
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"
part=$2

# Steps so long that many are cut.
cat > die.prm << 'END_OF_INPUT'
include granules_die.prm
subsection Solver
  set First step             = 2e-2
  set Maximum step           = 2e-2
  set Maximum unloading step = 4e-3
  set Maximum iterations     = 3
end
subsection Output
  set Grain points   = 5
  set Grain interval = 1
end
END_OF_INPUT
run() { "$tamp" die die.prm -q --no-plots "$@"; }
look() { "$tamp" inspect "$@" -q --no-plots; }
# columns FILE: what was recorded of a point, characters untouched.
columns() {
  awk -F, '/^#/ { next }
    !found { for (i = 1; i <= NF; ++i) place[$i] = i
      found = split("step stage relative_F_xx[-] relative_F_xy[-] " \
        "relative_F_xz[-] relative_F_yx[-] relative_F_yy[-] " \
        "relative_F_yz[-] relative_F_zx[-] relative_F_zy[-] " \
        "relative_F_zz[-] stress_xx[Pa] stress_yy[Pa] stress_zz[Pa] " \
        "stress_yz[Pa] stress_xz[Pa] stress_xy[Pa] relative_density[-]",
        name, " ")
      for (i = 1; i <= found; ++i) if (!place[name[i]]) exit 1
      next }
    $1 > 0 { line = $1
      for (i = 2; i <= found; ++i) line = line "," $place[name[i]]
      print line }' "$1" || fail "$1 lacks a column"
}

if [ "$part" = replay ]; then
  run -o result --threads 2
  [ "$(result result 'cut_attempts[-]')" != 0.0 ] || fail "no step was cut"
  look result --cell 1 --point 1 --step all || fail "exit code $?"
  point=result/inspect/cell_1_point_5
  # The same history, character by character, and the same grains, to the byte.
  columns result/grains/point_0005.csv > die.txt
  columns $point/curve.csv > point.txt
  cmp die.txt point.txt || fail "the replay has another history"
  [ "$(cut -d, -f2 die.txt | uniq | tr '\n' ' ')" = '1 2 3 ' ] ||
    fail "the path has other stages than pressing, unloading, ejection"
  for picture in result/grains/point_0005_step_*.vtp; do
    cmp "$picture" "$point/grains/${picture#*point_0005_}" ||
      fail "the replay has other grains"
  done
  [ "$(find $point/grains -name '*.vtp' | wc -l)" -gt 20 ] || fail "few steps"
  [ "$(result $point 'steps_with_other_bits[-]')" = 0.0 ] || fail "other bits"
  # One picture, of the last step or of the one that is asked for.
  look result --point 5 -o last
  look result --cell 1 --point 5 --step 7 -o seventh
  [ "$(ls seventh/grains)" = step_0007.vtp ] || fail "--step 7"
  last=$(tail -n 1 result/curve.csv | cut -d, -f1)
  [ "$(ls last/grains)" = "$(printf 'step_%04d.vtp' "$last")" ] || fail "last"
  grep -q '"grains/step_0007.vtp"' seventh/grains.pvd || fail "grains.pvd"

  # Other grains than those of the run are found out.
  "$tamp" pack die.prm -o packed -q --no-plots --set 'Packing/Replicas = 2'
  mkdir elsewhere
  (cd elsewhere && "$tamp" die ../die.prm -o ../stored -q --no-plots \
    --set 'Packing/Source = file' --set 'Packing/File = ../packed')
  look stored --point 3 || fail "stored packings: exit code $?"
  cp packed/packing_0001.h5 packed/packing_0002.h5
  expect 5 'other stresses than the run' 'step 0' -- \
    "$tamp" inspect stored --point 3 -q --no-plots --force
  [ "$failures" -eq 0 ] || exit 1
fi

if [ "$part" = ended ]; then
  run -o whole
  # Killed and resumed, on another number of threads: the same record.
  run -o killed --set 'Output/Checkpoint interval = 1 us' --threads 2 \
    2> err.txt &
  process=$!
  until [ -e killed/checkpoint/step_0009.tamp ]; do
    kill -0 $process || fail "the run ended before step 9"
    sleep 0.002
  done
  kill -KILL $process
  wait $process && fail "the run was not killed"
  look killed --point 6 || fail "killed: exit code $?"
  reached=$(result killed/inspect/cell_1_point_6 'steps[-]')
  [ "${reached%.*}" -ge 9 ] || fail "killed: $reached steps"
  run -o killed --resume --threads 1 \
    --set 'Output/Checkpoint interval = 1 us'
  cmp whole/trials.tamp killed/trials.tamp || fail "resumed: another record"
  look killed --point 6 --force || fail "resumed: exit code $?"
  # A step that was written half is passed over.
  look whole --point 2
  truncate -s -30 whole/trials.tamp
  look whole --point 2 -o cut || fail "cut off: exit code $?"
  steps=$(result whole/inspect/cell_0_point_2 'steps[-]')
  [ "$(result cut 'steps[-]')" = "$((${steps%.*} - 1)).0" ] || fail "cut off"
  # A run that failed, up to the attempts that it gave up.
  status=0
  run -o failed --set 'Solver/Minimum step = 1.9e-2' 2> err.txt || status=$?
  [ "$status" -eq 3 ] || fail "the run did not fail: exit code $status"
  look failed --point 2 || fail "failed: exit code $?"
  grep -q 'warning  *the run did not get over step' \
    failed/inspect/cell_0_point_2/summary.txt || fail "failed: not said"
  # No room for the record: the run goes on, and has what fits.
  (
    trap '' XFSZ
    ulimit -f 30
    export PMIX_MCA_gds=hash # MPI's shared memory is a larger file
    run -o full
  ) || fail "no room: exit code $?"
  grep -q "warning  *.full/trials.tamp. cannot be written" full/summary.txt ||
    fail "no room: not said"
  look full --point 2 || fail "no room: exit code $?"
  some=$(result full/inspect/cell_0_point_2 'steps[-]')
  [ "${some%.*}" -gt 0 ] && [ "${some%.*}" -lt "${steps%.*}" ] ||
    fail "no room: $some of $steps steps"
fi

if [ "$part" = refused ]; then
  run -o result
  find result | sort > before.txt
  inspect=("$tamp" inspect)
  expect 2 'RESULT' -- "${inspect[@]}"
  expect 2 '--point' -- "${inspect[@]}" result --cell 1
  expect 2 'missing' 'not the folder of a run' -- \
    "${inspect[@]}" missing --point 1
  expect 2 '--cell 2' 'from 0 to 1' -- "${inspect[@]}" result --cell 2 --point 0
  expect 2 '--cell -1' 'from 0 to 1' -- \
    "${inspect[@]}" result --cell -1 --point 0
  expect 2 '--point 8' 'from 0 to 7' -- "${inspect[@]}" result --point 8
  expect 2 '--point 8' 'from 0 to 3' 'from 4 to 7' -- \
    "${inspect[@]}" result --cell 1 --point 8
  expect 2 '--point 4' 'cell 0' -- "${inspect[@]}" result --cell 0 --point 4
  expect 2 '--step 9999' 'from 0 to' -- \
    "${inspect[@]}" result --point 1 --step 9999
  expect 2 '--step last' 'or all' -- \
    "${inspect[@]}" result --point 1 --step last
  # No results are overwritten unasked, those of the run least of all.
  expect 2 'result/input.prm' -- \
    "${inspect[@]}" result --point 1 -o result --force
  find result | sort > after.txt
  cmp before.txt after.txt || fail "files were written"
  look result --point 1
  expect 2 'cell_0_point_1' '--force' -- "${inspect[@]}" result --point 1
  expect 2 'tamp inspect' 'tamp die' -- \
    "${inspect[@]}" result/inspect/cell_0_point_1 --point 1
  [ "$failures" -eq 0 ] || exit 1
fi

if [ "$part" = damaged ]; then
  run -o result
  # A bit that is another, anywhere; an input that is; nothing at all.
  cp -a result flipped
  inspect=("$tamp" inspect)
  size=$(stat -c %s result/trials.tamp)
  for place in 3 500 $((size / 2)) $((size - 40)); do
    cp result/trials.tamp flipped
    byte=$(od -An -tu1 -j "$place" -N 1 flipped/trials.tamp)
    printf "\\$(printf %o $((byte ^ 4)))" |
      dd of=flipped/trials.tamp bs=1 seek="$place" conv=notrunc status=none
    expect 4 'flipped/trials.tamp' -- "${inspect[@]}" flipped --point 0
  done
  cp result/trials.tamp flipped
  look flipped --point 0 || fail "the copy is not whole"
  sed -i 's/set Seed .*/set Seed = 2/' flipped/input.prm
  expect 2 'flipped/input.prm' 'Packing/Seed = 2, was 1' -- \
    "${inspect[@]}" flipped --point 2
  rm flipped/trials.tamp
  cp result/input.prm flipped
  expect 2 'flipped/trials.tamp' 'missing' -- "${inspect[@]}" flipped --point 2
  "$tamp" die die.prm -o law -q --no-plots --set 'Material/Type = elastic' \
    --set 'Schedule/Stages = press to density 0.65' \
    --set 'Solver/Maximum iterations = 20'
  [ ! -e law/trials.tamp ] || fail "trials of a continuum"
  expect 2 'law' 'continuum' 'elastic' -- "${inspect[@]}" law --point 2
  [ "$failures" -eq 0 ] || exit 1
fi
echo "all well"
