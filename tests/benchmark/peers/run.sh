#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the same grains through other codes and through tamp, on one core each:
# prints a table of speed, stress and coordination number at equal density, and
# writes peers.csv in the current folder.
#
#   tests/benchmark/peers/run.sh [lammps] [liggghts] [yade] [tamp] [femxdem]
#
# Without names the first four. `femxdem` is another case, of finite elements
# with such grains, see femxdem/run.sh; its rows are added to peers.csv.
# Packages of those named are installed if they are missing, but for femxdem's.
# The environment may change: RUNS (timings of each, 5), SPEED_STEPS (time steps
# of a timing, 10000), START (the packing), SPEED_ONLY (if set, no stresses).
set -euo pipefail
export LC_ALL=C

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
build=$root/build
result=$PWD/peers.csv
start=${START:-$here/jammed_1000.txt}
runs=${RUNS:-5}
speed_steps=${SPEED_STEPS:-10000}

# The case. peer_case.cc holds the same numbers.
export youngs=70e6 poisson=0.3 density=2650 friction=0.3 restitution=0.5
export rate=6 dt=1.5e-7 skin=1e-5
read -ra densities <<< "${DENSITIES:-0.66 0.67 0.70}"
warm_up_steps=500 # left out of the timings, with the start of the process

# One core each, whatever the libraries would like.
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
one_core=()
if command -v taskset > /dev/null; then
  first=$(taskset -cp $$ | sed 's/.*: *\([0-9]*\).*/\1/')
  one_core=(taskset -c "$first")
fi

fail() {
  echo "run.sh: $*" >&2
  exit 4
}

# install PACKAGE COMMAND: the package, if its command is missing.
install() {
  command -v "$2" > /dev/null && return 0
  command -v apt-get > /dev/null ||
    fail "'$2' is missing and this is not a Debian system; please install $1"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null ||
      fail "'$2' is missing and only root can install it; as root, run:" \
        "apt-get install --no-install-recommends $1"
    as_root=(sudo)
  fi
  echo "Installing: $1" >&2
  "${as_root[@]}" apt-get update -q >&2 ||
    fail "'apt-get update' failed; check the network and the list of sources"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y \
    --no-install-recommends "$1" >&2 ||
    fail "apt-get could not install '$1', which Debian 12 has; see above"
}

prepare() {
  case $1 in
    lammps) install lammps lmp ;;
    liggghts) install liggghts liggghts ;;
    yade) install yade yade ;;
    tamp)
      cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
        -DTAMP_BENCHMARKS=ON > "$work/configure.log" || {
        cat "$work/configure.log" >&2
        fail "configuring tamp failed; apps/install_packages.sh may help"
      }
      cmake --build "$build" --target peer_case >&2
      ;;
    *) fail "no peer '$1'; expected lammps, liggghts, yade or tamp" ;;
  esac
}

# The start as the data file of LAMMPS and LIGGGHTS.
data_file() {
  awk -v density="$density" '
    $1 == "#" && $2 == "L" { for (k = 0; k < 3; ++k) edge[k] = $(3 + k) }
    $1 != "#" && NF == 4 {
      line[++n] = sprintf("%d 1 %.17g %s %s %s %s",
                          n, 2 * $4, density, $1, $2, $3)
    }
    END {
      print "grains of the peers\n\n" n " atoms\n1 atom types\n"
      for (k = 0; k < 3; ++k)
        print 0, edge[k], substr("xyz", k + 1, 1) "lo",
              substr("xyz", k + 1, 1) "hi"
      print "\nAtoms\n"
      for (i = 1; i <= n; ++i)
        print line[i]
    }' "$start"
}

# The time steps from the start to each density in turn.
steps_between() {
  awk -v wanted="${densities[*]}" -v step="$rate" -v dt="$dt" '
    $1 == "#" && $2 == "L" { volume = $3 * $4 * $5 }
    $1 != "#" && NF == 4 { solid += 16 * atan2(1, 1) / 3 * $4^3 }
    END {
      n = split(wanted, density, " ")
      for (k = 1; k <= n; ++k) {
        now = int(log(density[k] * volume / solid) / (step * dt) + 0.5)
        printf "%d ", now - before
        before = now
      }
    }' "$start"
}

# run_lammps_like COMMAND INPUT STEPS [OPTION...]
run_lammps_like() {
  local command=$1 input=$2 steps=$3 name
  shift 3
  local variables=(-var data "$work/grains.data")
  for name in youngs poisson friction restitution rate dt skin; do
    variables+=(-var "$name" "${!name}")
  done
  # shellcheck disable=SC2086
  "${one_core[@]}" "$command" -in "$here/$input" -log none \
    "${variables[@]}" "$@" -var count $steps
}

# run_peer PEER LAW STEPS: everything it prints, "state" lines among it.
run_peer() {
  local history
  case $1:$2 in
    lammps:displacement) history=mindlin ;;
    lammps:force) history=mindlin/force ;;
    lammps:*) history=mindlin_rescale/force ;;
  esac
  case $1 in
    lammps) run_lammps_like lmp lammps.in "$3" -var history "$history" ;;
    liggghts) run_lammps_like liggghts liggghts.in "$3" ;;
    yade) start=$start steps=$3 "${one_core[@]}" yade -n -x -j1 "$here/yade.py" ;;
    tamp) "${one_core[@]}" "$build/tests/benchmark/peer_case" \
      "$2" "$start" "${@:3}" ;;
  esac < /dev/null
}

