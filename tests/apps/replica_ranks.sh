#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Several cells give the same on any number of ranks, to the bit, also when the
# run was stopped or killed and goes on with another number, and what ends one
# rank ends all. Usage: replica_ranks.sh TAMP same|resume|ends
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
export OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1
export OPENBLAS_NUM_THREADS=1

cat > cells.prm << 'END'
include granules.prm
subsection Path
  set Stages = uniaxial to density 0.7; unload to 30 % of peak; isotropic to density 0.71
end
subsection Output
  set Checkpoint interval = 1 us
  set Grain interval      = 20
end
END
options=(--replicas 2 --sizes 40,60 --no-plots)

# start RANKS FOLDER OPTION...: one rank without mpirun; the process in $run.
start() {
  local folder=$2 launcher=(mpirun -np "$1")
  [ "$1" -gt 1 ] || launcher=()
  shift 2
  "${launcher[@]}" "$tamp" probe cells.prm -o "$folder" "${options[@]}" \
    "$@" > out.txt 2> err.txt &
  run=$!
}
# on RANKS FOLDER OPTION...: the run to its end; the exit code in $status.
on() {
  start "$@"
  status=0
  wait "$run" || status=$?
}
# done_on RANKS FOLDER OPTION...: one that must end well.
done_on() {
  on "$@"
  [ "$status" -eq 0 ] || { cat err.txt; fail "$2: exit code $status"; }
}
# says COUNT TEXT: the last run spoke so often, and said so.
says() {
  [ "$(grep -c '^tamp: ' err.txt)" -eq "$1" ] ||
    { cat err.txt; fail "expected $1 messages"; }
  grep -q "^tamp: .*$2" err.txt || { cat err.txt; fail "no '$2'"; }
}
# same A B: the folders hold the same, but for times, ranks and when
# checkpoints are written.
same() {
  local file
  (cd "$1" && find . -type f ! -path '*/checkpoint/*' | sort) > first.txt
  (cd "$2" && find . -type f ! -path '*/checkpoint/*' | sort) > second.txt
  diff first.txt second.txt || fail "$1 and $2 have other files"
  while read -r file; do
    case $file in
      */input.prm | */log.txt | */summary.txt) continue ;;
      */run.json)
        for folder in "$1" "$2"; do
          sed "1,/\"status\"/d; /\"time_/d; s/$folder/FOLDER/" \
            "$folder/$file" > "$folder.json"
        done
        cmp "$1.json" "$2.json" || fail "$1 and $2: other results in $file"
        ;;
      *) cmp "$1/$file" "$2/$file" || fail "$1 and $2 differ in $file" ;;
    esac
  done < first.txt
}

if [ "$2" = same ]; then
  scan=(--set 'Scan/Densities = 0.68' --set 'Scan/Compression shares = 0.3'
    --set 'Scan/Triaxial shares =' --set 'Scan/Uniaxial shares ='
    --set 'Output/Checkpoint interval = 0')
  done_on 1 one --threads 1 "${scan[@]}"
  has one/{replicas,curve,yield,moduli}.csv one/size_00040_seed_2/grains.pvd
  # Also with threads in a rank, and with more ranks than there is work for.
  for run in '2 1' '2 2' '5 1'; do
    set -- $run
    done_on "$1" "ranks_$1_$2" --threads "$2" "${scan[@]}"
    [ ! -s err.txt ] || { cat err.txt; fail "$1 ranks: a message"; }
    [ "$(grep -c 'Results are in' out.txt)" -eq 1 ] || fail "$1 summaries"
    [ "$(grep -c '^size_.* on rank ' out.txt)" -eq 4 ] || fail "progress"
    same one "ranks_$1_$2"
  done
  # Each rank takes a cell as it begins.
  for rank in 0 1; do
    grep -q "size_.* on rank $rank" ranks_2_1/log.txt || fail "idle rank $rank"
  done
  grep -q '"ranks": 2' ranks_2_1/run.json || fail "run.json"
  # What only the first rank, or only the second one, cannot write.
  rm ranks_2_1/replicas.csv && mkdir ranks_2_1/replicas.csv
  on 2 ranks_2_1 --threads 1 "${scan[@]}" --resume
  [ "$status" -eq 4 ] || fail "replicas.csv: exit code $status"
  says 1 'ranks_2_1/replicas.csv'
  rm -r ranks_2_1/{replicas.csv,size_00060_seed_1}
  touch ranks_2_1/size_00060_seed_1
  on 2 ranks_2_1 --threads 1 "${scan[@]}" --resume
  [ "$status" -eq 4 ] || fail "a cell's folder: exit code $status"
  says 1 'size_00060_seed_1. is a file'
  echo "all well"
fi

