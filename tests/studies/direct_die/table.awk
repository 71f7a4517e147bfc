# SPDX-License-Identifier: BSD-3-Clause
# Reads files direct.SEED and cells.SEED of lines "strain density upper_pressure
# lower/upper wall_normal_force wall_friction_force density_off_walls" and
# prints, at some strains, mean and standard deviation over the seeds, and the
# difference.
function store(k,    c, share) {
  share = (wanted[k] - before[1]) / ($1 - before[1])
  for (c = 2; c <= 7; ++c) {
    value = before[c] + share * ($c - before[c])
    sum[code, k, c] += value
    squares[code, k, c] += value ^ 2
  }
}
function mean(code, k, c) { return sum[code, k, c] / seeds[code] }
function deviation(code, k, c,    square) {
  if (seeds[code] < 2)
    return 0
  square = (squares[code, k, c] - seeds[code] * mean(code, k, c) ^ 2) \
           / (seeds[code] - 1)
  return square > 0 ? sqrt(square) : 0
}
function both(code, k, c, unit, digits) {
  return sprintf("%.*f ± %.*f", digits, mean(code, k, c) / unit, digits,
                 deviation(code, k, c) / unit)
}
function row(k, c, name, unit, digits,    difference) {
  difference = 100 * (mean("cells", k, c) / mean("direct", k, c) - 1)
  printf "| %.2f | %s | %s | %s | %+.1f | %.1f |\n", wanted[k], name,
         both("direct", k, c, unit, digits), both("cells", k, c, unit, digits),
         difference, 100 * sqrt(deviation("cells", k, c) ^ 2 \
         + deviation("direct", k, c) ^ 2) / mean("direct", k, c)
}
BEGIN {
  count = split("0.01 0.02 0.03 0.05 0.07 0.1", wanted, " ")
}
FNR == 1 {
  code = FILENAME ~ /direct\.[0-9]+$/ ? "direct" : "cells"
  ++seeds[code]
}
{
  for (k = 1; FNR > 1 && k <= count; ++k)
    if (before[1] <= wanted[k] && wanted[k] < $1)
      store(k)
  for (c = 1; c <= 7; ++c)
    before[c] = $c
}
END {
  print "| strain | | die of grains | die of cells | difference % |" \
    " scatter of both % |"
  print "|---|---|---|---|---|---|"
  for (k = 1; k <= count; ++k) {
    row(k, 3, "upper pressure MPa", 1e6, 3)
    row(k, 4, "lower / upper", 1, 4)
    row(k, 5, "wall force N", 1, 1)
    row(k, 6, "wall friction N", 1, 1)
    row(k, 2, "relative density", 1, 4)
    row(k, 7, "off the walls", 1, 4)
  }
}
