#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Dies of cells that are killed (SIGKILL) and resumed, ten times each: at random
# moments of their CPU time, and while they write a checkpoint, which they do
# after every step. Prints a table of each; ends with 1 if a run does not go on
# from its newest checkpoint, or if its results are not, byte for byte, those of
# an uninterrupted one. A few minutes.
#
#   [TAMP=PROGRAM] tests/studies/kills.sh [SEED]
#
# A line is a life of the run: how long it was, after which step it went on (-:
# killed before that), and, when it was killed, the last step of curve.csv, that
# of the newest checkpoint and the bytes of an unfinished one that was left.
source "$(dirname "$0")/common.sh"
shopt -s nullglob
random=${1:-1}
kills=10
cd "$scratch"

# A die of 16 cells, which are stored after every step.
cat > often.prm << END
subsection Die
  set Elements = 2, 2
end
subsection Output
  set Checkpoint interval = 1 us
  set Grain points        = 0, 5
end
END
# It is pressed, unloaded and ejected.
cat > loose.prm << END
include $root/tests/apps/granules.prm
include often.prm
subsection Schedule
  set Stages = press to density 0.7; unload to 30 % of peak; eject by 0.1 mm holding 30 % of peak
end
subsection Solver
  set Maximum step           = 5e-4
  set Maximum unloading step = 2e-4
end
END
# Grains that hold together leave the die, too.
cat > cohesive.prm << END
include $root/apps/examples/die_cohesive/die_cohesive.prm
include often.prm
subsection Grains
  set Count = 60
end
subsection Schedule
  set Stages = press to density 0.66; unload to nothing; eject to out
end
subsection Solver
  set Maximum step           = 2e-3
  set Maximum unloading step = 5e-4
end
END

fail() {
  echo "FAILED: $*"
  exit 1
}

# A whole number below $1 in $drawn (Lehmer; Park & Miller 1988).
draw() {
  random=$((random * 48271 % 2147483647))
  drawn=$((random * $1 / 2147483647))
}

# CPU time of the run in $ticks, of 10 ms, since it was $start; fails if it has
# ended.
count_ticks() {
  local fields
  read -r fields 2> /dev/null < "/proc/$run/stat" || return 1
  read -ra fields <<< "${fields##*) }"
  ticks=$((fields[11] + fields[12] - start))
}