# stored FOLDER: the names of its checkpoints, the newest last.
stored() {
  (cd "$1/checkpoint" 2> /dev/null && ls) || true
}
# under_way CELL...: waits until all these cells of folder "stopped" have taken
# ten steps.
under_way() {
  local cell
  for cell in "$@"; do
    until [[ $(stored "stopped/$cell" | tail -n 1) > step_0010 ]]; do
      kill -0 "$run" 2> /dev/null || { cat err.txt; fail "ended too soon"; }
      sleep 0.002
    done
  done
}
# tell SIGNAL RANK: to that rank only.
tell() {
  local pid told=''
  for pid in $(pgrep -P "$run" -x tamp); do
    if grep -qz "^OMPI_COMM_WORLD_RANK=$2$" "/proc/$pid/environ"; then
      kill "-$1" "$pid"
      told=yes
    fi
  done
  [ -n "$told" ] || fail "there is no rank $2"
}

if [ "$2" = resume ]; then
  options+=(--set 'Path/Maximum strain increment = 1e-3')
  done_on 1 whole --threads 2 --set 'Output/Checkpoint interval = 0'
  # What one rank is told all do: the first two cells are the largest.
  start 2 stopped --threads 1
  under_way size_00060_seed_{2,1}
  tell TERM 1
  status=0
  wait "$run" || status=$?
  [ "$status" -eq 143 ] || { cat err.txt; fail "SIGTERM: exit code $status"; }
  for folder in stopped stopped/size_00060_seed_{1,2}; do
    grep -q '"status": "interrupted"' "$folder/run.json" ||
      fail "$folder was not interrupted"
  done
  [ ! -e stopped/size_00040_seed_1 ] || fail "a cell began after the signal"
  # Killed with another number of ranks.
  start 1 stopped --threads 2 --resume
  under_way size_00040_seed_2
  kill -KILL "$run"
  wait "$run" 2> /dev/null && fail "not killed"
  done_on 3 stopped --threads 1 --resume
  grep -q 'going on after step' stopped/size_00060_seed_1/log.txt ||
    fail "a cell began anew"
  same whole stopped
  # SIGUSR1 asks the cells of all ranks for checkpoints, and the run goes on.
  options+=(--set 'Output/Checkpoint interval = 0')
  start 2 asked --threads 1
  until [ -s asked/size_00060_seed_2/run.json ]; do sleep 0.002; done
  tell USR1 1
  wait "$run" || fail "SIGUSR1 ended the run"
  for rank in 0 1; do
    cells=$(sed -n "s/.* \(size_.*\) on rank $rank/\1/p" asked/log.txt)
    for cell in $cells; do
      stored "asked/$cell"
    done > found.txt
    [ -s found.txt ] || fail "SIGUSR1: no checkpoint on rank $rank"
  done
  same whole asked
  echo "all well"
fi

# same_end CODE OPTION...: one rank and two end so, with the same words.
same_end() {
  local code=$1 ranks
  shift
  for ranks in 1 2; do
    rm -rf "on_$ranks"
    on "$ranks" "on_$ranks" --threads 1 "$@"
    [ "$status" -eq "$code" ] ||
      { cat err.txt; fail "$*: code $status on $ranks ranks, not $code"; }
    grep "^tamp: " err.txt | sed "s/on_$ranks/FOLDER/g" | sort \
      > "end_$ranks.txt"
  done
  cmp end_1.txt end_2.txt || { cat end_?.txt; fail "$*: other words"; }
}
if [ "$2" = ends ]; then
  # A cell of the second rank that cannot begin.
  options=(--no-plots)
  same_end 2 --sizes 10,60
  says 1 'Grains/Count = 10'
  # One that is too dense for its scan; the others and their mean are kept.
  options=(--replicas 2 --no-plots)
  same_end 2 --set 'Scan/Densities = 0.59'
  says 2 'seed_2 did not end well'
  grep -q '1 of 2 cells did not come to the end' on_2/summary.txt ||
    fail "a mean that hides a cell"
  same on_1 on_2
  [ "$(grep -vc '^[#s]' on_2/curve.csv)" -eq 1 ] || fail "the mean of the start"
  peak=$(awk -F, '$2 == 1 { print $6 }' on_2/replicas.csv)
  grep -q "\"peak_axial_stress_60\[Pa\]\": $peak" on_2/run.json ||
    fail "the peak is not that of the cell that ended"
  # None that can be packed: no curve at all.
  same_end 3 --set 'Packing/Pressure = 3 GPa'
  says 3 'seed_1 did not end well'
  # What all ranks refuse, one says; nothing is written.
  on 2 on_1
  [ "$status" -eq 2 ] || fail "a folder that is there: exit code $status"
  says 1 'on_1.*exists already'
  on 2 law --set 'Material/Type = elastic'
  [ "$status" -eq 2 ] || fail "a law: exit code $status"
  says 1 '--replicas'
  options=()
  on 2 alone
  [ "$status" -eq 2 ] || fail "a probe alone: exit code $status"
  says 1 'without --replicas or --sizes runs on one rank'
  [ ! -e alone ] || fail "a probe of two ranks makes a folder"
  echo "all well"
fi
