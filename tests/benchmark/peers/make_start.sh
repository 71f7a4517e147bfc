#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the start that all codes share, jammed_1000.txt, from the loose packing
# packing_1000.txt: isotropic compression without friction towards 5 kPa, then
# relaxation at a fixed box. The file is kept, for another version or machine
# makes another packing: the way there is chaotic.
#
#   tests/benchmark/peers/make_start.sh > NEW_START
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release \
  -DTAMP_BENCHMARKS=ON > /dev/null
cmake --build "$root/build" --target peer_case >&2
"$root/build/tests/benchmark/peer_case" jam "$here/packing_1000.txt" 5e3 0
