#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A probe with a scan, and several at once. Usage: probe_scan.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

cat > cells.prm << 'END'
include granules.prm
subsection Path
  set Stages = uniaxial to density 0.72; unload to 20 % of peak
end
subsection Scan
  set Densities          = 0.68, 0.7
  set Compression shares = 0.6, 0.1
  set Triaxial shares    =
  set Uniaxial shares    =
end
END
probe=("$tamp" probe cells.prm -q --no-plots)

# The path does not know of the scan, and threads of nothing.
"${probe[@]}" -o one --threads 1
"${probe[@]}" -o two --threads 2
"${probe[@]}" -o none --set 'Scan/Densities ='
for file in curve.csv yield.csv moduli.csv; do
  cmp one/$file two/$file || fail "$file depends on threads"
done
cmp one/curve.csv none/curve.csv || fail "the scan changed the path"
[ ! -e none/yield.csv ] || fail "a scan that nobody asked for"
[ "$(grep -vc '^[#r]' one/moduli.csv)" -eq 2 ] || fail "moduli.csv"
grep -q '^# branch 2: unloaded to 10 % of the reached pressure' one/yield.csv ||
  fail "the remarks of yield.csv"
# Isotropic reloading yields near the pressure reached, shear below it.
awk -F, '!/^[#r]/ && $6 == 0 { count++
  if ($5 == 3 && ($7 < 0.8 * $3 || $7 > 1.2 * $3)) exit bad = 1
  if ($5 == 2 && ($7 > 0.11 * $3 || $8 > $3)) exit bad = 1 }
  END { exit bad || count != 6 }' one/yield.csv || fail "yield.csv"

expect 2 'Scan/Densities' 'above the relative density of the powder' -- \
  "${probe[@]}" -o loose --set 'Scan/Densities = 0.4'
expect 2 'Scan/Densities' 'larger than the one before' -- \
  "${probe[@]}" -o wrong --set 'Scan/Densities = 0.7, 0.65'
expect 2 'Scan/Triaxial shares' -- \
  "${probe[@]}" -o wrong --set 'Scan/Triaxial shares = 1.5'
"${probe[@]}" -o short --set 'Scan/Densities = 0.9' 2> /dev/null
grep -q 'did not come to 0.9' short/summary.txt || fail "a density not reached"
expect 2 '--replicas' -- "${probe[@]}" -o law --replicas 2 \
  --set 'Material/Type = elastic' --set 'Scan/Densities ='

# Members are the probes that they would be alone; the mean is theirs.
"${probe[@]}" -o many --replicas 2 --sizes 40,60 --threads 2 \
  --set 'Scan/Densities = 0.7'
"${probe[@]}" -o alone --set 'Packing/Seed = 2' --set 'Scan/Densities = 0.7'
cmp alone/curve.csv many/size_00060_seed_2/curve.csv || fail "a member"
[ "$(grep -vc '^s' many/replicas.csv)" -eq 4 ] || fail "replicas.csv"
grep -q 'stress_zz_deviation\[Pa\]' many/curve.csv || fail "the deviation"
grep -q 'recommended size' many/summary.txt || fail "the recommended size"
[ "$(grep -v '^[#r]' many/yield.csv | cut -d, -f1 | sort -u | wc -l)" -eq 2 ] ||
  fail "yield.csv of two replicas"

# Killed on the way, cells that are done are kept, and the rest is as if nobody
# had killed anything.
many=("$tamp" probe cells.prm -q --no-plots --replicas 3 --threads 1
  --set 'Scan/Densities = 0.7')
"${many[@]}" -o whole
"${many[@]}" -o killed &
run=$!
until grep -qs '"status": "done"' killed/size_*/run.json; do
  kill -0 "$run" 2> /dev/null || fail "it had ended before"
  sleep 0.002
done
kill -KILL "$run"
wait "$run" 2> /dev/null || true
[ ! -e killed/replicas.csv ] || fail "it had ended before it was killed"
kept=$(grep -ls '"status": "done"' killed/size_*/run.json | head -n 1)
cp -p "$kept" kept.json
expect 2 'the input is not that of the run' -- \
  "${many[@]}" -o killed --resume --set 'Contact/Friction coefficient = 0.2'
"${many[@]}" -o killed --resume
cmp "$kept" kept.json || fail "a cell that was done was done again"
(cd whole && find . -name '*.csv') | while read -r file; do
  cmp "whole/$file" "killed/$file" || exit 1
done || fail "the killed run ends otherwise"
[ "$failures" -eq 0 ] || exit 1
echo "all well"
