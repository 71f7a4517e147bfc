# SPDX-License-Identifier: BSD-3-Clause
# Turns what --benchmark_out writes (JSON, an entry a line) into lines
# "name,value,unit": of repeated benchmarks the median, of others the one run.
# The value is that of the benchmark's own counter.
BEGIN {
  unit["particle-steps/s"] = "particle-steps/s"
  unit["s"] = "s"
  unit["bytes"] = "B"
  unit["evaluations"] = unit["error"] = unit["efficiency"] = "-"
}
/^ *"[^"]*": / {
  key = $0
  sub(/^ *"/, "", key)
  sub(/": .*/, "", key)
  text = $0
  sub(/^ *"[^"]*": *"?/, "", text)
  sub(/"?,? *$/, "", text)
  entry[key] = text
}
/^ *{/ { split("", entry) }
/^ *}/ {
  wanted = entry["aggregate_name"] == "median" ||
    (entry["run_type"] == "iteration" && entry["repetitions"] == 1)
  name = entry["run_name"]
  sub(/\/.*/, "", name) # how it was run is no part of the name
  for (key in unit)
    if (wanted && key in entry)
      printf "%s,%.6g,%s\n", name, entry[key], unit[key]
  split("", entry)
}
