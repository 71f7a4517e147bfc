#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A probe that was killed, stopped or had its checkpoints damaged goes on with
# --resume and leaves what an uninterrupted one leaves, scans and all; what cannot
# be resumed is refused, and touched by nothing.
# Usage: resume_probe.sh TAMP [cells|law|replicas|refused]
command=probe key_results=9
source "$(dirname "${BASH_SOURCE[0]}")/resumed.sh"
part=$2

cat > cells.prm << 'END_OF_INPUT'
include granules.prm
subsection Path
  set Stages = uniaxial to density 0.7; unload to 30 % of peak; isotropic to density 0.71
end
subsection Scan
  set Densities          = 0.68, 0.7
  set Compression shares = 0.3
  set Triaxial shares    =
  set Uniaxial shares    =
end
subsection Output
  set Checkpoint interval = 1 us
end
END_OF_INPUT
cat > law.prm << 'END_OF_INPUT'
subsection Material
  set Type = drucker-prager cap
end
subsection Path
  set Stages = uniaxial to density 0.5; unload to 30 % of peak; simple shear to strain 0.05; triaxial by strain 0.02 at pressure 10 MPa
  set Maximum strain increment    = 4e-3
  set Maximum unloading increment = 5e-4
end
subsection Scan
  set Densities = 0.36, 0.38, 0.4, 0.42, 0.44, 0.46, 0.48
end
subsection Output
  set Checkpoint interval = 1 us
end
END_OF_INPUT

if [ "$part" = cells ] || [ "$part" = law ]; then
  input=$part
  "$tamp" probe $input.prm -o $input --no-plots -q \
    --set 'Output/Checkpoint interval = 0'
  [ ! -e $input/checkpoint ] || fail "a checkpoint that nobody asked for"
  has $input/yield.csv $input/moduli.csv
  last=$(tail -n 1 $input/curve.csv | cut -d, -f1)
  # At places all along the way, the first of them in the first step.
  kill_after KILL 1 $input.prm killed
  for twentieth in 5 9 13; do
    [ "$status" -eq 137 ] || fail "exit code $status"
    kill_after KILL $((last * twentieth / 20)) $input.prm killed \
      --resume --threads $((twentieth % 4 / 2 + 1))
  done
  # SIGTERM writes one, and the grains of that step, which later go.
  kill_after TERM $((last * 17 / 20)) $input.prm killed --resume
  [ "$status" -eq 143 ] || fail "SIGTERM: exit code $status"
  "$tamp" probe $input.prm -o killed --no-plots -q --resume
  [ "$(grep -c 'going on after step' killed/log.txt)" -eq 5 ] ||
    fail "log.txt does not tell where the run went on"
  [ "$(find killed/checkpoint -type f | wc -l)" -eq 2 ] || fail "the last two"
  leaves $input killed
  # SIGUSR1 writes one, and the run goes on; also one that still packs.
  asked_in asked run.json true
  [ "$(find asked/checkpoint -name '*.tamp' | wc -l)" -eq 1 ] ||
    fail "SIGUSR1: no checkpoint"
  leaves $input asked
  echo "all well"
fi

# Each of several cells goes on from its own checkpoint.
if [ "$part" = replicas ]; then
  sed -i 's/Densities .*/Densities = 0.7/' cells.prm
  several=(--replicas 2 --threads 2)
  "$tamp" probe cells.prm -o whole --no-plots -q "${several[@]}"
  watched=killed/size_00060_seed_2
  kill_after KILL 12 cells.prm killed "${several[@]}"
  watched=killed/size_00060_seed_1
  kill_after TERM 16 cells.prm killed "${several[@]}" --resume
  [ "$status" -eq 143 ] || fail "SIGTERM: exit code $status"
  "$tamp" probe cells.prm -o killed --no-plots -q "${several[@]}" --resume
  for seed in 1 2; do
    grep -q 'going on after step' killed/size_00060_seed_$seed/log.txt ||
      fail "the cell of seed $seed began anew"
  done
  (cd whole && find . -name '*.csv' -o -name '*.vtp') | while read -r file; do
    cmp "whole/$file" "killed/$file" || exit 1
  done || fail "the killed run ends otherwise"
  # Killed as it began.
  rm -r killed/size_00060_seed_2/*
  touch killed/size_00060_seed_2/run.json.part
  "$tamp" probe cells.prm -o killed --no-plots -q "${several[@]}" --resume
  cmp {whole,killed}/size_00060_seed_2/curve.csv || fail "a cell that began anew"
  expect 2 '--replicas' 'Nothing was changed' -- \
    "$tamp" probe cells.prm -o killed --no-plots -q --resume
  [ "$failures" -eq 0 ] || exit 1
  echo "all well"
fi

if [ "$part" = refused ]; then
  kill_after TERM 60 law.prm run
  cp -a run untouched
  untouched() {
    diff -r run untouched || fail "$1: the folder was changed"
  }
  again=("$tamp" probe law.prm --resume --no-plots -q)
  expect 2 'missing' 'not the folder of a run' -- "${again[@]}" -o missing
  [ ! -e missing ] || fail "a folder was made"
  expect 2 '--force' -- "${again[@]}" -o run --force
  expect 2 'the input is not that of the run' 'Scan/Strain offset' \
    'Nothing was changed' -- \
    "${again[@]}" -o run --set 'Scan/Strain offset = 1e-3'
  untouched "another input"
  expect 2 'one of tamp probe, not of tamp die' 'Nothing was changed' -- \
    "$tamp" die law.prm --resume --no-plots -q -o run
  untouched "another command"
  # Flipped, cut off, of another format: the older one is used.
  step_of run
  newest=run/checkpoint/$(printf 'step_%04d.tamp' "$newest")
  older=$(find run/checkpoint -name '*.tamp' ! -path "$newest")
  has "$newest" "$older"
  "$tamp" probe law.prm -o whole --no-plots -q
  for way in flipped cut format; do
    rm -rf run && cp -a untouched run
    spoil $way "$newest"
    "${again[@]}" -o run > /dev/null || fail "$way: exit code $?"
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
  rm -rf run/checkpoint untouched/checkpoint
  expect 2 'no checkpoint' 'run/checkpoint' -- "${again[@]}" -o run
  untouched "no checkpoint"
  [ "$failures" -eq 0 ] || exit 1
  echo "all well"
fi
