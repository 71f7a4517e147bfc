#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Mesh study of a die pressed with wall friction, all points cells of grains:
# one packing at all points, which leaves the mesh alone to differ, and, with
# packings of their own, the scatter over seeds. Twenty minutes of one core.
#
#   [TAMP=PROGRAM] tests/studies/die_mesh.sh [FINEST [SEEDS]]
#
# FINEST: elements along the radius of the finest mesh, 2, 4, 8 or 16.
source "$(dirname "$0")/common.sh"
finest=${1:-16}
seeds=${2:-5}

# Standard deviation over the volume, and range, of the density in a map: parts
# of four corners r, z with a value, mirrored at the axis.
spread() {
  awk '
    /^#/ || NF < 3 { next }
    { r[n] = $1; z[n] = $2; n = (n + 1) % 4 }
    n == 0 && r[1] > 0 && r[3] > 0 {
      # corners 0 1 below, 2 3 above; area of 0 1 3 2 by its diagonals
      area = 0.5 * ((r[3] - r[0]) * (z[2] - z[1]) \
                    - (r[2] - r[1]) * (z[3] - z[0]))
      volume = area * (r[0] + r[1] + r[2] + r[3])
      all += volume; sum += volume * $3; of2 += volume * $3 ^ 2
      if (!least || $3 < least) least = $3
      if ($3 > most) most = $3
    }
    END {
      mean = sum / all
      print sqrt(of2 / all - mean ^ 2), most - least
    }' "$1"
}

# line NAME MESH SEED SAME: presses and tells what the last step ended with.
line() {
  run die "$1" "Schedule/Stages = press to density 0.85" \
    "Output/Grain output = none" "Output/Field interval = 1000" \
    "Die/Elements = $2" "Packing/Seed = $3" "Packing/Same at all points = $4"
  echo "${2/, /x} $(columns "$scratch/$1/curve.csv" \
    upper_force lower_force wall_normal_force | tail -n 1)" \
    "$(spread "$scratch/$1/plots/density_map.dat")" \
    "$(columns "$scratch/$1/curve.csv" cell_updates |
      awk '{ sum += $1 } END { print sum / (NR - 1) }')"
}

echo "One packing at all points"
echo
echo "| elements | upper force N | % | lower / upper | wall force N | % |" \
  "density: deviation | % | max - min | % | updates |"
echo "|---|---|---|---|---|---|---|---|---|---|---|"
for radial in 2 4 8 16; do
  [ "$radial" -le "$finest" ] || break
  line "same_$radial" "$radial, $((2 * radial))" 1 true
done | awk '
  function change(k,    last) {
    last = before[k]
    before[k] = $k
    return last ? sprintf("%+.2f", 100 * ($k / last - 1)) : "-"
  }
  {
    printf "| %s | %.1f | %s | %.4f | %.1f | %s | %.5f | %s | %.4f | %s | %.2f |\n",
      $1, $2, change(2), $3 / $2, $4, change(4), $5, change(5), $6, change(6), $7
    fflush()
  }'

echo
echo "Packings of their own, mean and standard deviation over $seeds seeds"
echo
echo "| elements | upper force N | lower / upper | wall force N |" \
  "density: deviation | max - min |"
echo "|---|---|---|---|---|---|"
for radial in 2 4 8; do
  [ "$radial" -le "$finest" ] || break
  for seed in $(seq "$seeds"); do
    line "own_${radial}_$seed" "$radial, $((2 * radial))" "$seed" false
  done | awk '
    { value[1] = $2; value[2] = $3 / $2; value[3] = $4; value[4] = $5
      value[5] = $6
      for (k = 1; k <= 5; ++k) { sum[k] += value[k]; of2[k] += value[k] ^ 2 } }
    function both(k, digits,    mean, square) {
      mean = sum[k] / NR
      square = NR > 1 ? (of2[k] - NR * mean ^ 2) / (NR - 1) : 0
      return sprintf("%.*f ± %.*f", digits, mean, digits,
        square > 0 ? sqrt(square) : 0)
    }
    END { print "| " $1 " | " both(1, 1) " | " both(2, 4) " | " both(3, 1) \
      " | " both(4, 5) " | " both(5, 4) " |" }'
done
