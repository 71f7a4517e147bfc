# SPDX-License-Identifier: BSD-3-Clause
# Tests the trends that the paper tells, for each packing by itself. Prints
#   trend,packing,number,holds
# What the number is, and what it must be, is in trends.txt.
# Usage: awk -v packings="1 2 3" -v frictions="0.3 ... 0.9" -v limits="..."
#   -f trends.awk states.csv [scaling_N.csv...]
BEGIN {
  FS = ","
  OFS = ","
  split("run packing branch by at strain axial lateral density void Z Zm " \
        "contacts plastic elastic lost", name, " ")
  packing_count = split(packings, packing, " ")
  steps = split(frictions, mu, " ")
  limit_count = split(limits, limit, " ")
  at_strain = "loading strain 0.05;loading strain 0.1"
  at_strains = at_strain ";loading strain 0.15"
  at_stress = "loading axial 1e7;loading axial 2e7;loading axial 3e7"
  start = "loading start 0"
  peak = "unloading peak 1"
  end = "unloading share 0.02"
}
FILENAME ~ /scaling_[0-9]+\.csv$/ {
  p = FILENAME
  gsub(/.*scaling_|\.csv/, "", p)
  stress[p, ++scalings[p]] = $5
  next
}
{
  for (k = 6; k in name; ++k)
    state[$1, $2, $3 " " $4 " " $5, name[k]] = $k
}
function at(run, p, place, what) {
  if (!((run, p, place, what) in state)) {
    print "trends.awk: no state of", run, p, place > "/dev/stderr"
    missing = 1
  }
  return state[run, p, place, what]
}
function verdict(trend, p, number, holds) {
  printf "%s,%s,%.3g,%d\n", trend, p, number, holds
}
# The smallest growth of a quantity from one run to the next, over all places:
# relative, or the difference.
function growth(runs, p, where, what, relative,    n, m, r, k, run, place, g,
                least) {
  n = split(runs, run, " ")
  m = split(where, place, ";")
  least = 1e30
  for (r = 1; r < n; ++r)
    for (k = 1; k <= m; ++k) {
      g = at(run[r + 1], p, place[k], what) - at(run[r], p, place[k], what)
      if (relative)
        g /= at(run[r], p, place[k], what)
      if (g < least)
        least = g
    }
  return least
}
function grows(trend, runs, p, where, what, relative,    least) {
  least = growth(runs, p, where, what, relative)
  verdict(trend, p, least, least > 0)
}
# What is dissipated of the elastic energy that is set free between two states.
function dissipated(run, p, from, to) {
  return (at(run, p, to, "lost") - at(run, p, from, "lost")) / \
         (at(run, p, from, "elastic") - at(run, p, to, "elastic"))
}
# Between two shares of the peak stress: what a column gains over the stress,
# or over its logarithm.
function slope(run, p, from, to, what, logarithmic,    a, b) {
  a = at(run, p, from, "axial")
  b = at(run, p, to, "axial")
  return (at(run, p, to, what) - at(run, p, from, what)) / \
         (logarithmic ? log(b / a) : b - a)
}
# How much harder the last doubling of the stress is than the one before.
function stage_three(run, p) {
  return slope(run, p, "loading share 0.5", peak, "density", 1) / \
         slope(run, p, "loading share 0.25", "loading share 0.5", "density", 1)
}
# How much slower coordination grows over the upper half of the stress than over
# a first part of it.
function settling(run, p) {
  return slope(run, p, "loading share 0.5", peak, "Zm", 0) / \
         slope(run, p, "loading share 0.02", "loading share 0.1", "Zm", 0)
}
function unloading(p,    r, worst, least, early, late, drop, most) {
  worst = 0
  least = 1e30
  most = 0
  for (r = 1; r <= steps + 1; ++r) {
    run = r > steps ? "py1" : "mu" mu[r]
    early = dissipated(run, p, peak, "unloading share 0.5")
    late = dissipated(run, p, "unloading share 0.1", end)
    worst = early > worst ? early : worst
    least = late / early < least ? late / early : least
    drop = 1 - at(run, p, "unloading share 0.1", "plastic") / \
               at(run, p, peak, "plastic")
    most_at_tenth = r == 1 || drop > most_at_tenth ? drop : most_at_tenth
    least_drop = r == 1 || drop < least_drop ? drop : least_drop
    drop = 1 - at(run, p, end, "plastic") / at(run, p, peak, "plastic")
    most = drop > most ? drop : most
  }
  verdict("Q2c", p, worst, worst < 0.1)
  verdict("Q2d", p, least, least > 1)
  verdict("Q5b", p, most_at_tenth, least_drop > 0 && most_at_tenth < 0.2)
  verdict("Q5c", p, most, most > 0 && most < 0.2)
}
function rising(p,    r, k, n, place, g, least) {
  n = split(start ";" at_stress ";" peak, place, ";")
  least = 1e30
  for (r = 1; r <= steps + 1; ++r)
    for (k = 1; k < n; ++k) {
      run = r > steps ? "py1" : "mu" mu[r]
      g = at(run, p, place[k + 1], "plastic") / at(run, p, place[k], "plastic")
      least = g - 1 < least ? g - 1 : least
    }
  verdict("Q5a", p, least, least > 0)
}
function density_scaling(p,    n, low, high, k, least) {
  if (!(p in scalings))
    return
  n = scalings[p]
  low = stress[p, 2] / stress[p, 1] - 1
  high = stress[p, n] / stress[p, n - 1] - 1
  least = 1e30
  for (k = 2; k < n - 1; ++k)
    least = stress[p, k + 1] / stress[p, k] - 1 < least ? \
            stress[p, k + 1] / stress[p, k] - 1 : least
  verdict("Q6a", p, low, low < 0.02 && low > -0.02)
  map = at("ref_mu0.3", p, "loading strain 0.1", "axial")
  verdict("Q6b", p, stress[p, 1] / map - 1, \
          stress[p, 1] / map < 1.03 && stress[p, 1] / map > 0.97)
  verdict("Q6c", p, stress[p, n] / stress[p, 1], \
          least > 0 && stress[p, n] / stress[p, 1] > 1.3)
  verdict("Q6d", p, high, high < 0.02 && high > -0.02)
}
function granules(p,    k, run, first, worst, least, easy, low, high, x) {
  least = 1e30
  for (k = 1; k <= limit_count; ++k) {
    run = "granules" limit[k]
    x = (at(run, p, "loading share 0.01", "density") - \
         at(run, p, start, "density")) / \
        (at(run, p, peak, "density") - at(run, p, start, "density"))
    least = k == 1 || x < least ? x : least
    x = stage_three(run, p)
    easy = k == 1 || x > easy ? x : easy
    x = settling(run, p)
    worst = k == 1 || x > worst ? x : worst
    x = at(run, p, "loading density 0.7", "axial") / limit[k]
    low = k == 1 || x < low ? x : low
    high = k == 1 || x > high ? x : high
  }
  verdict("Q7a", p, least, least > 1 / 3)
  verdict("Q7b", p, easy, easy < 1)
  if (("granules_mdr", p, peak, "density") in state)
    verdict("Q7c", p, stage_three("granules_mdr", p), \
            stage_three("granules_mdr", p) < 1)
  if (("granules_adjusted", p, peak, "density") in state)
    verdict("Q7g", p, stage_three("granules_adjusted", p), \
            stage_three("granules_adjusted", p) < 1)
  verdict("Q7d", p, worst, worst < 0.25)
  if (("granules_mdr", p, peak, "density") in state) {
    x = settling("granules_mdr", p)
    verdict("Q7f", p, x, x < 0.25)
  }
  if (limit_count > 1)
    verdict("Q7e", p, high / low - 1, high / low < 1.1)
}
END {
  rising_mu = falling_mu = ""
  for (r = 1; r <= steps; ++r) {
    rising_mu = rising_mu " mu" mu[r]
    falling_mu = "mu" mu[r] " " falling_mu
  }
  ends = "mu" mu[1] " mu" mu[steps]
  falling_ends = "mu" mu[steps] " mu" mu[1]
  # Packings of mu = 0.3 are the first of both.
  alike = rising_mu
  gsub(/mu/, "alike", alike)
  sub(/alike0.3/, "mu0.3", alike)
  alike_falling = falling_mu
  gsub(/mu/, "alike", alike_falling)
  sub(/alike0.3/, "mu0.3", alike_falling)
  for (k = 1; k <= packing_count; ++k) {
    p = packing[k]
    grows("Q1a", rising_mu, p, at_strains, "axial", 1)
    grows("Q1d", ends, p, at_strains, "axial", 1)
    grows("Q1c", alike, p, at_strain, "axial", 1)
    grows("Q1b", "mu0.3 py1", p, at_strain, "axial", 1)
    grows("Q2a", falling_mu, p, end, "strain", 0)
    grows("Q2f", falling_ends, p, end, "strain", 0)
    grows("Q2e", alike_falling, p, end, "strain", 0)
    grows("Q2b", "py1 mu0.3", p, end, "strain", 0)
    grows("Q3a", falling_mu, p, at_stress, "lateral", 1)
    grows("Q3b", "mu0.3 py1", p, at_stress, "lateral", 1)
    grows("Q4a", falling_mu, p, at_stress, "Zm", 1)
    grows("Q4b", "py1 mu0.3", p, at_stress, "Zm", 1)
    rising(p)
    unloading(p)
    grows("Q5d", falling_mu, p, peak ";" end, "plastic", 1)
    grows("Q5e", falling_mu, p, at_strains, "plastic", 1)
    grows("Q5f", "py1 mu0.3", p, at_stress ";" end, "plastic", 1)
    density_scaling(p)
    granules(p)
  }
  exit missing
}
