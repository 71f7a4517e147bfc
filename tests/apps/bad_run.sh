#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Wrong options, folders and values that do not fit together end with the exit
# code and the message that users are promised. Usage: bad_run.sh TAMP
. "$(dirname "$(realpath "$0")")/expect.sh"

printf 'subsection Material\n  set Type = elastic\nend\n' > bad.prm
expect 2 'Packing/Seed' -- \
  "$tamp" probe bad.prm -o results --set 'Packing/Seed = many'
expect 2 '--set' "'Packing'" -- \
  "$tamp" probe bad.prm -o results --set 'Paking/Seed = 2'
expect 2 'threads' -- "$tamp" probe bad.prm -o results --threads 0
expect 2 'threads' -- "$tamp" probe bad.prm -o results --threads -1
# Of several ranks one speaks, and none writes; a die may have several.
OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0 \
  expect 2 'one rank' '--threads' -- "$tamp" probe bad.prm -o results
for command in 'pack bad.prm' 'examples copy ring' 'fit x --law heckel' \
  'calibrate bad.prm --data x.csv --fit x'; do
  # shellcheck disable=SC2086
  OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0 \
    expect 2 'one rank' -- "$tamp" $command
done
[ ! -e ring ] || fail "an example for two ranks"
status=0
OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=1 \
  "$tamp" probe bad.prm -o results > out.txt 2>&1 || status=$?
[ "$status" -eq 2 ] || fail "the second rank: exit code $status"
[ ! -s out.txt ] || fail "the second rank speaks"
expect 2 'missing.prm' -- "$tamp" probe missing.prm -o results
expect 2 'a command' 'die, probe' -- "$tamp"
expect 2 "'dye'" "'die'" -- "$tamp" dye bad.prm
expect 2 'Output/Checkpoint interval' "'5 mm'" 'a time' -- "$tamp" die bad.prm \
  -o results --set 'Output/Checkpoint interval = 5 mm'
expect 2 '--wrong' -- "$tamp" probe bad.prm --wrong
expect 2 'Mesh file' 'no.msh' -- "$tamp" die bad.prm -o results \
  --set 'Die/Shape = file' --set 'Die/Mesh file = no.msh'
expect 2 'ejected freely' 'holding 5 %' 'Work of adhesion' -- "$tamp" die bad.prm -o results \
  --set 'Material/Type = unit cell' \
  --set 'Schedule/Stages = press to density 0.8; eject to rim holding 0 % of peak'
cells=(--set 'Material/Type = unit cell')
expect 2 'Output/Grain points' '112' 'from 0 to 111' -- "$tamp" die bad.prm \
  -o results "${cells[@]}" --set 'Output/Grain points = 5, 112'
printf 'no mesh' > empty.msh
expect 2 'Mesh file' 'empty.msh' -- "$tamp" die bad.prm -o results \
  --set 'Die/Shape = file' --set 'Die/Mesh file = empty.msh'
# What the rooms below refuse is refused before a folder is made.
expect 2 'Grains/Count' '20' -- "$tamp" probe bad.prm -o results \
  "${cells[@]}" --set 'Grains/Count = 12'
expect 2 'Packing/Initial relative density' '0.38' -- "$tamp" probe bad.prm \
  -o results "${cells[@]}" --set 'Packing/Initial relative density = 0.4'
law='Material/Drucker-Prager cap'
cap=(--set 'Material/Type = drucker-prager cap')
expect 2 "$law/Friction angle" '1.5' -- "$tamp" die bad.prm -o results \
  "${cap[@]}" --set "$law/Friction angle = 86.5 deg"
expect 2 "$law/Hydrostatic yield pressure" 'at least 2' -- "$tamp" die bad.prm \
  -o results "${cap[@]}" --set "$law/Hardening densities = 1" \
  --set "$law/Hydrostatic yield pressure = 1 MPa"
law='Material/Modified Cam-Clay'
expect 2 "$law/Compression index" '0.05' 'swelling index' -- "$tamp" probe \
  bad.prm -o results --set 'Material/Type = modified cam-clay' \
  --set "$law/Compression index = 0.05"
law='Material/FKM-Gurson'
expect 2 "$law/Random packing density" '0.8' '0.77' -- "$tamp" die bad.prm \
  -o results --set 'Material/Type = fkm-gurson' \
  --set "$law/Random packing density = 0.8"
expect 2 'Schedule/Stages' 'density' -- "$tamp" die bad.prm -o results \
  --set 'Schedule/Stages = press to density 0'
expect 2 'Path/Stages' 'stage 1' "'-0.1'" 'above 0' -- "$tamp" probe bad.prm \
  -o results --set 'Path/Stages = uniaxial to strain -0.1'
printf '1,0,0,0,1,0,0,0,1\n1,0,0\n' > short.csv
expect 2 'Path/Stages' 'short.csv:2' -- "$tamp" probe bad.prm -o results \
  --set "Path/Stages = csv $PWD/short.csv"
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

# --force overwrites runs of tamp, and never what the run reads.
unchanged() {
  find "$1" -type f -exec sha1sum {} + | sort > after.txt
  cmp -s before.txt after.txt || fail "$1 was changed"
}
remember() { find "$1" -type f -exec sha1sum {} + | sort > before.txt; }
short=(--no-plots -q --set 'Path/Stages = uniaxial to strain 0.01')
mkdir results/plots results/fields
echo mine > results/plots/mine.svg
for text in '' '{"program": "other"}' '["tamp"]'; do
  [ -z "$text" ] || echo "$text" > results/run.json
  remember results
  expect 2 'results' 'run.json' -- "$tamp" probe bad.prm -o results --force
  unchanged results
done
echo '{"program": "tamp"}' > results/run.json
printf '1,0,0,0,1,0,0,0,1\n' > results/fields/path.csv
cp bad.prm results/input.prm
remember results
expect 2 'input.prm' '--force' -- \
  "$tamp" probe results/input.prm -o results --force
expect 2 'path.csv' '--force' -- "$tamp" probe bad.prm -o results --force \
  --set "Path/Stages = csv $PWD/results/fields/path.csv"
unchanged results
"$tamp" probe bad.prm -o results --force "${short[@]}"
mkdir empty
"$tamp" probe bad.prm -o empty --force "${short[@]}"
if [ "$(cat results/notes.txt)" != keep ] || grep -q precious results/curve.csv
then
  echo "FAILED: --force did not overwrite the results and these only"
  failures=$((failures + 1))
fi

# A disk that is full: complete lines, and what was reached so far.
(
  trap '' XFSZ
  ulimit -f 40
  expect 4 'full/curve.csv' 'results so far' -- "$tamp" probe bad.prm -o full \
    --no-plots -q --set 'Path/Stages = uniaxial to strain 0.1' \
    --set 'Path/Maximum strain increment = 1e-4'
  [ "$failures" -eq 0 ]
) || failures=$((failures + 1))
[ "$(tail -c 1 full/curve.csv)" = '' ] || fail "the last line is cut"
grep -q '"final_strain' full/run.json || fail "full: results so far"

echo "$failures failures"
[ "$failures" -eq 0 ]
