#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Wrong meshes and geometries are refused before anything is written, by a run
# or a check: exit code 2, one message with entry, file, what is wrong
# and where. Usage: bad_mesh.sh TAMP cells|files|geometry
. "$(dirname "$(realpath "$0")")/expect.sh"

# mesh OPTION=1...: bad.msh, three by three squares of 2 mm, but for what the
# options spoil.
mesh() {
  local options=()
  for option in "$@"; do
    options+=(-v "$option")
  done
  awk "${options[@]}" 'function node(i, j) { return 4 * j + i + 1 }
    function name(number, word) {
      names[++named] = "1 " number " \"" word "\"" }
    function line(number, a, b) {
      elements[++count] = count " 1 2 " number " " number " " a " " b }
    function cell(a, b, c, d) {
      if (!triangles)
        elements[++count] = count " 3 2 5 5 " a " " b " " c " " d
      else {
        elements[++count] = count " 2 2 5 5 " a " " b " " c
        elements[++count] = count " 2 2 5 5 " a " " c " " d
      } }
    BEGIN {
      name(1, "punch_bottom"); name(2, misspelt ? "die_wal" : "die_wall")
      if (!nameless) name(3, "punch_top")
      name(4, "axis")
      for (i = 0; i < 3; ++i) {
        line(1, node(i, 0), node(i + 1, 0))
        if (!bare || i != 1) line(2, node(3, i), node(3, i + 1))
        line(3, node(i + 1, 3), node(i, 3))
        line(4, node(0, i + 1), node(0, i))
      }
      for (j = 0; j < 3; ++j)
        for (i = 0; i < 3; ++i)
          if (!hole || i != 1 || j != 1)
            cell(node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1))
      print "$MeshFormat\n2.2 " (binary ? 1 : 0) " 8\n$EndMeshFormat"
      print "$PhysicalNames\n" named + 1
      for (i = 1; i <= named; ++i) print names[i]
      print "2 5 \"powder\"\n$EndPhysicalNames\n$Nodes\n16"
      for (j = 0; j < 4; ++j)
        for (i = 0; i < 4; ++i) {
          spoilt = inverted && i == 1 && j == 1
          print node(i, j), (spoilt ? 5 : 2 * i) * 1e-3,
            (spoilt ? 5 : 2 * j) * 1e-3, 0
        }
      print "$EndNodes\n$Elements\n" count
      for (i = 1; i <= count; ++i) print elements[i]
      print "$EndElements" }' > bad.msh
}

# solid_mesh TYPE NODES...: a quarter of one element of gmsh's type, with faces.
solid_mesh() {
  cat > bad.msh << END
\$MeshFormat
2.2 0 8
\$EndMeshFormat
\$PhysicalNames
6
2 1 "punch_bottom"
2 2 "punch_top"
2 3 "die_wall"
2 4 "symmetry_x"
2 5 "symmetry_y"
3 6 "powder"
\$EndPhysicalNames
\$Nodes
8
1 0 0 0
2 6e-3 0 0
3 3.5e-3 3.5e-3 0
4 0 6e-3 0
5 0 0 5e-3
6 6e-3 0 5e-3
7 3.5e-3 3.5e-3 5e-3
8 0 6e-3 5e-3
\$EndNodes
\$Elements
7
1 3 2 1 1 1 4 3 2
2 3 2 2 2 5 6 7 8
3 3 2 3 3 2 3 7 6
4 3 2 3 3 3 4 8 7
5 3 2 4 4 1 5 8 4
6 3 2 5 5 1 2 6 5
7 $1 2 6 6 ${*:2}
\$EndElements
END
}

cat > die.prm << 'END'
subsection Material
  set Type = elastic
end
subsection Die
  set Shape = file
  set Mesh file = bad.msh
end
subsection Schedule
  set Stages = press to displacement 0.01 mm
end
END

# refused TEXT... -- OPTION...: by the run and by the check in turn, which read
# alike, and nothing is there.
command=check
refused() {
  local texts=()
  while [ "$1" != -- ]; do
    texts+=("$1")
    shift
  done
  shift
  ls > before.txt
  local options=("$@")
  if [ "$command" = check ]; then
    command=die
    options+=(-o results)
  else
    command=check
  fi
  expect 2 'Die/' "${texts[@]}" -- "$tamp" "$command" die.prm \
    "${options[@]}"
  rm -f out.txt err.txt
  ls > after.txt
  diff <(grep -v txt before.txt) <(grep -v txt after.txt) ||
    fail "something was written"
}
bad() { refused die.prm:6 'Die/Mesh file' bad.msh "$@" --; }

case $2 in
cells)
# The mesh that all others spoil can be pressed.
mesh
"$tamp" die die.prm -o good --no-plots -q || fail "the sound mesh"

mesh triangles=1
bad 'triangles (18)' 'quadrilaterals' 'recombine'
solid_mesh 4 1 2 4 5
bad 'tetrahedra (1)' 'hexahedra' 'recombine'
mesh nameless=1
bad "'punch_top'" 'required are'
mesh misspelt=1
bad "'die_wall'" 'required are'
mesh inverted=1
bad 'inverted cell' '(r, z) = (' 'mm'
mesh hole=1
bad 'belong to no tool: 4' '(r, z) = (3, 2) mm' "'die_wall'"
mesh bare=1
bad 'belong to no tool: 1' '(r, z) = (6, 3) mm' "'die_wall'"
mesh binary=1
bad 'binary' 'gmsh -bin 0'
solid_mesh 5 1 2 3 4 5 6 7 8
bad 'die_wall goes through' 'cylinder' 'rectangle'
;;

files)
mesh
head -c 500 bad.msh > cut.msh
mv cut.msh bad.msh
bad 'no quadrilaterals'
: > bad.msh
bad '$MeshFormat is missing'
refused 'no.msh' 'there is no file' -- --set 'Die/Mesh file = no.msh'
refused 'Mesh file = .' 'there is no file' -- --set 'Die/Mesh file = .'
mesh
refused 'Die/Shape = file' 'which is ring' -- --set 'Die/Shape = ring'
# Punches cross: the powder of the mesh is 6 mm high.
expect 2 'Schedule/Stages' 'stage 1' '0.007' '0.006 m high' 'expected less' -- \
  "$tamp" die die.prm -o results \
  --set 'Schedule/Stages = press to displacement 7 mm'

;;

geometry)
printf 'DefineConstant[ R = {6e-3, Name "radius"}, nr = 4 ];\nPoint(1) = {;\n' \
  > bad.geo
geometry=(--set 'Die/Mesh file = bad.geo')
refused 'bad.geo' "'Rr'" 'R, nr' -- \
  "${geometry[@]}" --set 'Die/Mesh parameters = Rr = 5e-3'
refused 'bad.geo' "'R 5'" 'name = number' -- \
  "${geometry[@]}" --set 'Die/Mesh parameters = R 5'
if command -v gmsh > /dev/null; then
  refused 'bad.geo' 'gmsh cannot mesh' 'line 2' -- "${geometry[@]}"
fi
;;
*) fail "no part $2" ;;
esac
[ ! -e results ] || fail "results were written"

echo "$failures failures"
[ "$failures" -eq 0 ]
