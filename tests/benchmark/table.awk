# SPDX-License-Identifier: BSD-3-Clause
# Prints lines "name,value,unit" as a table beside what is asked of them, from
# the first file, lines "name,must,aim". More is better of rates and of
# efficiency, less of all else.
BEGIN {
  FS = ","
  form = "%-44s %12s  %-16s  %8s  %8s  %s\n"
  printf form, "name", "value", "unit", "must", "aim", ""
}
/^#/ || $1 == "name" { next }
FNR == NR { must[$1] = $2; aim[$1] = $3; next }
function reached(figure) {
  if (figure == "")
    return 0
  return more ? $2 + 0 >= figure + 0 : $2 + 0 <= figure + 0
}
{
  more = $3 == "particle-steps/s" || $1 ~ /efficiency/
  verdict = ""
  if ($1 in must)
    verdict = reached(aim[$1]) ? "aim reached" : \
      reached(must[$1]) ? "met" : "MISSED"
  printf form, $1, $2, $3, must[$1], aim[$1], verdict
}
