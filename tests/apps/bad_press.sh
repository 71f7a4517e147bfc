#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Wrong tables, tools and schedules are refused before anything is written, by a
# run or a check; what is only found while pressing ends the run with
# exit code 3 and leaves the results so far.
# Usage: bad_press.sh TAMP tables|friction|tools|schedules|pressing
. "$(dirname "$(realpath "$0")")/expect.sh"

cat > die.prm << 'END'
subsection Material
  set Type = drucker-prager cap
end
subsection Die
  set Elements = 2, 3
end
subsection Solver
  set Maximum step = 2e-2
end
END

# refused SECTION/NAME = VALUE -- TEXT...: with the entry and its value, by the
# run and by the check in turn, which read alike.
command=check
refused() {
  local entry=$1
  shift 2
  local name=${entry%% = *}
  local options=(--set "$entry")
  if [ "$command" = check ]; then
    command=die
    options+=(-o results)
  else
    command=check
  fi
  expect 2 "$name = " "$@" -- "$tamp" "$command" die.prm "${options[@]}"
  [ ! -e results ] || fail "results were written"
}
law='Material/Drucker-Prager cap'

case $2 in

tables)
refused "$law/Hardening densities = 0.3, 0.5, 0.4, 0.6, 0.7, 0.8, 0.85, 0.9, \
0.95, 0.97, 0.99" -- '0.5, 0.4' 'increase'
expect 2 "$law/Young" "expected 2 values" "one for each of $law/Elastic" -- \
  "$tamp" die die.prm --set "$law/Elastic densities = 0.3, 0.4"
refused "$law/Hydrostatic yield pressure = 1, 4, 10, 20, 15, 30, 40, 50, 60, \
70, 80 MPa" -- '20, 15' 'increase with density'
refused "$law/Cohesion = -1, 0, 0, 0, 0, 0, 0, 0, 0, 0 MPa" -- '-1' '>= 0'
refused "$law/Friction angle = 54, 68, 68, 68, 68, 67, 66, 66, 65, 63 mm" -- \
  'mm' 'an angle'
refused "$law/Initial relative density = 1.2" -- '1.2' '<= 1'
;;

friction)
refused 'Die/Wall friction coefficient = -0.1' -- '-0.1' 'not negative'
refused 'Die/Wall friction coefficient = of density 0.3: 0.5, 0.5; 0.2' -- \
  "'0.5; 0.2'" 'place: mu'
refused 'Die/Wall friction coefficient = of density 0.3: 0.5, 0.6: -0.2' -- \
  "'0.6: -0.2'" 'not negative'
refused 'Die/Wall friction coefficient = of density 0.5: 0.5, 0.3: 0.2' -- \
  "row 2" "above that of the row before"
refused 'Die/Wall friction coefficient = of pressure 1 mm: 0.5, 2 MPa: 0.2' -- \
  "'1 mm' is a length" "expected a pressure"
refused 'Die/Punch friction coefficient = of heat 1: 0.5' -- \
  "'of density'" "'of pressure'"

;;

tools)
refused 'Die/Upper punch = concave 8 MPa' -- "'8 MPa' is a pressure" "expected a length"
refused 'Die/Upper punch = bevel 0.4 mm 30' -- 'bevel 0.4 mm 30' 'angle'
refused 'Die/Upper punch = round 8 mm' -- 'round' 'concave R'
refused 'Die/Upper punch = concave 4 mm' -- '0.004' 'radius' '0.006'
refused 'Die/Lower punch = chamfer 9 mm' -- '0.009' '0.006'
cat die.prm - > square.prm << 'END'
subsection Die
  set Shape = square
  set Symmetry = quarter
end
END
for command in die check; do
  expect 2 'Die/Corner radius = 7 mm' '0.007' '0.006' -- \
    "$tamp" "$command" square.prm --set 'Die/Corner radius = 7 mm'
  expect 2 'Die/Symmetry = axisymmetric' 'square' 'quarter' -- \
    "$tamp" "$command" square.prm --set 'Die/Symmetry = axisymmetric'
  expect 2 'Die/Core radius = 8 mm' '0.008' '0.006' -- "$tamp" "$command" \
    die.prm --set 'Die/Shape = ring' --set 'Die/Core radius = 8 mm'
done
[ ! -e results ] || fail "results were written"
refused 'Die/Elements = 0, 4' -- 'whole numbers > 0'

;;

# What cannot be done, as far as that can be known before.
schedules)
refused 'Schedule/Stages = press to displacement 8 mm' -- 'stage 1' \
  '0.008' '0.007' 'expected less'
refused 'Schedule/Stages = press both to displacement 4 mm' -- 'stage 1' \
  '0.008' '0.007'
refused 'Schedule/Stages = unload to 5 % of peak; press to density 0.5' -- \
  'stage 1' 'no stage has pressed'
refused 'Schedule/Stages = press to density 1.2' -- 'stage 1' '1.2' \
  'between 0 and 1'
refused 'Schedule/Stages = press to density 0.2' -- 'stage 1' '0.2' '0.3411'
refused 'Schedule/Stages = press to density 0.5; fly' -- 'stage 2' 'fly'
refused 'Schedule/Stages = press to force 5 mm' -- 'stage 1' '5 mm' 'a force'
for command in die check; do
  expect 2 'Die/Wall friction coefficient = 0' 'floating' '> 0' -- \
    "$tamp" "$command" die.prm --set 'Schedule/Floating die = true' \
    --set 'Die/Wall friction coefficient = 0'
done
[ ! -e results ] || fail "results were written"

;;

pressing)
# found_while_pressing FOLDER STAGES TEXT...: exit code 3 and the reason; what
# was reached can be read.
found_while_pressing() {
  local folder=$1 stages=$2
  shift 2
  expect 3 'not converged' 'stage' "$@" "$folder" -- "$tamp" die die.prm \
    -o "$folder" --no-plots -q --set "Schedule/Stages = $stages"
  has "$folder"/{run.json,input.prm,log.txt,curve.csv,summary.txt,fields.pvd}
  awk -F, '/^#/ { next } !fields { fields = NF; next }
    NF != fields { exit 1 } { ++lines } END { exit !(lines >= 5) }' \
    "$folder/curve.csv" || fail "$folder: curve.csv is not what was reached"
  [ "$(tail -c 1 "$folder/curve.csv")" = '' ] || fail "the last line is cut"
  grep -q '"status": "not converged"' "$folder/run.json" || fail "run.json"
  # The last state is among the fields.
  local last
  last=$(tail -n 1 "$folder/curve.csv" | cut -d, -f1)
  has "$folder/fields/step_$(printf %04d "$last").vtu"
  grep -q "step_$(printf %04d "$last").vtu" "$folder/fields.pvd" ||
    fail "$folder: fields.pvd ends before step $last"
}
found_while_pressing force 'press to force 5000 kN' 'cannot be done' 'solid' \
  '5e+06 N'
found_while_pressing less 'press to density 0.5; press to density 0.45' \
  'stage 2' '0.45' '0.5'

# What is there already is not touched by what is refused.
mkdir results
echo precious > results/curve.csv
expect 2 'Schedule/Stages' -- "$tamp" die die.prm -o results --force \
  --set 'Schedule/Stages = press to density 1.2'
[ "$(cat results/curve.csv)" = precious ] && [ "$(ls results)" = curve.csv ] ||
  fail "the results were changed"
;;
*) fail "no part $2" ;;
esac

echo "$failures failures"
[ "$failures" -eq 0 ]
