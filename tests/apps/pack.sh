#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packings are made, kept, found again and taken up by other runs, and wrong
# ones are refused. Usage: pack.sh TAMP
. "$(dirname "$(realpath "$0")")/expect.sh"

cat > pack.prm << 'END'
include granules.prm
subsection Grains
  set Count = 80
end
subsection Path
  set Stages = uniaxial to strain 0.005
end
END
pack() {
  "$tamp" pack pack.prm "$@" > said.txt || fail "pack $*"
}
# value FOLDER NAME: a key result.
value() {
  awk -F': ' -v name="\"$2[" 'index($1, name) { sub(/,$/, "", $2); print $2 }' \
    "$1/run.json"
}

# Replicas: all files, seeds of their own, the same again.
pack -o three --set 'Packing/Replicas = 3'
for i in 1 2 3; do
  has "three/packing_000$i.h5" "three/packing_000$i.txt" \
    "three/grains_000$i.vtp"
done
has three/{run.json,input.prm,log.txt,curve.csv,summary.txt}
if command -v gnuplot > /dev/null; then
  has three/plots/pressure_density.{svg,png,gp}
fi
cmp -s three/packing_0001.h5 three/packing_0002.h5 && fail "replicas are equal"
near "$(value three pressure)" 0.5e6 0.01
awk -F, '/^#/ { next } !n { n = NF; next } NF != n || $1 < last { exit 1 }
  { last = $1 } END { exit !(last == 3) }' three/curve.csv || fail "curve.csv"
pack -o again --threads 1 --no-plots --set 'Packing/Replicas = 3'
for file in curve.csv packing_000{1,2,3}.h5; do
  cmp "three/$file" "again/$file" || fail "$file is another one"
done
# A replica is the packing that a probe of the same number makes.
pack -o second --no-plots --set 'Packing/Sample = 1'
cmp second/packing.h5 three/packing_0002.h5 || fail "the sample's number"

# A stored packing is taken up to the bit; as text about as it was.
file() {
  echo --set 'Packing/Source=file' --set "Packing/File=$PWD/$1"
}
"$tamp" probe pack.prm -o made -q --no-plots
"$tamp" probe pack.prm -o read -q --no-plots $(file three/packing_0001.h5)
cmp made/curve.csv read/curve.csv || fail "a stored packing is another one"
"$tamp" probe pack.prm -o text --no-plots $(file three/packing_0001.txt) \
  > said.txt
grep -q '^warning: the stored packing has no contact history' said.txt ||
  fail "no warning of the lost history"
near "$(value text final_axial_stress)" "$(value made final_axial_stress)" 0.2
# A folder of packings, compressed further.
pack -o denser --no-plots $(file three) --set 'Packing/Replicas = 3' \
  --set 'Packing/Pressure = 1 MPa'
near "$(value denser pressure)" 1e6 0.01

# Along the die axis, and to a density.
pack -o die --no-plots --set 'Packing/Compression = uniaxial'
near "$(value die axial_stress)" 0.5e6 0.01
awk -v k="$(value die lateral_over_axial_stress)" \
  'BEGIN { exit !(k > 0.3 && k < 0.85) }' || fail "lateral over axial stress"
pack -o density --no-plots --set 'Packing/Target = relative density' \
  --set 'Packing/Relative density = 0.64'
near "$(value density relative_density)" 0.64 1e-6

# Measured sizes, and a second species.
printf 'diameter[mm],share_by_mass[%%]\n0.5,40\n0.6,60\n' > sizes.csv
pack -o sizes --no-plots --set 'Grains/Diameter distribution = table' \
  --set "Grains/Size table = $PWD/sizes.csv"
awk '!/^#/ { ++count[$4] } END { print count["0.00025"], count["3e-04"] }' \
  sizes/packing.txt > counts.txt
# 40/0.5^3 : 60/0.6^3 = 0.535 : 0.465 of 80 grains.
[ "$(cat counts.txt)" = '43 37' ] || fail "sizes: $(cat counts.txt)"
pack -o mixed --no-plots --set 'Grains/Second species/Number share = 0.25' \
  --set "Grains/Second species/Young's modulus = 1 GPa"
has mixed/packing.h5

# Refusals.
expect 2 'exists already' -- "$tamp" pack pack.prm -o three
"$tamp" pack pack.prm -o three -q --no-plots --force ||
  fail "--force does not overwrite packings"
[ ! -e three/packing_0002.h5 ] || fail "--force leaves old packings"
bad() {
  local code=$1 texts=()
  shift
  while [ "$1" != -- ]; do
    texts+=("$1")
    shift
  done
  shift
  expect "$code" "${texts[@]}" -- "$tamp" pack pack.prm -o bad --no-plots "$@"
}
bad 2 'Packing/File' 'no.h5' -- $(file no.h5)
bad 2 'Packing/Source' 'File' -- --set 'Packing/Source = file'
bad 2 'Packing/File' 'Source' -- --set 'Packing/File = a.h5'
bad 2 'Grains/Count' 'wide' -- --set 'Grains/Count = 25'
bad 2 'Packing/Cell shape' 'wide' -- --set 'Packing/Cell shape = 0.2'
bad 2 'Packing/Replicas' -- $(file again/packing_0001.h5) \
  --set 'Packing/Replicas = 2'
bad 2 'Packing/Relative density' -- --set 'Packing/Target = relative density' \
  --set 'Packing/Relative density = 0.2'
table=(--set 'Grains/Diameter distribution = table')
bad 2 'Grains/Size table' -- "${table[@]}"
# lines TEXT EXPECTED...: the table is refused.
lines() {
  local text=$1
  shift
  printf '%b' "$text" > wrong.csv
  bad 2 "$@" -- "${table[@]}" --set "Grains/Size table = $PWD/wrong.csv"
}
lines 'diameter[um],share[-]\n1,1\n' 'wrong.csv:1' 'cumulative_share_by_number'
lines 'diameter[MPa],share_by_mass[-]\n' 'wrong.csv:1' 'a length'
head='diameter[um],cumulative_share_by_mass[-]\n'
lines "${head}500,0\n600\n" 'wrong.csv:3' '2 values'
lines "${head}500,0\n-6,1\n" 'wrong.csv:3' 'above 0'
lines "${head}500,0\n400,1\n" 'wrong.csv:3' 'rise'
lines "${head}500,0.2\n600,1\n" 'wrong.csv:2' 'expected 0'
lines "${head}500,0\n600,0.7\n" 'wrong.csv:3' 'expected 1'
[ ! -e bad ] || fail "results were written"
# What is in a file is seen in the run.
rm -rf bad
printf '# L 1 1 1\n0 0 0 x\n' > wrong.txt
bad 2 'wrong.txt:2' "'x'" -- $(file wrong.txt)
rm -rf bad
head -c 3000 again/packing_0001.h5 > cut.h5
bad 2 'cut.h5' 'incomplete' -- $(file cut.h5)
rm -rf bad
bad 3 'already' -- $(file again/packing_0001.h5) --set 'Packing/Pressure = 1 kPa'

echo "$failures failures"
[ "$failures" -eq 0 ]
