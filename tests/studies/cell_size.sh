#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# How much a cell's answer depends on its number of grains and on its seed:
# axial stress p and k = lateral / axial stress under uniaxial strain, of many
# packings. A few minutes.
#
#   [TAMP=PROGRAM] tests/studies/cell_size.sh [SEEDS]
#
# Each line: mean and its standard error, which is the scatter over the root of
# the number of seeds; the scatter, standard deviation over mean; the scatter
# times the root of the number of grains, which is constant if grains are
# independent; and the difference of the mean from that of 2000 grains.
source "$(dirname "$0")/common.sh"
seeds=${1:-20}
sizes="200 500 1000 2000"

for size in $sizes; do
  for seed in $(seq "$seeds"); do
    run probe "cell_${size}_$seed" "Grains/Count = $size" \
      "Packing/Seed = $seed" "Path/Stages = uniaxial to strain 0.3"
    columns "$scratch/cell_${size}_$seed/curve.csv" strain_zz stress_zz \
      stress_xx stress_yy relative_density |
      awk -v size="$size" '
        function near(x) { return $1 > x - 1e-6 && $1 < x + 1e-6 }
        near(0) { print size, 0, "density", $5 }
        near(0.05) || near(0.1) || near(0.2) || near(0.3) {
          print size, $1, "p", $2 / 1e6
          print size, $1, "k", ($3 + $4) / 2 / $2
        }'
  done
done > "$scratch/values"

echo "| strain | of | grains | mean | ± | scatter % | scatter × √N |" \
  "against 2000 % |"
echo "|---|---|---|---|---|---|---|---|"
sort -k2,2g -k3,3 -k1,1gr -s "$scratch/values" | awk '
  function tell(    mean, scatter) {
    mean = sum / n
    scatter = sqrt((of2 - n * mean ^ 2) / (n - 1)) / mean
    if (size == 2000)
      largest = mean
    printf "| %s | %s | %d | %.4g | %.2g | %.2f | %.2f | %+.2f |\n", strain,
      what, size, mean, scatter * mean / sqrt(n), 100 * scatter,
      scatter * sqrt(size), 100 * (mean / largest - 1)
  }
  n && ($1 != size || $2 != strain || $3 != what) {
    tell()
    n = sum = of2 = 0
  }
  { size = $1; strain = $2 + 0; what = $3; ++n; sum += $4; of2 += $4 ^ 2 }
  END { tell() }'
