#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A run says each doubt once, with its place, and a sound run none. Usage:
# warnings.sh TAMP COMMAND laws|cells
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
command=$2 about=$3

cat > run.prm << 'END'
include granules.prm
subsection Grains
  set Count = 100
end
subsection Packing
  set Same at all points = true
end
subsection Pair
  set Stages = overlap to 2 um in 20; overlap to 0 in 20
end
subsection Path
  set Stages                   = uniaxial to strain 0.01
  set Maximum strain increment = 5e-2
end
subsection Die
  set Elements = 1, 1
end
subsection Schedule
  set Stages = press to density 0.62
end
subsection Solver
  set Maximum step = 5e-2
end
END

# run OPTION...: the run of this test in the folder results, its words in
# said.txt. Options are those of --set.
run() {
  local options=()
  for setting in "$@"; do
    options+=(--set "$setting")
  done
  "$tamp" "$command" run.prm -o results --force --no-plots "${options[@]}" \
    > said.txt || fail "$command $*"
}
# warns COUNT: so many warnings in all, on the terminal and in the record.
warns() {
  [ "$(grep -c '^warning: ' said.txt)" -eq "$1" ] ||
    fail "expected $1 warnings: $(grep '^warning: ' said.txt)"
  [ "$(grep -c '^  warning  ' results/summary.txt || :)" -eq "$1" ] ||
    fail "expected $1 warnings in summary.txt"
}
# once TEXT...: of the warnings, one has all these texts; it is in all files.
once() {
  local found
  found=$(grep '^warning: ' said.txt)
  for text in "$@"; do
    found=$(grep -F -- "$text" <<< "$found") || fail "no warning has '$text'"
  done
  [ "$(wc -l <<< "$found")" -eq 1 ] || fail "warned twice: $found"
  for file in results/{log.txt,run.json,summary.txt}; do
    grep -qF -- "${found#warning: }" "$file" || fail "$file: no '$1'"
  done
}
# number FILE TEXT: the number right behind the text.
number() {
  sed -n "s|.*$2\([-+.e0-9]*[0-9]\).*|\1|p" "$1" | head -n 1 | grep . ||
    fail "$1 has no number behind '$2'"
}
# near A B: to the digits of a message.
near() {
  awk -v a="$1" -v b="$2" \
    'BEGIN { d = a / b - 1; exit !(d * d < 1e-6) }' || fail "$1 is not $2"
}
# largest COLUMN: of curve.csv.
largest() {
  awk -F, -v name="$1" '/^#/ { next }
    !place { for (k = 1; k <= NF; ++k) if ($k == name) place = k
      if (!place) exit 1
      next }
    $place > most { most = $place } END { print most }' results/curve.csv ||
    fail "curve.csv has no column $1"
}

# What is said of the laws is the same for all commands.
laws() {
  sound
  run 'Contact/Limiting contact pressure = 1 GPa'
  warns 1
  once 'would yield at an overlap of' 'above 0.1 R*' 'lower'
  # (pi p_y / (2 E*))^2 with E* = E / (2 (1 - nu^2)) = 1.923 GPa.
  near "$(number said.txt 'at an overlap of ')" 0.6672
  run 'Contact/Normal law = jkr' 'Contact/Work of adhesion = 7' \
    "Grains/Young's modulus = 35 MPa" 'Schedule/Stages = hold 1 step'
  warns 1
  once 'adhesion alone gives' 'above 0.3162 R*' 'lower'
  run 'Contact/Work of adhesion = 1'
  warns 1
  once 'Contact/Work of adhesion is not felt'
}

sound() {
  run "$@"
  ! grep -q '^warning' said.txt || fail "a sound run warns"
  ! grep -q '"warnings"' results/run.json || fail "run.json of a sound run"
  ! grep -q 'beyond_pair_laws\|too_narrow\|not_quasi' results/run.json ||
    fail "a sound run counts doubtful cells"
}

