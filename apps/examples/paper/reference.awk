# SPDX-License-Identifier: BSD-3-Clause
# Compares states with a table of an independent code: those of the map (runs
# ref_...), and those by the protocol of that code (runs dyn_...), if there are.
# Prints a line for each entry of the table that was run:
#   run,place,quantity,expected,tolerance,kind,within,packings,mean,mean_within,
#   smallest,largest,
#   dynamics_within,dynamics_mean,dynamics_mean_within,dynamics_smallest,
#   dynamics_largest,t,at_density,at_density_within
# within of the packings are within the tolerance; mean_within: their mean is.
# t: the mean of both kinds less the expected value, over the deviation of such a
# difference, (1/n + 1/m)^(1/2) times that of one of these n packings, if the m
# samples of the other code scatter alike. at_density: where there are packings
# of other densities, too (runs den_...), on the line through all, over their
# density at 100 kPa, at the density of the other code.
# Usage: awk -v packings="1 2 3" -f reference.awk states.csv reference.csv \
#   reference.csv (twice: its densities are read first)
BEGIN {
  FS = ","
  split("run packing branch by at strain axial lateral density void Z Zm " \
        "contacts plastic elastic lost", name, " ")
  count = split(packings, packing, " ")
  start = "loading start 0"
  print "run,place,quantity,expected,tolerance,kind,within,packings,mean," \
        "mean_within,smallest,largest,dynamics_within,dynamics_mean," \
        "dynamics_mean_within,dynamics_smallest,dynamics_largest,t," \
        "at_density,at_density_within"
}
FNR == 1 { ++file }
/^#/ { next }
file == 1 {
  for (k = 6; k in name; ++k)
    state[$1, $2, $3 " " $4 " " $5, name[k]] = $k
  next
}
file == 2 {
  if ($3 == "density")
    its_density[$1] = $4
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
# Adds the packings of a run to within, sums, smallest and largest. False if a
# state is missing.
function add(run,    k, x, d) {
  for (k = 1; k <= count; ++k) {
    if (!((run, packing[k], $2, "strain") in state)) {
      print "reference.awk: no state of", run, packing[k], $2 > "/dev/stderr"
      missing = 1
      return 0
    }
    x = value(run, packing[k], $2, $3)
    d = state[run, packing[k], start, "density"]
    within += fits(x)
    smallest = !n || x < smallest ? x : smallest
    largest = !n || x > largest ? x : largest
    ++n
    sum += x
    sum2 += x * x
    sum_d += d
    sum_d2 += d * d
    sum_dx += d * x
  }
  mean = sum / n
  return 1
}
function survey(run) {
  n = within = sum = sum2 = sum_d = sum_d2 = sum_dx = 0
  return add(run)
}
# Of all added.
function t_value(samples,    deviation) {
  if (n < 4 || $3 == "plastic_share") # which depends on the kind
    return ""
  deviation = (sum2 - n * mean * mean) / (n - 1) * (1 / n + 1 / samples)
  return deviation > 1e-12 ? sprintf("%.2g", (mean - $4) / sqrt(deviation)) : ""
}
function on_line(density,    d) {
  d = sum_d / n
  return mean + (sum_dx - n * d * mean) / (sum_d2 - n * d * d) * (density - d)
}
$1 != "run" && (($1, packing[1], $2, "strain") in state) {
  allowed = $6 == "relative" ? $5 * $4 : $5
  if (!survey($1))
    next
  line = sprintf("%s,%s,%s,%.6g,%s,%s,%d,%d,%.6g,%d,%.6g,%.6g", $1, $2, $3, $4,
                 $5, $6, within, count, mean, fits(mean), smallest, largest)
  run = "dyn" substr($1, 4)
  if (!((run, packing[1], $2, "strain") in state))
    line = line ",,,,,,,,"
  else if (survey(run)) {
    line = line sprintf(",%d,%.6g,%d,%.6g,%.6g", within, mean, fits(mean),
                        smallest, largest)
    add($1)
    line = line "," t_value($1 == "ref_mu0.3" ? 2 : 1)
    run = "den" substr($1, 4)
    if (((run, packing[1], $2, "strain") in state) && add(run) && n > 3) {
      x = on_line(its_density[$1])
      line = line sprintf(",%.6g,%d", x, fits(x))
    } else
      line = line ",,"
  }
  print line
}
END { exit missing }
