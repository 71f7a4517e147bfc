#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs that succeed leave the folder that users are promised. Usage:
# good_run.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
# rectangular FILE: every line has as many fields as the header.
rectangular() {
  awk -F, '/^#/ { if (fields) wrong = 1; next }
    !fields { fields = NF; next }
    NF != fields { wrong = 1 }
    END { exit wrong || !fields || NR <= 3 }' "$1" || fail "$1 is not a table"
}

cat > law.prm << 'END'
subsection Material
  set Type = drucker-prager cap
end
subsection Die
  set Elements = 2, 2
end
subsection Schedule
  set Stages = press to density 0.5; unload to 5 % of peak
end
subsection Solver
  set Maximum step = 2e-2
end
subsection Path
  set Stages = uniaxial to strain 0.2; unload to 1 % of peak
end
END

NO_COLOR=1 "$tamp" die law.prm > die.txt
has results/law/{run.json,input.prm,log.txt,curve.csv,summary.txt,fields.pvd}
rectangular results/law/curve.csv
grep -q '"status": "done"' results/law/run.json || fail "status"
grep -q 'mean_relative_density\[-\]' results/law/curve.csv || fail "header"
if command -v gnuplot > /dev/null; then
  has results/law/plots/{compaction,density_map}.{svg,png,gp}
fi
! grep -q $'\r\|\033' die.txt || fail "a bar was drawn into a file"

# The echo is an input that gives the same run.
"$tamp" die results/law/input.prm -o again -q --no-plots > quiet.txt
[ ! -s quiet.txt ] || fail "-q is not quiet"
cut -d, -f1-14 results/law/curve.csv > first.txt
cut -d, -f1-14 again/curve.csv > second.txt
cmp first.txt second.txt || fail "the echo gives another run"

"$tamp" probe law.prm -o probe > /dev/null
has probe/{run.json,curve.csv,summary.txt}
rectangular probe/curve.csv

# What is easily overlooked in the tables of the powder is said once each.
for folder in results/law probe; do
  for file in run.json summary.txt; do
    [ "$(grep -o 'the hardening table at 0.3:' "$folder/$file" | wc -l)" -eq 1 ] \
      || fail "$folder/$file does not say once where the powder starts"
  done
done

# All parameters with their defaults can be read back, in both formats.
"$tamp" params > all.prm
"$tamp" params --check all.prm
"$tamp" params --format json > all.json
"$tamp" params --check all.json
# says TEXT COMMAND...: the output has the text. No pipe: grep -q would close it.
says() {
  local text=$1
  shift
  "$@" > said.txt || fail "$*"
  grep -q -- "$text" said.txt || fail "$* does not say '$text'"
}
says 'Limiting contact pressure' "$tamp" params --format md
# Name, default, range, unit and meaning of every parameter.
awk -F'|' '/^\|/ { if (NF != 7) exit 1
    for (i = 2; i < NF; ++i) if ($i ~ /^ *$/) exit 1 }' said.txt ||
  fail "a parameter lacks default, range, unit or meaning"

says die_default "$tamp" examples list
"$tamp" examples copy probe_uniaxial copied
has copied/probe_uniaxial/probe_uniaxial.prm
says '^tamp [0-9]' "$tamp" --version
says 'Exit codes' "$tamp" --help
echo "all well"
