# SPDX-License-Identifier: BSD-3-Clause
# For tests of runs that are killed and go on. Sourced with $command, die or
# probe, and $key_results, how many lines of them run.json has at least.
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# step_of FOLDER: that of its newest checkpoint, 0 if there is none, in $newest.
step_of() {
  local name
  newest=0
  for name in "$1"/checkpoint/step_*.tamp; do
    name=${name##*step_}
    name=$((10#0${name%%[!0-9]*}))
    [ "$name" -le "$newest" ] || newest=$name
  done
}

# kill_after SIGNAL STEP INPUT FOLDER OPTION...: starts a run and sends it the
# signal once there is a checkpoint of the step in the folder, or in $watched;
# its exit code in $status.
kill_after() {
  local signal=$1 step=$2 input=$3 folder=$4 run
  shift 4
  # Gives way to the loop that watches it, however busy the machine is.
  nice "$tamp" "$command" "$input" -o "$folder" --no-plots -q "$@" 2> err.txt &
  run=$!
  until step_of "${watched:-$folder}" && [ "$newest" -ge "$step" ]; do
    kill -0 "$run" 2> /dev/null || break
    sleep 0.002
  done
  kill "-$signal" "$run" 2> /dev/null ||
    fail "$input had ended before step $step"
  status=0
  wait "$run" 2> /dev/null || status=$?
}

# asked_in FOLDER FILE COMMAND...: starts a run and sends it SIGUSR1 once it has
# written the file, after the command.
asked_in() {
  local folder=$1 file=$2 run
  shift 2
  "$tamp" "$command" "${input:-cells}.prm" -o "$folder" --no-plots -q \
    --set 'Output/Checkpoint interval = 0' &
  run=$!
  until [ -s "$folder/$file" ]; do sleep 0.002; done
  "$@"
  kill -USR1 "$run"
  wait "$run" || fail "SIGUSR1: exit code $?"
}

# leaves A B: both folders have the same results, but for times, also of ranks,
# and when checkpoints were written.
leaves() {
  local file
  (cd "$1" && find . -type f ! -path './checkpoint/*' | sort) > first.txt
  (cd "$2" && find . -type f ! -path './checkpoint/*' | sort) > second.txt
  diff first.txt second.txt || fail "$1 and $2 have other files"
  while read -r file; do
    case $command$file in
      *./input.prm | *./log.txt | *./summary.txt | *./run.json) continue ;;
      die./curve.csv)
        grep -q ',wall_time\[s\]$' "$1/$file" || fail "the last column"
        sed '/^#/!s/,[^,]*$//' "$1/$file" > first.curve
        sed '/^#/!s/,[^,]*$//' "$2/$file" > second.curve
        cmp first.curve second.curve || fail "the curves of $1 and $2 differ"
        ;;
      *) cmp "$1/$file" "$2/$file" || fail "$1 and $2 differ in $file" ;;
    esac
  done < first.txt
  for file in "$1" "$2"; do
    sed '1,/"results"/d; /"time_/d; /_rank/d' "$file/run.json" > "$file.json"
  done
  diff "$1.json" "$2.json" || fail "$1 and $2 have other key results"
  [ "$(wc -l < "$1.json")" -ge "$key_results" ] || fail "key results are missing"
}

# spoil WAY FILE: flips a bit of a checkpoint, cuts it off, or makes it one of
# another format.
spoil() {
  case $1 in
    flipped)
      printf 'X' | dd of="$2" bs=1 seek=9000 conv=notrunc status=none
      ;;
    cut) truncate -s -20 "$2" ;;
    format) sed -i '1s/format 1/format 2/' "$2" ;;
  esac
}

