// SPDX-License-Identifier: BSD-3-Clause
// Half section of a tablet between curved punches: x = r, y = z [m]. The faces
// are arcs; `top` and `bottom` are how far they stand out into the powder at
// the axis: negative for cups (domed tablets), positive for domes, not zero.
// Make a mesh:  gmsh -2 -format msh41 -setnumber top -1.5e-3 \
//               tablet_axisymmetric.geo -o my_mesh.msh
DefineConstant[
  R = {6e-3, Name "radius [m]"},
  H = {7e-3, Name "fill height at the wall [m]"},
  top = {-1e-3, Name "height of the upper face at the axis [m]"},
  bottom = {-1e-3, Name "height of the lower face at the axis [m]"},
  nr = {6, Name "elements along the radius"},
  nz = {7, Name "elements along the axis"}
];
Point(1) = {0, bottom, 0};
Point(2) = {R, 0, 0};
Point(3) = {R, H, 0};
Point(4) = {0, H - top, 0};
// Centres of the arcs on the axis.
Point(5) = {0, (bottom * bottom - R * R) / (2 * bottom), 0};
Point(6) = {0, H - (top * top - R * R) / (2 * top), 0};
Circle(1) = {1, 5, 2};
Line(2) = {2, 3};
Circle(3) = {3, 6, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = nr + 1;
Transfinite Curve {2, 4} = nz + 1;
Transfinite Surface {1};
Recombine Surface {1};
Physical Curve("punch_bottom", 1) = {1};
Physical Curve("die_wall", 2) = {2};
Physical Curve("punch_top", 3) = {3};
Physical Curve("axis", 4) = {4};
Physical Surface("powder", 5) = {1};
