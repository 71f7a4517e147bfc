#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A die of unit cells gives the same on 1, 2 and 4 ranks, to the bit, and ends
# for the same reasons. Usage: rank_cells.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
export OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1
export OPENBLAS_NUM_THREADS=1

cat > die.prm << 'END'
include granules_die.prm
subsection Schedule
  set Stages = press to density 0.61; unload to 50 % of peak
end
subsection Output
  set Field interval = 4
  set Grain interval = 4
  set Grain output   = chosen points
  set Grain points   = 0, 5
  set Bias interval  = 2
end
END

# on RANKS OPTION...: the die on so many ranks; the exit code in $status.
on() {
  local ranks=$1
  shift
  status=0
  timeout 60 mpirun -np "$ranks" "$tamp" die die.prm --no-plots "$@" \
    > out.txt 2> err.txt || status=$?
}

# Also with threads in a rank, and with more ranks than there are cores.
for run in '1 1' '2 2' '4 1'; do
  set -- $run
  on "$1" -o "ranks_$1" --threads "$2"
  [ "$status" -eq 0 ] || { cat err.txt; fail "$1 ranks: exit code $status"; }
  [ ! -s err.txt ] || { cat err.txt; fail "$1 ranks: a message"; }
  [ "$(grep -c 'Results are in' out.txt)" -eq 1 ] || fail "$1 summaries"
  grep -v '^#' "ranks_$1/curve.csv" | sed 's/,[^,]*$//' > "curve_$1.txt"
  (cd "ranks_$1" && find . -type f | sort) > "files_$1.txt"
  has "ranks_$1"/grains/point_000{0,5}.csv "ranks_$1"/fields.pvd
done
[ "$(wc -l < curve_1.txt)" -gt 5 ] || fail "only $(wc -l < curve_1.txt) lines"
for ranks in 2 4; do
  cmp curve_1.txt "curve_$ranks.txt" || fail "$ranks ranks: another curve"
  cmp files_1.txt "files_$ranks.txt" || fail "$ranks ranks: other files"
  # Fields, pictures of grains, and paths of points: every byte.
  while read -r file; do
    cmp "ranks_1/$file" "ranks_$ranks/$file" || fail "$ranks ranks: $file"
  done < <(grep -E '/(fields|grains)/|\.pvd$|input\.prm' files_1.txt)
  # What is said of cells and steps, warnings included; rounding of time aside.
  for name in force_evaluations_per_cell worst_unbalance worst_hill_mandel \
    points_too_narrow mean_cell_bias worst_cell_bias cell_bias_cost \
    worst_stress_asymmetry different_cells; do
    grep -h "\"$name" ranks_1/run.json > expected.txt || fail "no $name"
    grep -h "\"$name" "ranks_$ranks/run.json" | cmp expected.txt - ||
      fail "$ranks ranks: another $name"
  done
  [ "$(grep -c '^ *idle share of rank' "ranks_$ranks/summary.txt")" \
    -eq "$ranks" ] || fail "$ranks ranks: no idle share for each"
done
grep -q 'on 2 ranks' ranks_2/log.txt || fail "log.txt does not tell the ranks"

# A warning names the same point on any number of ranks.
grep '^ *warning ' ranks_1/summary.txt > expected.txt || fail "no warning"
for ranks in 2 4; do
  grep '^ *warning ' "ranks_$ranks/summary.txt" | cmp expected.txt - ||
    fail "$ranks ranks: other warnings"
done

# same_end CODE OPTION...: one rank and two end so, with the same words.
same_end() {
  local code=$1 ranks
  shift
  for ranks in 1 2; do
    on "$ranks" -o end --force -q "$@"
    [ "$status" -eq "$code" ] ||
      { cat err.txt; fail "$*: code $status on $ranks ranks, not $code"; }
    grep '^tamp: ' err.txt > "end_$ranks.txt" || fail "$*: no message"
    [ "$(wc -l < "end_$ranks.txt")" -eq 1 ] || fail "$*: expected one message"
  done
  cmp end_1.txt end_2.txt || { cat end_?.txt; fail "$*: other words"; }
}
# A stored packing that only the second of two ranks reads.
"$tamp" pack die.prm -o packing -q --no-plots
mkdir library
for i in 1 2 3 4 5 6 7 8; do
  cp packing/packing.h5 "library/packing_000$i.h5"
done
head -c 2000 packing/packing.h5 > library/packing_0007.h5
same_end 2 --set 'Packing/Source = file' --set 'Packing/File = library'
grep -q 'packing_0007' end_2.txt || { cat end_2.txt; fail "which file?"; }
# A step that finds no equilibrium.
same_end 3 --set 'Schedule/Stages = press to density 0.8' \
  --set 'Solver/First step = 0.1' --set 'Solver/Maximum step = 0.1' \
  --set 'Solver/Minimum step = 0.09' --set 'Solver/Maximum iterations = 2'
grep -q 'Worst is point [0-9]' end_2.txt || fail "which point?"
# Wrong inputs leave nothing.
on 2 -o bad --set 'Grains/Count = 1'
[ "$status" -eq 2 ] || fail "a wrong input: exit code $status"
[ ! -e bad ] || fail "a wrong input makes a folder"
echo "all well"
