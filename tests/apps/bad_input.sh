#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Wrong input files end with the exit code and the message that users are
# promised. Usage: bad_input.sh TAMP
. "$(dirname "$(realpath "$0")")/expect.sh"

# input TEXT: a probe of a quick law with TEXT in front.
input() {
  printf '%s\n' "$1" > bad.prm
  printf 'subsection Material\n  set Type = elastic\nend\n' >> bad.prm
}
in_section() {
  input "$(printf 'subsection %s\n  set %s\nend' "$1" "$2")"
}
run() {
  expect "$@" -- "$tamp" probe bad.prm -o results
}

in_section Contact 'Limiting presure = 50 MPa'
run 2 'bad.prm:2' 'Limiting presure' 'Limiting contact pressure'
in_section Contct 'Friction coefficient = 0.3'
run 2 'bad.prm:1' 'Contct' "'Contact'"
in_section Contact 'Limiting contact pressure = 50 mm'
run 2 'bad.prm:2' '50 mm' 'a length' 'a pressure'
in_section Contact 'Limiting contact pressure = 50 MPaa'
run 2 'bad.prm:2' 'MPaa' 'a pressure'
in_section Grains "Young's modulus = -70 GPa"
run 2 'bad.prm:2' '-70 GPa' '> 0'
in_section Grains "Poisson's ratio = 0.5"
run 2 'bad.prm:2' '0.5' '< 0.5'
in_section Contact 'Limiting contact pressure = 0 Pa'
run 2 'bad.prm:2' '> 0'
in_section Contact 'Limiting contact pressure = -1 MPa'
run 2 'bad.prm:2' '-1 MPa' '> 0'
in_section Contact 'Normal law = herz'
run 2 'bad.prm:2' 'herz' 'hertz'
in_section Path 'Stages = uniaxial to stain 0.1'
run 2 'bad.prm:2' 'stain' 'strain'
in_section Path 'Stages = csv nowhere.csv'
run 2 'bad.prm:2' 'nowhere.csv'
input 'set Count = 5'
run 2 'bad.prm:1' 'Count' "'Grains'"
input 'subsection Grains'
run 2 'bad.prm:1' "no 'end'"
input 'sett Count = 5'
run 2 'bad.prm:1' 'sett'
[ ! -e results ] || { echo "FAILED: results were written"; exit 1; }

printf 'subsection Material\n  set Type = unit sell\nend\n' > bad.prm
run 2 'bad.prm:2' 'unit sell' 'unit cell'

echo "$failures failures"
[ "$failures" -eq 0 ]
