# SPDX-License-Identifier: BSD-3-Clause
# From the lines of states.awk of one run: the band of all packings as a closed
# polygon, then, after two empty lines, the mean curve; columns x y.
# Usage: awk -v run=NAME -v x=strain -v y=axial -v across=x|y
#   across: along which axis packings are spread at each place.
BEGIN {
  FS = ","
  split("run packing branch by at strain axial lateral density void Z Zm " \
        "contacts plastic elastic lost", name, " ")
  for (k = 1; k in name; ++k)
    column[name[k]] = k
}
$1 == run {
  place = $3 " " $4 " " $5
  if (!(place in count))
    order[++places] = place
  a = $column[x]
  b = $column[y]
  spread = across == "x" ? a : b
  if (!count[place] || spread < low[place])
    low[place] = spread
  if (!count[place] || spread > high[place])
    high[place] = spread
  ++count[place]
  sum_x[place] += a
  sum_y[place] += b
}
function point(place, spread) {
  if (across == "x")
    print spread, sum_y[place] / count[place]
  else
    print sum_x[place] / count[place], spread
}
END {
  for (p = 1; p <= places; ++p)
    point(order[p], low[order[p]])
  for (p = places; p > 0; --p)
    point(order[p], high[order[p]])
  print "\n"
  for (p = 1; p <= places; ++p)
    print sum_x[order[p]] / count[order[p]], sum_y[order[p]] / count[order[p]]
}
