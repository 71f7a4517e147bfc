# SPDX-License-Identifier: BSD-3-Clause
# The states of a probe (curve.csv) at wanted places, linear in between, one
# line each:
#   run,packing,branch,by,at,strain,axial,lateral,density,void,Z,Zm,contacts,
#   plastic,elastic,lost
# strain is engineering strain since the start of the path; axial and lateral
# stress in Pa; energy density elastic, and lost to yield and friction, in J/m3.
# Usage: awk -v run=NAME -v packing=N -v wanted="loading axial 1e7;..."
#   branch loading or unloading; by a column, or share (of the peak stress);
#   "loading start 0" and "unloading peak 1" are the first state and the peak.
# A place that the path does not come to gives no line.
BEGIN {
  FS = ","
  places = split(wanted, place, ";")
  names = split("strain axial lateral density void Z Zm contacts plastic " \
                "elastic lost", name, " ")
}
/^#/ { next }
!width {
  for (k = 1; k <= NF; ++k)
    column[$k] = k
  width = NF
  next
}
{
  ++rows
  v[rows, "strain"] = 1 - exp(-$column["strain_zz[-]"])
  v[rows, "axial"] = $column["stress_zz[Pa]"]
  v[rows, "lateral"] = ($column["stress_xx[Pa]"] + $column["stress_yy[Pa]"]) / 2
  v[rows, "density"] = $column["relative_density[-]"]
  v[rows, "void"] = $column["void_ratio[-]"]
  v[rows, "Z"] = $column["coordination_number[-]"]
  v[rows, "Zm"] = $column["mechanical_coordination_number[-]"]
  v[rows, "contacts"] = $column["contacts[-]"]
  v[rows, "plastic"] = $column["plastic_contacts[-]"]
  v[rows, "elastic"] = $column["elastic_energy[J/m3]"]
  v[rows, "lost"] = $column["plastic_dissipation[J/m3]"] + \
                    $column["friction_dissipation[J/m3]"]
  if (!peak || v[rows, "axial"] > v[peak, "axial"])
    peak = rows
}
# Prints the state between rows j - 1 and j, at the share t of the way.
function say(place, j, t,    k, line) {
  line = run "," packing "," place
  gsub(" ", ",", line)
  for (k = 1; k <= names; ++k)
    line = line sprintf(",%.9g", t == 1 ? v[j, name[k]] : \
                        (1 - t) * v[j - 1, name[k]] + t * v[j, name[k]])
  print line
}
function find(place, branch, by, at,    j, from, to, a, b) {
  if (by == "start" || by == "peak") {
    say(place, by == "start" ? 1 : peak, 1)
    return
  }
  if (by == "share") {
    by = "axial"
    at *= v[peak, "axial"]
  }
  from = branch == "loading" ? 1 : peak
  to = branch == "loading" ? peak : rows
  for (j = from + 1; j <= to; ++j) {
    a = v[j - 1, by]
    b = v[j, by]
    if (a != b && (a - at) * (b - at) <= 0) {
      say(place, j, (at - a) / (b - a))
      return
    }
  }
}
END {
  for (p = 1; p <= places; ++p) {
    split(place[p], word, " ")
    find(place[p], word[1], word[2], word[3] + 0)
  }
}
