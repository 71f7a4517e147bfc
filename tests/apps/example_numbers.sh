#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The README of an example tells the truth: the commands under its heading
# "Numbers that a test checks" leave the key results in the table behind each.
# Usage: example_numbers.sh TAMP EXAMPLE
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
example=$2

mkdir -p apps/examples
"$tamp" examples copy "$example" apps/examples > out.txt

# command_N and table_N: what is to be run, and "name value share" that come out.
awk '
  /^## / { checked = /^## Numbers that a test checks$/ }
  !checked { next }
  /^    / {
    if (!running) number++
    running = 1
    print > ("command_" number)
    next
  }
  { running = 0 }
  /^\| `/ {
    if (split($0, cell, "|") != 5 || cell[4] !~ /^ *[0-9.]+ % *$/) {
      print "not a line of the table: " $0
      bad = 1
      next
    }
    gsub(/^ *`|` *$/, "", cell[2])
    print cell[2] "|" cell[3] + 0 "|" cell[4] / 100 > ("table_" number)
    found++
  }
  END { exit bad || !found }' "apps/examples/$example/README.md" ||
  fail "the README has no numbers to be checked"

# As users type it, but with the program under test, without words and plots.
program=$(realpath "$tamp")
export program
tamp() {
  "$program" "$@" -q --no-plots
}
export -f tamp

for command in command_*; do
  cat "$command"
  bash -e "$command" || fail "the command"
  # That of the run, not of its parts.
  run=$(find . -name run.json -printf '%d %p\n' | sort -n | head -n 1)
  awk -F'|' -v file="${run#* }" '
    BEGIN {
      while ((getline line < file) > 0)
        if (match(line, /^ *"[^"]*": /)) {
          name = substr(line, 1, RLENGTH - 3)
          sub(/^ *"/, "", name)
          result[name] = substr(line, RLENGTH + 1) + 0
        }
    }
    {
      off = result[$1] - $2
      wrong = !($1 in result) || off * off > ($3 * $2)^2
      print (wrong ? "  WRONG " : "  ") $1 ": " result[$1] ", README: " $2
      bad += wrong
    }
    END { exit bad > 0 }' "table_${command#command_}" ||
    fail "not what the README says"
  rm -rf results "apps/examples/$example/results"
done
echo "all well"
