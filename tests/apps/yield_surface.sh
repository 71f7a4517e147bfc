#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The example probe_yield_surface with fewer grains and branches has about the
# numbers of its README. Usage: yield_surface.sh TAMP
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"

"$tamp" examples copy probe_yield_surface . > /dev/null
has probe_yield_surface/{README.md,probe_yield_surface.prm,yield.png}
"$tamp" probe probe_yield_surface/probe_yield_surface.prm -o out -q --no-plots \
  --set 'Grains/Count = 150' --set 'Scan/Densities = 0.68, 0.80' \
  --set 'Scan/Compression shares = 0.1' --set 'Scan/Triaxial shares =' \
  --set 'Scan/Uniaxial shares ='
# A cell of 150 grains is within 15 % of the mean of three of 300: more than
# five times the scatter of those.
awk -F, 'function near(value, expected) {
    return value > 0.85 * expected && value < 1.15 * expected }
  /^[#r]/ { next }
  $2 == 0.68 { good += near($3, 2.33e6) + near($4, 165e6) + near($5, 153e6) }
  $2 == 0.8 { good += near($3, 5.81e6) + near($4, 289e6) + near($5, 300e6) }
  END { exit good != 6 }' out/moduli.csv || fail "$(cat out/moduli.csv)"
awk -F, '/^[#r]/ { next }
  $5 == 1 && $6 == 2 { peaks++; ratio = $8 / $7
    expected = $2 < 0.7 ? 0.90 : 1.20
    if (ratio < 0.8 * expected || ratio > 1.2 * expected) exit bad = 1 }
  END { exit bad || peaks != 2 }' out/yield.csv || fail "$(cat out/yield.csv)"
echo "all well"
