# SPDX-License-Identifier: BSD-3-Clause
# Compares states with a table of an independent code. Prints a line for each
# entry of the table that was run:
#   run,place,quantity,expected,tolerance,kind,within,packings,mean,mean_within,
#   smallest,largest
# within of the packings are within the tolerance; mean_within: their mean is.
# Usage: awk -v packings="1 2 3" -f reference.awk states.csv reference.csv
BEGIN {
  FS = ","
  split("run packing branch by at strain axial lateral density void Z Zm " \
        "contacts plastic elastic lost", name, " ")
  count = split(packings, packing, " ")
  print "run,place,quantity,expected,tolerance,kind,within,packings,mean," \
        "mean_within,smallest,largest"
}
/^#/ { next }
FNR == NR {
  for (k = 6; k in name; ++k)
    state[$1, $2, $3 " " $4 " " $5, name[k]] = $k
  next
}
function value(run, p, place, quantity) {
  if (quantity == "lateral_share")
    return state[run, p, place, "lateral"] / state[run, p, place, "axial"]
  if (quantity == "plastic_share")
    return state[run, p, place, "plastic"] / state[run, p, place, "contacts"]
  if (quantity == "recovered")
    return state[run, p, "unloading peak 1", "strain"] - \
           state[run, p, place, "strain"]
  return state[run, p, place, quantity]
}
function fits(x) {
  return x - $4 <= allowed && $4 - x <= allowed
}
$1 != "run" && (($1, packing[1], $2, "strain") in state) {
  allowed = $6 == "relative" ? $5 * $4 : $5
  within = sum = 0
  for (k = 1; k <= count; ++k) {
    if (!(($1, packing[k], $2, "strain") in state)) {
      print "reference.awk: no state of", $1, packing[k], $2 > "/dev/stderr"
      missing = 1
      next
    }
    x = value($1, packing[k], $2, $3)
    within += fits(x)
    sum += x
    smallest = k == 1 || x < smallest ? x : smallest
    largest = k == 1 || x > largest ? x : largest
  }
  printf "%s,%s,%s,%.6g,%s,%s,%d,%d,%.6g,%d,%.6g,%.6g\n", $1, $2, $3, $4, $5,
         $6, within, count, sum / count, fits(sum / count), smallest, largest
}
END { exit missing }