# The step of the newest checkpoint of $folder in $newest; -: none.
find_newest() {
  local checkpoints=("$folder"/checkpoint/step_*.tamp)
  newest=-
  [ ${#checkpoints[@]} -eq 0 ] || newest=${checkpoints[-1]##*step_}
  [ "$newest" = - ] || newest=$((10#${newest%.tamp}))
}

# How often log.txt says it.
said() {
  cat "$folder/log.txt" 2> /dev/null | grep -c "$1" || true
}

# begin: $folder goes on if it has a checkpoint, else begins; process in $run.
begin() {
  local how=--resume
  find_newest
  [ "$newest" != - ] || how=
  [ "$newest" != - ] || rm -rf "$folder"
  from=$newest
  resumed=$(said 'going on after step')
  pressed=$(said 'pressing .* points')
  start=0
  nice -n 10 "$tamp" die "$input.prm" -o "$folder" -q --no-plots --threads 1 \
    $how &
  run=$!
}

# From now on CPU time counts from when the run has its packings.
await_pressing() {
  until [ "$(said 'pressing .* points')" -gt "$pressed" ]; do
    sleep 0.01
  done
  count_ticks || fail "the run had ended"
  start=$ticks
}

# went_on: after which step the run did, in $after; it must be the newest.
went_on() {
  after=-
  [ "$(said 'going on after step')" != "$resumed" ] || return 0
  after=$(sed -n 's/.*going on after step \([0-9]*\).*/\1/p' \
    "$folder/log.txt" | tail -n 1)
  [ "$after" = "$from" ] || fail "went on after step $after, not $from"
}

# end_life NUMBER: kills the run and prints its line.
end_life() {
  local parts left=- reached=-
  count_ticks || fail "the run had ended"
  kill -KILL "$run" || fail "the run had ended"
  wait "$run" 2> /dev/null || true
  parts=("$folder"/checkpoint/*.part)
  if [ ${#parts[@]} -gt 0 ]; then
    left=$(stat -c %s "${parts[@]}")
    unfinished=$((unfinished + 1))
  fi
  [ ! -s "$folder/curve.csv" ] ||
    reached=$(grep -v '^#' "$folder/curve.csv" | tail -n 1 | cut -d, -f1)
  went_on
  find_newest
  echo "| $1 | $((ticks * 10)) | $after | $reached | $newest | $left |"
}

# The lengths of the lives: between ten moments of the CPU time of pressing, but
# for its last fifth, as every life is a little longer: its start is seen late.
draw_lives() {
  local kill moment last=0
  lives=()
  for kill in $(seq $kills); do
    draw $((whole * 4 / 5))
    echo "$drawn"
  done | sort -n > moments
  while read -r moment; do
    lives+=($((moment - last)))
    last=$moment
  done < moments
}

# at_moments NUMBER: a life that ends at a random moment.
at_moments() {
  [ ${#lives[@]} -gt 0 ] || draw_lives
  begin
  await_pressing
  while count_ticks && [ "$ticks" -lt "${lives[$1 - 1]}" ]; do
    sleep 0.002
  done
  end_life "$1"
}

# while_writing NUMBER: a life that ends as a checkpoint is begun, the first one of its
# life or one a tenth of the steps later than that of the life before.
while_writing() {
  local step=$((steps * ($1 - 1) / kills)) parts=()
  begin
  [ "$1" -lt 3 ] || until find_newest && [ "${newest/-/-1}" -ge "$step" ]; do
    count_ticks || fail "the run had ended"
    sleep 0.005
  done
  while [ ${#parts[@]} -eq 0 ]; do
    parts=("$folder"/checkpoint/*.part)
  done
  end_life "$1"
}

# results FOLDER: the names of all files of the run but its checkpoints.
results() {
  (cd "$1" && find . -type f ! -path './checkpoint/*' | sort)
}

# compare: the results must be those of the uninterrupted run.
compare() {
  local file count=0
  diff <(results whole) <(results "$folder") || fail "other files"
  for file in $(results whole); do
    case $file in
      ./log.txt | ./summary.txt | ./run.json | ./input.prm) continue ;;
      ./curve.csv) # but for its last column, wall_time
        cmp <(sed '/^#/!s/,[^,]*$//' whole/curve.csv) \
          <(sed '/^#/!s/,[^,]*$//' "$folder/curve.csv") || fail "$file"
        ;;
      *) cmp "whole/$file" "$folder/$file" || fail "$file" ;;
    esac
    count=$((count + 1))
  done
  diff <(sed '1,/"results"/d; /"time_/d' whole/run.json) \
    <(sed '1,/"results"/d; /"time_/d' "$folder/run.json") || fail "key results"
  echo "Key results and $count files are those of the uninterrupted run:" \
    "curve.csv, trials.tamp," \
    "$(results "$folder" | grep -c fields/) fields," \
    "$(results "$folder" | grep -c grains/) of grains."
}

for input in loose cohesive; do
  rm -rf whole
  folder=whole
  begin
  await_pressing
  while count_ticks; do sleep 0.01; done
  wait "$run" || fail "$input: exit code $?"
  whole=$ticks
  steps=$(tail -n 1 whole/curve.csv | cut -d, -f1)
  echo
  echo "$input.prm: $steps steps in $((whole * 10)) ms of CPU time"
  lives=()
  for way in at_moments while_writing; do
    folder=$way
    rm -rf "$way"
    unfinished=0
    echo
    echo "| killed $way | after ms | went on after | step | newest | part |"
    echo "|---|---|---|---|---|---|"
    for kill in $(seq $kills); do
      $way "$kill"
    done
    begin
    wait "$run" || fail "the last life: exit code $?"
    went_on
    echo
    echo "$unfinished of $kills left an unfinished checkpoint; the last life went" \
      "on after step $after."
    compare
  done
done
