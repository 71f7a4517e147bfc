#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# `tamp examples run` runs the script of an example or its input, and overwrites
# nothing unasked. Usage: examples.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# A script: that of contact laws draws all of them. It overwrites by force only.
mkdir -p results/contact_load_unload
expect 2 "results/contact_load_unload" "exists" "--force" -- \
  "$tamp" examples run contact_load_unload
[ -z "$(ls results/contact_load_unload)" ] || fail "results were touched"
"$tamp" examples run contact_load_unload --force > out.txt ||
  fail "the script of contact_load_unload"
has results/contact_load_unload/{laws.png,hertz/curve.csv,mdr/curve.csv}

# An input, by the command that it is for: no script beside it.
"$tamp" examples run pack_granules -o packed > out.txt || fail "pack_granules"
has packed/packing_0001.h5 packed/run.json
expect 2 'packed' -- "$tamp" examples run pack_granules -o packed

expect 2 'paper_fig13' 'did you mean' -- "$tamp" examples run paper_fig13
# All figures are found by their numbers; copies of links are files.
"$tamp" examples list > list.txt
for figure in 01 02 03 04 05 06 07 08 09 10 11 12; do
  grep -q "^paper_fig$figure .*[Ff]igure" list.txt || fail "paper_fig$figure"
done
"$tamp" examples copy paper_fig06 copies > out.txt
has copies/paper_fig06/{README.md,fig06.png,paper_fig02.prm}
exit "$failures"
