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
  "$tamp" "$command" "$input" -o "$folder" --no-plots -q "$@" 2> err.txt &
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
