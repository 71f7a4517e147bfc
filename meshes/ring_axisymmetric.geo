// SPDX-License-Identifier: BSD-3-Clause
// Half section of a ring around a core rod: x = r, y = z [m].
// Make a mesh:  gmsh -2 -format msh41 -setnumber Rc 3e-3 \
//               ring_axisymmetric.geo -o my_mesh.msh
DefineConstant[
  R = {6e-3, Name "radius of the bore [m]"},
  Rc = {2e-3, Name "radius of the core rod [m]"},
  H = {7e-3, Name "fill height [m]"},
  nr = {4, Name "elements along the radius"},
  nz = {7, Name "elements along the axis"}
];
Point(1) = {Rc, 0, 0};
Point(2) = {R, 0, 0};
Point(3) = {R, H, 0};
Point(4) = {Rc, H, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
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
Physical Curve("core", 4) = {4};
Physical Surface("powder", 5) = {1};
