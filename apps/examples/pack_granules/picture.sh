#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Draws the grains of a packing as spheres, coloured by their diameters.
# Usage: picture.sh PACKING.txt PICTURE.png
set -euo pipefail
export LC_ALL=C

packing=$1
picture=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Seen from the front, from the right and from above: the farthest grains first,
# each a stack of discs that get lighter towards the lamp.
awk '
  BEGIN { turn = 0.6; lift = 0.45 }
  /^#/ { next }
  {
    across = $1 * cos(turn) + $2 * sin(turn)
    away = $2 * cos(turn) - $1 * sin(turn)
    print away * cos(lift) - $3 * sin(lift), across,
      away * sin(lift) + $3 * cos(lift), $4
  }' "$packing" | sort -g -r | awk '
  BEGIN { discs = 12 }
  {
    for (i = 0; i < discs; ++i) {
      share = i / discs
      print 1e3 * ($2 - 0.35 * share * $4), 1e3 * ($3 + 0.35 * share * $4),
        1e3 * $4 * (1 - share), 2e6 * $4, 0.5 + 0.6 * share
    }
  }' > "$work/discs.txt"

gnuplot << PLOT
set terminal pngcairo size 1000,750 enhanced font "Sans,18"
set output "$picture"
stats "$work/discs.txt" using 4 name "size" nooutput
# A colour of blue, green and yellow by diameter, and its light.
share(d) = size_max > size_min ? (d - size_min) / (size_max - size_min) : 0.5
part(a, b, c, x) = x < 0.5 ? a + 2 * x * (b - a) : b + (2 * x - 1) * (c - b)
shade(a, b, c, x, light) = \
  light * part(a, b, c, x) < 255 ? int(light * part(a, b, c, x)) : 255
colour(d, light) = 65536 * shade(60, 33, 253, share(d), light) \
  + 256 * shade(60, 155, 231, share(d), light) \
  + shade(150, 139, 37, share(d), light)
set palette defined (0 "#3c3c96", 0.5 "#219b8b", 1 "#fde725")
set cbrange [size_min:size_max]
set cblabel "diameter of the grains [{/Symbol m}m]"
set size ratio -1
unset border
unset tics
set cbtics
unset key
set autoscale fix
set offsets 0.4, 0.4, 0.4, 0.4
stats "$work/discs.txt" using 1:2 name "place" nooutput
set arrow from place_min_x, place_min_y rto 1, 0 nohead linewidth 3
set label "1 mm" at place_min_x + 0.5, place_min_y - 0.2 center
plot "$work/discs.txt" using 1:2:3:(colour(\$4, \$5)) with circles \
  fillstyle solid noborder linecolor rgb variable, \
  NaN with points palette
PLOT
