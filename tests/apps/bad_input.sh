#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Wrong inputs, options and folders end with the exit code and the message that
# users are promised. Usage: bad_input.sh TAMP
set -euo pipefail
export LC_ALL=C

tamp=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failures=0

# expect CODE TEXT... -- COMMAND: the exit code, and one message on stderr with
# all the texts.
expect() {
  local code=$1 texts=() status=0
  shift
  while [ "$1" != -- ]; do
    texts+=("$1")
    shift
  done
  shift
  "$@" > out.txt 2> err.txt || status=$?
  local wrong=''
  [ "$status" -eq "$code" ] || wrong="exit code $status, expected $code"
  [ "$(wc -l < err.txt)" -eq 1 ] || wrong+="; expected exactly one message"
  for text in "${texts[@]}"; do
    grep -qF -- "$text" err.txt || wrong+="; the message lacks '$text'"
  done
  if [ -n "$wrong" ]; then
    echo "FAILED: $*: $wrong"
    sed 's/^/  stderr: /' err.txt
    failures=$((failures + 1))
  else
    echo "passed: $(head -c 200 err.txt)"
  fi
}

# input TEXT: a probe of a quick law with TEXT in front.
input() {
  printf '%s\n' "$1" > bad.prm
  printf 'subsection Material\n  set Type = elastic\nend\n' >> bad.prm
}
in_section() {
  input "$(printf 'subsection %s\n  set %s\nend' "$1" "$2")"
}
run() {
  expect "$@" -- "$tamp" probe bad.prm -o results
}

in_section Contact 'Limiting presure = 50 MPa'
run 2 'bad.prm:2' 'Limiting presure' 'Limiting contact pressure'
in_section Contct 'Friction coefficient = 0.3'
run 2 'bad.prm:1' 'Contct' "'Contact'"
in_section Contact 'Limiting contact pressure = 50 mm'
run 2 'bad.prm:2' '50 mm' 'a length' 'a pressure'
in_section Contact 'Limiting contact pressure = 50 MPaa'
run 2 'bad.prm:2' 'MPaa' 'a pressure'
in_section Grains "Young's modulus = -70 GPa"
run 2 'bad.prm:2' '-70 GPa' '> 0'
in_section Grains "Poisson's ratio = 0.5"
run 2 'bad.prm:2' '0.5' '< 0.5'
in_section Contact 'Limiting contact pressure = 0 Pa'
run 2 'bad.prm:2' '> 0'
in_section Contact 'Limiting contact pressure = -1 MPa'
run 2 'bad.prm:2' '-1 MPa' '> 0'
in_section Contact 'Normal law = herz'
run 2 'bad.prm:2' 'herz' 'hertz'
in_section Path 'Stages = uniaxial to stain 0.1'
run 2 'bad.prm:2' 'stain' 'strain'
in_section Path 'Stages = csv nowhere.csv'
run 2 'bad.prm:2' 'nowhere.csv'
input 'set Count = 5'
run 2 'bad.prm:1' 'Count' "'Grains'"
input 'subsection Grains'
run 2 'bad.prm:1' "no 'end'"
input 'sett Count = 5'
run 2 'bad.prm:1' 'sett'
[ ! -e results ] || { echo "FAILED: results were written"; exit 1; }

printf 'subsection Material\n  set Type = unit sell\nend\n' > bad.prm
run 2 'bad.prm:2' 'unit sell' 'unit cell'

input ''
expect 2 'Packing/Seed' -- \
  "$tamp" probe bad.prm -o results --set 'Packing/Seed = many'
expect 2 '--set' "'Packing'" -- \
  "$tamp" probe bad.prm -o results --set 'Paking/Seed = 2'
expect 2 'threads' -- "$tamp" probe bad.prm -o results --threads 0
expect 2 'missing.prm' -- "$tamp" probe missing.prm -o results
expect 2 'a command' 'die, probe' -- "$tamp"
expect 2 "'dye'" "'die'" -- "$tamp" dye bad.prm
expect 2 '--wrong' -- "$tamp" probe bad.prm --wrong
expect 2 'Mesh file' 'no.msh' -- "$tamp" die bad.prm -o results \
  --set 'Die/Shape = file' --set 'Die/Mesh file = no.msh'
expect 2 'free ejection' 'holding 5 %' -- "$tamp" die bad.prm -o results \
  --set 'Material/Type = unit cell' \
  --set 'Schedule/Stages = press to density 0.8; eject to rim holding 0 % of peak'
cells=(--set 'Material/Type = unit cell')
expect 2 'Output/Grain points' '112' 'from 0 to 111' -- "$tamp" die bad.prm \
  -o results "${cells[@]}" --set 'Output/Grain points = 5, 112'
printf 'no mesh' > empty.msh
expect 2 'Mesh file' 'empty.msh' -- "$tamp" die bad.prm -o results \
  --set 'Die/Shape = file' --set 'Die/Mesh file = empty.msh'
[ ! -e results ] || { echo "FAILED: results were written"; exit 1; }

echo 'a file' > file
expect 4 'file/results' -- "$tamp" probe bad.prm -o file/results
expect 4 '/dev/null/results' -- "$tamp" probe bad.prm -o /dev/null/results

mkdir results
echo precious > results/curve.csv
expect 2 'results' '--force' -- "$tamp" probe bad.prm -o results
if [ "$(cat results/curve.csv)" != precious ] ||
  [ "$(find results | wc -l)" -ne 2 ]; then
  echo "FAILED: the existing folder was changed"
  failures=$((failures + 1))
fi
echo keep > results/notes.txt
"$tamp" probe bad.prm -o results --force --no-plots -q \
  --set 'Path/Stages = uniaxial to strain 0.01'
if [ "$(cat results/notes.txt)" != keep ] || grep -q precious results/curve.csv
then
  echo "FAILED: --force did not overwrite the results and these only"
  failures=$((failures + 1))
fi

echo "$failures failures"
[ "$failures" -eq 0 ]