# goes_on INPUT FILE TWENTIETH...: a run of INPUT.prm that is killed in its first
# step and at these twentieths of its way, and stopped after 17 of them, leaves
# what it leaves in one go, in INPUT; so does one that is asked for a checkpoint
# once it has written FILE.
goes_on() {
  local input=$1 file=$2 threads=1 last twentieth
  shift 2
  "$tamp" "$command" "$input.prm" -o "$input" --no-plots -q \
    --set 'Output/Checkpoint interval = 0'
  [ ! -e "$input/checkpoint" ] || fail "a checkpoint that nobody asked for"
  last=$(tail -n 1 "$input/curve.csv" | cut -d, -f1)
  # Half-written files are left, too: every step writes one.
  kill_after KILL 1 "$input.prm" killed
  for twentieth; do
    [ "$status" -eq 137 ] || fail "exit code $status"
    threads=$((3 - threads))
    kill_after KILL $((last * twentieth / 20)) "$input.prm" killed \
      --resume --threads $threads
  done
  # SIGTERM writes one, and fields and grains of that step, which later go.
  kill_after TERM $((last * 17 / 20)) "$input.prm" killed --resume
  [ "$status" -eq 143 ] || fail "SIGTERM: exit code $status"
  "$tamp" "$command" "$input.prm" -o killed --no-plots -q --resume
  [ "$(grep -c 'going on after step' killed/log.txt)" -eq $(($# + 2)) ] ||
    fail "log.txt does not tell where the run went on"
  grep -q '"resumed_after_steps"' killed/run.json || fail "run.json"
  [ "$(find killed/checkpoint -type f | wc -l)" -eq 2 ] || fail "the last two"
  leaves "$input" killed
  # SIGUSR1 writes one, and the run goes on.
  asked_in asked "$file" true
  [ "$(find asked/checkpoint -name '*.tamp' | wc -l)" -eq 1 ] ||
    fail "SIGUSR1: no checkpoint"
  leaves "$input" asked
  echo "all well"
}

# refuses STEP SETTING TEXT: of a run of law.prm that was stopped at the step:
# another input, told by TEXT, another command, files and checkpoints that cannot
# be used. Nothing is touched by that; a damaged checkpoint leaves the older one.
refuses() {
  local setting=$2 text=$3 older way other=die
  [ "$command" = probe ] || other=probe
  kill_after TERM "$1" law.prm run
  cp -a run untouched
  untouched() {
    diff -r run untouched || fail "$1: the folder was changed"
  }
  local again=("$tamp" "$command" law.prm --resume --no-plots -q)
  expect 2 'missing' 'not the folder of a run' -- "${again[@]}" -o missing
  [ ! -e missing ] || fail "a folder was made"
  expect 2 '--force' -- "${again[@]}" -o run --force
  expect 2 'the input is not that of the run' "$text" 'Nothing was changed' -- \
    "${again[@]}" -o run --set "$setting"
  untouched "another input"
  expect 2 "one of tamp $command, not of tamp $other" 'Nothing was changed' -- \
    "$tamp" "$other" law.prm --resume --no-plots -q -o run
  untouched "another command"
  # Flipped, cut off, of another format: the older one is used.
  step_of run
  newest=run/checkpoint/$(printf 'step_%04d.tamp' "$newest")
  older=$(find run/checkpoint -name '*.tamp' ! -path "$newest")
  has "$newest" "$older"
  "$tamp" "$command" law.prm -o whole --no-plots -q
  for way in flipped cut format; do
    rm -rf run && cp -a untouched run
    spoil $way "$newest"
    "${again[@]}" -o run --set 'Output/Checkpoint interval = 1 h' > /dev/null ||
      fail "$way: exit code $?"
    grep -q "warning: the checkpoint '$newest' cannot be used" run/log.txt ||
      fail "$way: log.txt does not tell"
    grep -q "going on after step.*$older" run/log.txt ||
      fail "$way: the older one was not used"
    sed -i '/"warnings"/,/\],/d' run/run.json
    leaves whole run
  done
  rm -rf run && cp -a untouched run
  truncate -s 100 run/curve.csv
  expect 4 'curve.csv' 'cannot be continued' -- "${again[@]}" -o run
  rm -rf run && cp -a untouched run
  spoil flipped "$newest"
  spoil format "$older"
  rm -rf untouched && cp -a run untouched
  expect 4 "$newest" "$older" 'damaged' 'format 2' 'Nothing was changed' -- \
    "${again[@]}" -o run
  rm -rf run/checkpoint untouched/checkpoint
  expect 2 'no checkpoint' 'run/checkpoint' -- "${again[@]}" -o run
  untouched "no checkpoint"
  [ "$failures" -eq 0 ] || exit 1
  echo "all well"
}