# The tangential laws that a peer has. That of tamp is LAMMPS's `rescaled
# force`; it is driven in two ways.
laws_of() {
  case $1 in
    lammps) echo displacement force rescaled_force ;;
    liggghts) echo displacement ;;
    yade) echo force ;;
    tamp) echo dynamics map ;;
  esac
}

checked() { # COMMAND...: its output in $work/out
  local status=0
  "$@" > "$work/out" 2>&1 || status=$?
  [ "$status" -eq 0 ] || {
    tail -n 20 "$work/out" >&2
    fail "'$*' failed; its last lines are above"
  }
}

# What is known on the way, a line PEER LAW DENSITY AXIAL LATERAL Z for each
# density, and the user CPU seconds of all of it: "seconds" PEER LAW SECONDS.
compact() {
  local way seconds TIMEFORMAT=%U
  if [ "$1" = tamp ]; then
    way=("${densities[@]}")
  else
    way=("$(steps_between)")
  fi
  seconds=$({ time checked run_peer "$1" "$2" "${way[@]}" 2>&3; } 3>&2 2>&1)
  awk -v peer="$1" -v law="$2" -v seconds="$seconds" '
    $1 == "state" { print peer, law, $2, $3, ($4 + $5) / 2, $6 }
    $1 == "evaluations" { print "evaluations", peer, law, $2 }
    END { print "seconds", peer, law, seconds }' "$work/out"
}

# User CPU seconds of so many steps, and the steps made: tamp divides a strain
# into steps of its own.
seconds_of() { # PEER STEPS
  local law TIMEFORMAT=%U
  law=$(laws_of "$1" | cut -d ' ' -f 1)
  [ "$1" != tamp ] || law=steps
  { time checked run_peer "$1" "$law" "$2" 2>&3; } 3>&2 2>&1
  awk -v steps="$2" '$1 == "steps" { steps = $2 } END { print steps }' \
    "$work/out"
}

# Particle-steps per second of a peer, once: what a long run takes more than a
# short one, without the start of the process.
speed() {
  local long short grains
  grains=$(awk '$1 != "#" && NF == 4' "$start" | wc -l)
  short=$(seconds_of "$1" "$warm_up_steps")
  long=$(seconds_of "$1" $((warm_up_steps + speed_steps)))
  printf '%s ' "$grains" "$short" "$long" | tr '\n' ' ' |
    awk '{ print $1 * ($5 - $3) / ($4 - $2) }'
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ $# -gt 0 ] || set -- lammps liggghts yade tamp
if [[ " $* " == *" femxdem "* ]]; then
  (cd "$work" && "$here/femxdem/run.sh")
  read -ra others <<< "$(sed 's/ femxdem / /g' <<< " $* ")"
  set -- ${others[@]+"${others[@]}"}
fi
for peer in "$@"; do
  prepare "$peer"
done
data_file > "$work/grains.data"

# All codes in turn, round by round: other work on the machine slows them alike.
for round in $(seq "$runs"); do
  echo "timing: round $round of $runs" >&2
  for peer in "$@"; do
    speed "$peer" >> "$work/speed.$peer"
  done
done
for peer in "$@"; do
  sort -g -o "$work/speed.$peer" "$work/speed.$peer"
  [ -z "${SPEED_ONLY:-}" ] || continue
  for law in $(laws_of "$peer"); do
    echo "compacting: $peer, $law" >&2
    compact "$peer" "$law" >> "$work/states"
  done
done

# The CSV, then the same for people.
{
  echo "# date: $(date -u +%Y-%m-%dT%H:%M:%SZ)"
  echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo |
    head -n 1), $(env -u OMP_NUM_THREADS nproc) cores, $(uname -sm)"
  echo "# version: $(git -C "$root" describe --always --dirty 2> /dev/null ||
    echo unknown)"
  echo "# load: $(cut -d ' ' -f 1-3 /proc/loadavg)"
  echo "name,value,unit"
  for peer in "$@"; do
    awk -v name="peer.$peer.1000" '
      { v[NR] = $1 }
      END {
        print name "," v[int((NR + 1) / 2)] ",particle-steps/s"
        print name ".slowest," v[1] ",particle-steps/s"
        print name ".fastest," v[NR] ",particle-steps/s"
      }' "$work/speed.$peer"
  done
  [ ! -e "$work/states" ] || awk '
    $1 == "evaluations" || $1 == "seconds" {
      print "peer." $2 "." $3 "." $1 "," $4 "," ($1 == "seconds" ? "s" : "-")
      next
    }
    {
      name = sprintf("peer.%s.%s.%%s.%.4f,%%s,%%s\n", $1, $2, $3)
      printf name, "axial_stress", $4, "Pa"
      printf name, "lateral_stress", $5, "Pa"
      printf name, "coordination_number", $6, "-"
    }' "$work/states"
  [ ! -e "$work/femxdem.csv" ] || grep '^peer' "$work/femxdem.csv"
} > "$result"

echo
[ $# -eq 0 ] ||
  echo "particle-steps/s on one core (median, slowest, fastest of $runs)"
for peer in "$@"; do
  awk -v peer="$peer" '
    { v[NR] = $1 / 1e6 }
    END {
      printf "  %-10s %7.2f M  %7.2f  %7.2f\n",
             peer, v[int((NR + 1) / 2)], v[1], v[NR]
    }' "$work/speed.$peer"
done
[ ! -e "$work/states" ] || awk -f "$here/table.awk" "$work/states"
echo
echo "written: $result"
