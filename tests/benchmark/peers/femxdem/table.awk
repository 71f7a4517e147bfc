# SPDX-License-Identifier: BSD-3-Clause
# Reads lines "step code number updates seconds residual force" of both codes
# and prints them side by side.
$1 == "step" {
  updates[$2, $3] = $4
  seconds[$2, $3] = $5
  residual[$2, $3] = $6
  force[$2, $3] = $7 < 0 ? -$7 : $7
  all[$2] += $5
  if ($3 > steps)
    steps = $3
}
END {
  print "| step | updates: peer | tamp | CPU s per point: peer | tamp | ratio" \
    " | force residual: peer | tamp | end force N: peer | tamp |"
  print "|---|---|---|---|---|---|---|---|---|---|"
  for (k = 1; k <= steps; ++k) {
    p = "femxdem" SUBSEP k
    t = "tamp" SUBSEP k
    printf "| %d | %d | %d | %.2f | %.4f | %.0f | %.1e | %.1e | %.2f | %.2f |\n",
      k, updates[p], updates[t], seconds[p], seconds[t],
      seconds[p] / seconds[t], residual[p], residual[t], force[p], force[t]
  }
  printf "\nCPU seconds per point and load step, mean: peer %.3g, tamp %.3g, ratio %.0f\n",
    all["femxdem"] / steps, all["tamp"] / steps, all["femxdem"] / all["tamp"]
}
