// SPDX-License-Identifier: BSD-3-Clause
// Half section of a two-level part: x = r, y = z [m]. The bore is wider above
// the step than below it; the powder flows over its shoulder, which is rounded
// where bore meets ledge (radius f) and, where ledge meets wall, sharp.
// Make a mesh:  gmsh -2 -format msh41 -setnumber f 1e-3 \
//               stepped_axisymmetric.geo -o my_mesh.msh
DefineConstant[
  Rl = {4e-3, Name "radius of the lower bore [m]"},
  Ru = {7e-3, Name "radius of the upper bore [m]"},
  Hl = {4e-3, Name "height of the ledge above the lower punch [m]"},
  Hu = {4e-3, Name "height of the powder above the ledge [m]"},
  f = {1e-3, Name "radius of the shoulder's rounding [m]"},
  nr = {5, Name "elements along the lower bore's radius"},
  nl = {4, Name "elements along the lower bore"},
  ns = {3, Name "elements across the ledge, without the rounding"},
  nf = {2, Name "elements along half of the rounding"},
  nu = {5, Name "elements along the upper bore"}
];
// The middle of the rounding.
x = Rl + f * (1 - Sqrt(0.5));
y = Hl - f * (1 - Sqrt(0.5));
Point(1) = {0, 0, 0};
Point(2) = {Rl, 0, 0};
Point(3) = {0, Hl - f, 0};
Point(4) = {Rl, Hl - f, 0};
Point(5) = {0, Hl, 0};
Point(6) = {x, y, 0};
Point(7) = {Rl + f, Hl, 0};
Point(8) = {Ru, Hl, 0};
Point(9) = {0, Hl + Hu, 0};
Point(10) = {x, Hl + Hu, 0};
Point(11) = {Rl + f, Hl + Hu, 0};
Point(12) = {Ru, Hl + Hu, 0};
Point(13) = {Rl + f, Hl - f, 0};
Line(1) = {1, 2};
Line(2) = {2, 4};
Line(3) = {3, 4};
Line(4) = {1, 3};
Circle(5) = {4, 13, 6};
Line(6) = {5, 6};
Line(7) = {3, 5};
Line(8) = {6, 10};
Line(9) = {9, 10};
Line(10) = {5, 9};
Circle(11) = {6, 13, 7};
Line(12) = {7, 11};
Line(13) = {10, 11};
Line(14) = {7, 8};
Line(15) = {8, 12};
Line(16) = {11, 12};
Curve Loop(1) = {1, 2, -3, -4};
Curve Loop(2) = {3, 5, -6, -7};
Curve Loop(3) = {6, 8, -9, -10};
Curve Loop(4) = {11, 12, -13, -8};
Curve Loop(5) = {14, 15, -16, -12};
For i In {1 : 5}
  Plane Surface(i) = {i};
EndFor
Transfinite Curve {1, 3, 6, 9} = nr + 1;
Transfinite Curve {2, 4} = nl + 1;
Transfinite Curve {5, 7, 11, 13} = nf + 1;
Transfinite Curve {8, 10, 12, 15} = nu + 1;
Transfinite Curve {14, 16} = ns + 1;
Transfinite Surface {1 : 5};
Recombine Surface {1 : 5};
Physical Curve("punch_bottom", 1) = {1};
Physical Curve("die_wall", 2) = {2, 5, 11, 14, 15};
Physical Curve("punch_top", 3) = {9, 13, 16};
Physical Curve("axis", 4) = {4, 7, 10};
Physical Surface("powder", 5) = {1 : 5};
