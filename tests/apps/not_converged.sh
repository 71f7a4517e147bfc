#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A die step that cannot converge ends with exit code 3, says where, and leaves
# what was reached. Usage: not_converged.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

# A step at rest, then one so long that it asks for too many iterations; it may
# not be cut.
cat > die.prm << 'END'
include granules.prm
subsection Grains
  set Count = 100
end
subsection Die
  set Elements = 1, 2
end
subsection Schedule
  set Stages = hold 1 step; press to density 0.8
end
subsection Solver
  set First step         = 0.1
  set Maximum step       = 0.1
  set Minimum step       = 0.09
  set Maximum iterations = 2
end
subsection Output
  set Plot format = svg
end
END

# not_converged FOLDER OPTION...
not_converged() {
  local folder=$1 status=0
  shift
  "$tamp" die die.prm -o "$folder" "$@" > out.txt 2> err.txt || status=$?
  cat err.txt
  [ "$status" -eq 3 ] || { cat out.txt; fail "$folder: exit code $status, expected 3"; }
  [ "$(wc -l < err.txt)" -eq 1 ] || fail "$folder: expected one message"
  for text in 'did not converge' '(press)' 'point [0-9]' 'r = [0-9]' \
    'z = [0-9]' 'zz [0-9]' "$folder"; do
    grep -q -- "$text" err.txt || fail "$folder: the message lacks '$text'"
  done
  has "$folder"/{run.json,input.prm,log.txt,curve.csv,summary.txt,fields.pvd}
  grep -q '"status": "not converged"' "$folder/run.json" || fail "run.json"
  grep -q '"message": ".*point [0-9]' "$folder/run.json" || fail "run.json"
  grep -q 'status  *not converged' "$folder/summary.txt" || fail "summary.txt"
  # Complete lines of all accepted steps, and the fields of the last one.
  local last
  last=$(awk -F, '/^#/ { next } !fields { fields = NF; next }
    NF != fields || $1 != step { exit 1 }
    { ++step }
    END { if (step < 2) exit 1; print step - 1 }' step=0 "$folder/curve.csv") ||
    fail "$folder: curve.csv is not what was reached"
  [ "$(tail -c 1 "$folder/curve.csv")" = '' ] || fail "the last line is cut"
  grep -q "after step $last " err.txt || fail "$folder: curve.csv ends at $last"
  has "$folder/fields/step_$(printf %04d "$last").vtu"
  if command -v gnuplot > /dev/null; then
    has "$folder/plots/pressures.svg"
  fi
}

not_converged cells
has cells/grains.pvd cells/grains/point_0000.csv
not_converged law --set 'Material/Type = drucker-prager cap' \
  --set 'Solver/Maximum iterations = 1' --set 'Solver/Minimum step = 1e-4'
echo "all well"
