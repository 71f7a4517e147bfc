#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A probe that was killed, stopped or had its checkpoints damaged goes on with
# --resume and leaves what an uninterrupted one leaves, scans and all; what cannot
# be resumed is refused, and touched by nothing.
# Usage: resume_probe.sh TAMP [cells|law|replicas|refused]
command=probe key_results=9
source "$(dirname "${BASH_SOURCE[0]}")/resumed.sh"
part=$2

cat > cells.prm << 'END_OF_INPUT'
include granules.prm
subsection Path
  set Stages = uniaxial to density 0.7; unload to 30 % of peak; isotropic to density 0.71
end
subsection Scan
  set Densities          = 0.68, 0.7
  set Compression shares = 0.3
  set Triaxial shares    =
  set Uniaxial shares    =
end
subsection Output
  set Checkpoint interval = 1 us
end
END_OF_INPUT
cat > law.prm << 'END_OF_INPUT'
subsection Material
  set Type = drucker-prager cap
end
subsection Path
  set Stages = uniaxial to density 0.5; unload to 30 % of peak; simple shear to strain 0.05; triaxial by strain 0.02 at pressure 10 MPa
  set Maximum strain increment    = 4e-3
  set Maximum unloading increment = 5e-4
end
subsection Scan
  set Densities = 0.36, 0.38, 0.4, 0.42, 0.44, 0.46, 0.48
end
subsection Output
  set Checkpoint interval = 1 us
end
END_OF_INPUT

case $part in
  cells | law)
    # At places all along the way; asked while it packs.
    goes_on $part run.json 5 9 13
    has killed/yield.csv killed/moduli.csv
    ;;
  refused)
    refuses 60 'Scan/Strain offset = 1e-3' 'Scan/Strain offset'
    ;;
esac

# Each of several cells goes on from its own checkpoint.
if [ "$part" = replicas ]; then
  sed -i 's/Densities .*/Densities = 0.7/' cells.prm
  several=(--replicas 2 --threads 2)
  "$tamp" probe cells.prm -o whole --no-plots -q "${several[@]}"
  watched=killed/size_00060_seed_2
  kill_after KILL 12 cells.prm killed "${several[@]}"
  watched=killed/size_00060_seed_1
  kill_after TERM 16 cells.prm killed "${several[@]}" --resume
  [ "$status" -eq 143 ] || fail "SIGTERM: exit code $status"
  "$tamp" probe cells.prm -o killed --no-plots -q "${several[@]}" --resume
  for seed in 1 2; do
    grep -q 'going on after step' killed/size_00060_seed_$seed/log.txt ||
      fail "the cell of seed $seed began anew"
  done
  (cd whole && find . -name '*.csv' -o -name '*.vtp') | while read -r file; do
    cmp "whole/$file" "killed/$file" || exit 1
  done || fail "the killed run ends otherwise"
  # Killed as it began.
  rm -r killed/size_00060_seed_2/*
  touch killed/size_00060_seed_2/run.json.part
  "$tamp" probe cells.prm -o killed --no-plots -q "${several[@]}" --resume
  cmp {whole,killed}/size_00060_seed_2/curve.csv || fail "a cell that began anew"
  expect 2 '--replicas' 'Nothing was changed' -- \
    "$tamp" probe cells.prm -o killed --no-plots -q --resume
  [ "$failures" -eq 0 ] || exit 1
  echo "all well"
fi