# counted NAME COUNT: the result and the line of the end agree.
counted() {
  near "$(number results/run.json "\"$1\[-\]\": ")" "$2"
  [ "$(grep -c "$2 of $2 [a-z]*s, worst" said.txt)" -eq 1 ] ||
    fail "no line at the end, or two"
}

case $about-$command in
laws-*)
  laws
  ;;
cells-probe)
  run 'Grains/Count = 60'
  warns 1
  once 'step 0 (uniaxial), axial strain 0' 'largest grains wide; below 3' 'use'
  run 'Grains/Count = 150' 'Path/Stages = uniaxial to strain 0.35; hold 2 steps'
  warns 1
  once 'relative density is' 'above 0.82' 'step 7 (uniaxial), axial strain 0.35'
  near "$(number said.txt 'relative density is ')" \
    "$(largest 'relative_density[-]')"
  # I = rate d sqrt(S rho / p): 1.2e-3 at 30 millionths a second, 0.5 MPa.
  run 'Cell/Method = dynamics' 'Cell/Strain rate = 3e-5'
  warns 1
  once 'not quasi-static: the inertial number' 'above 0.001' 'lower' 'strain 0:'
  sound 'Cell/Method = dynamics' 'Cell/Strain rate = 1e-5'
  ;;
cells-pack)
  sound 'Packing/Replicas = 2'
  run 'Packing/Replicas = 2' 'Grains/Count = 60'
  warns 1
  once 'packing 1: ' 'largest grains wide; below 3' 'use more grains'
  counted packings_too_narrow 2
  run 'Packing/Replicas = 2' 'Packing/Target = relative density' \
    'Packing/Relative density = 0.84'
  warns 1
  once 'packing 1: ' 'relative density is 0.84;' 'above 0.82'
  counted packings_beyond_pair_laws 2
  ;;
cells-die)
  # Wide enough at the start, too narrow at the end.
  run 'Schedule/Stages = press to density 0.85' 'Die/Elements = 1, 2' \
    'Packing/Same at all points = false'
  warns 2
  once 'largest grains wide; below 3' 'point ' 'r = ' 'z = ' '(press)' 'strain'
  ! grep -q 'step 0 (press).*grains wide' said.txt || fail "narrow at once"
  once 'relative density is' 'above 0.82' 'point ' 'r = ' 'z = ' '(press)'
  # The line of the end counts all points and knows the densest.
  near "$(number said.txt 'relative density above 0.82: [^;]* worst ')" \
    "$(largest 'maximum_relative_density[-]')"
  [ "$(grep -c 'of 8 points, worst.*of 8 points, worst' said.txt)" -eq 1 ] ||
    fail "no line at the end, or two"
  near "$(number results/run.json '"points_beyond_pair_laws\[-\]": ')" \
    "$(number said.txt 'relative density above 0.82: ')"
  near "$(number results/run.json '"points_too_narrow\[-\]": ')" 8
  run 'Cell/Method = dynamics' 'Cell/Strain rate = 3e-5'
  warns 1
  once 'not quasi-static: the inertial number' 'above 0.001' 'point '
  counted points_not_quasi_static 4
  # Balance that is sought more exactly than the cells answer.
  run 'Cell/Unbalance tolerance = 3e-2' 'Solver/Force tolerance = 1e-4' \
    'Output/Bias interval = 1'
  warns 1
  once 'Solver/Force tolerance = 0.0001' 'more than cells know' 'lower'
  near "$(number said.txt 'change their stress by ')" \
    "$(printf %.2g "$(number results/run.json '"mean_cell_bias\[-\]": ')")"
  sound 'Cell/Unbalance tolerance = 3e-2' 'Solver/Force tolerance = 1e-2' \
    'Output/Bias interval = 1'
  sound 'Cell/Unbalance tolerance = 3e-2' 'Solver/Force tolerance = 1e-4' \
    'Output/Bias interval = 0'
  ! grep -q cell_bias results/run.json || fail "cells are sampled unasked"
  ;;
*)
  fail "$about of $command"
  ;;
esac
echo "all well"
