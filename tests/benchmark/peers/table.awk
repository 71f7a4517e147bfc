# SPDX-License-Identifier: BSD-3-Clause
# Reads lines "peer law density axial lateral Z" and prints them with what
# separates each from LAMMPS with the same tangential law, or from the first
# code that ran with it.
function same_law(peer, law)
{
  return peer == "tamp" ? "rescaled_force" : law
}
function per_cent(value, wanted)
{
  return sprintf("%+.2f %%", 100 * (value / wanted - 1))
}
BEGIN {
  print ""
  printf "%-8s %-9s %-15s %9s %9s %7s %7s   %s\n", "density", "code", "law",
         "axial/kPa", "lat./kPa", "lat/ax", "Z",
         "axial, lateral, Z against the first with this law"
}
$1 == "evaluations" {
  evaluations[$2, $3] = $4
  next
}
$1 == "seconds" {
  cost = cost sprintf("%-9s %-15s %9.2f s", $2, $3, $4)
  if (($2, $3) in evaluations)
    cost = cost sprintf("   %d evaluations of all forces", evaluations[$2, $3])
  cost = cost "\n"
  next
}
{
  density = sprintf("%.4f", $3)
  key = density SUBSEP same_law($1, $2)
  if (!(key in axial)) {
    axial[key] = $4
    lateral[key] = $5
    z[key] = $6
  }
  if (!(density in seen)) {
    seen[density] = 1
    order[++densities] = density
  }
  line[density] = line[density] sprintf(\
    "%-8s %-9s %-15s %9.2f %9.2f %7.4f %7.3f   %s, %s, %s\n", density, $1, $2,
    $4 / 1e3, $5 / 1e3, $5 / $4, $6, per_cent($4, axial[key]),
    per_cent($5, lateral[key]), per_cent($6, z[key]))
}
END {
  for (k = 1; k <= densities; ++k)
    printf "%s", line[order[k]]
  print "\nuser CPU seconds of the whole compaction"
  printf "%s", cost
}
