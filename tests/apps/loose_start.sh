#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A die of loose cells starts at 0.1 MPa, where some of its small cells give
# way: no start gets stuck, and what is out of balance is said.
# Usage: loose_start.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

cat > die.prm << 'END'
include granules.prm
subsection Grains
  set Count = 100
end
subsection Packing
  set Pressure = 0.1 MPa
end
subsection Die
  set Fill height = 3 mm
  set Elements    = 2, 3
end
subsection Schedule
  set Stages = press to density 0.595
end
END

# Cells of seed 2 scatter, those of seed 4 lose all their stress.
for seed in 2 4; do
  "$tamp" die die.prm --set "Packing/Seed = $seed" -o "$seed" -q --no-plots ||
    fail "seed $seed: exit code $?"
  number=$(sed -n 's/^ *steps out of balance *//p' "$seed/summary.txt")
  [ "$number" -gt 0 ] || fail "seed $seed: $number steps out of balance"
  grep -q 'accepted out of balance' "$seed/summary.txt" || fail "seed $seed: no warning"
  # Within ten tolerances, as the warning says.
  awk -F, '
    /^#/ { next }
    !n { for (n = 1; $n !~ /^force_residual/;) ++n; next }
    $n > 1e-2 { exit 1 }' "$seed/curve.csv" || fail "seed $seed: residual"
done
