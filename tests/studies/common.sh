# SPDX-License-Identifier: BSD-3-Clause
# Common to the studies; read by them, not run. Sets `tamp`, `powder` (the
# input whose powder is studied) and `scratch`, which is removed at the end.
set -euo pipefail
export LC_ALL=C OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tamp=${TAMP:-$root/build/apps/tamp}
powder=$root/apps/examples/die_default/die_default.prm
if [ ! -x "$tamp" ]; then
  echo "no program $tamp: build it, or set TAMP to it" >&2
  exit 2
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# run COMMAND FOLDER "Section/Name = value"...: of the studied powder, on one
# thread; the results are in $scratch/FOLDER.
run() {
  local command=$1 folder=$2 value
  local options=()
  shift 2
  for value in "$@"; do
    options+=(--set "$value")
  done
  nice -n 10 "$tamp" "$command" "$powder" -o "$scratch/$folder" -q \
    --threads 1 ${options[@]+"${options[@]}"} 2> "$scratch/messages" || {
    cat "$scratch/messages" >&2
    exit 1
  }
}

# Columns of a curve, by their names without units, as plain numbers.
columns() {
  local file=$1
  shift
  awk -F, -v wanted="$*" '
    /^#/ { next }
    !count {
      count = split(wanted, names, " ")
      for (i = 1; i <= NF; ++i) {
        sub(/\[.*/, "", $i)
        place[$i] = i
      }
      for (k = 1; k <= count; ++k)
        if (!(names[k] in place)) {
          print FILENAME ": no column " names[k] > "/dev/stderr"
          exit 1
        }
      next
    }
    {
      for (k = 1; k <= count; ++k)
        printf "%s%s", $place[names[k]], k < count ? " " : "\n"
    }' "$file"
}
