#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# `tamp check` passes what can run, refuses what cannot, foretells memory and
# writes nothing. Usage: check.sh TAMP EXAMPLE|memory|wrong
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
about=$2

# checks CODE FILE OPTION...: what is said is in said.txt and err.txt.
checks() {
  local code=$1 status=0
  shift
  find . -type f ! -name said.txt ! -name err.txt -exec sha1sum {} + |
    sort > before.sum
  "$tamp" check "$@" > said.txt 2> err.txt || status=$?
  cat said.txt err.txt
  [ "$status" -eq "$code" ] || fail "$*: exit code $status, expected $code"
  find . -type f ! -name said.txt ! -name err.txt ! -name '*.sum' \
    -exec sha1sum {} + | sort > after.sum
  diff <(grep -v '\.sum$' before.sum) after.sum ||
    fail "$*: files were written"
}
says() {
  for text in "$@"; do
    grep -qF -- "$text" said.txt || fail "'$text' is not said"
  done
}
# number TEXT: the number right behind the text.
number() {
  sed -n "s|.*$1\([-+.e0-9]*[0-9]\).*|\1|p" said.txt | head -n 1 | grep . ||
    fail "no number behind '$1'"
}
# megabytes TEXT: the megabytes on the line that begins so [bytes].
megabytes() {
  sed -n "s|^ *$1 .*about \([0-9.]*\) \([MG]\)B.*|\1 \2|p" said.txt |
    awk '{ print $1 * ($2 == "G" ? 1e9 : 1e6); found = 1 } END { exit !found }' ||
    fail "no megabytes of '$1'"
}
# peak OPTION...: the largest memory of a run [bytes].
peak() {
  "$tamp" die die.prm -o results --force --no-plots -q --threads 1 "$@" ||
    fail "the run of $*"
  sed -n 's|^ *"peak_memory\[B\]": \([0-9.]*\).*|\1|p' results/run.json
}

wrong() {
  printf 'subsection Material\n  set Type = elastic\nend\n' > die.prm
  checks 0 die.prm
  says 'an input for tamp die' 'an input for tamp probe' 'can run'
  for text in 'Die/Radius = -1 mm' 'Schedule/Stages = press to density 0.5' \
    'Solver/First step = 2' 'Paking/Seed = 2' 'Die/Shape = file'; do
    checks 2 die.prm --set "$text"
    grep -q "${text#*/}\|${text%% =*}" err.txt || fail "the entry of '$text'"
    [ "$(wc -l < err.txt)" -eq 1 ] || fail "expected one message"
  done
  checks 2 nowhere.prm
  grep -q nowhere.prm err.txt || fail "the file's name"
  # What can be read but should not be run: a terabyte of grains.
  checks 5 granules.prm --set 'Die/Elements = 100, 200' \
    --set 'Grains/Count = 20000'
  says 'failed: the run needs about' 'this machine has'
  # A force that no powder bears; cells too skew.
  printf 'subsection Material\n  set Type = drucker-prager cap\nend\n' > die.prm
  checks 0 die.prm --set 'Schedule/Stages = press to force 5000 kN'
  says 'stage 1' '(4.421e+04 MPa)' 'may never be reached'
  checks 0 die.prm --set 'Die/Elements = 1, 40' \
    --set 'Schedule/Stages = press to density 0.5; hold 2 steps'
  says 'aspect ratio' 'above 10' 'stage 2'
}

# The bytes of a cell that are foretold are those that a run takes, at rest and
# where more and more grains touch.
memory() {
  cat > die.prm << 'END'
include granules.prm
subsection Packing
  set Same at all points = true
end
subsection Die
  set Elements = 1, 1
end
subsection Schedule
  set Stages = hold 4 steps
end
END
  local grains='Grains/Count = 1000'
  memory_of_cell
  memory_of_cell --set 'Schedule/Stages = press to density 0.66' \
    --set 'Solver/Maximum step = 0.02'
  memory_of_two "$grains"
}
# memory_of_cell OPTION...: what 108 cells more take.
memory_of_cell() {
  local few many foretold
  set -- --set 'Grains/Count = 1000' "$@"
  checks 0 die.prm "$@" --set 'Die/Elements = 4, 7'
  foretold=$(number '112 x ')
  few=$(peak "$@")
  many=$(peak "$@" --set 'Die/Elements = 4, 7')
  awk -v foretold="$foretold" -v few="$few" -v many="$many" 'BEGIN {
    real = (many - few) / (112 - 4)
    print "a cell takes " real " bytes, foretold were " foretold
    exit !(real > foretold / 1.2 && real < foretold * 1.2) }' ||
    fail "the memory of a cell with $*"
}
# The memory of all ranks. Libraries in it are counted for each rank, by the
# system, too; what the program takes for the work is a few megabytes.
memory_of_two() {
  local all more real
  checks 0 die.prm --set "$1" --set 'Die/Elements = 4, 7'
  all=$(megabytes all)
  more=$(megabytes 'further ranks')
  export OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1
  mpirun -np 2 bash -c '"$0" "$@" & run=$!
    while now=$(awk "/^VmHWM/ { print \$2 }" /proc/$run/status 2> /dev/null) &&
      [ -n "$now" ]; do
      echo "$now" > "peak_$OMPI_COMM_WORLD_RANK"
      sleep 0.02
    done
    wait $run' "$tamp" die die.prm -o two --no-plots -q --threads 1 \
    --set "$1" --set 'Die/Elements = 4, 7' || fail "the run on two ranks"
  real=$(awk '{ sum += 1024 * $1 } END { print sum }' peak_0 peak_1)
  awk -v all="$all" -v more="$more" -v real="$real" 'BEGIN {
    print "two ranks take " real " bytes, foretold were " all + more
    exit !(real > (all + more) / 1.2 && real < (all + more) * 1.2) }' ||
    fail "the memory of two ranks"
}

case $about in
memory | wrong)
  "$about"
  ;;
*)
  "$tamp" examples copy "$about" . > /dev/null
  checks 0 "$about/$about.prm"
  says "$about.prm, an input for tamp" 'Expected time' 'can run'
  ! grep -q '^  failed' said.txt || fail "an example fails"
  ;;
esac
echo "all well"
