// SPDX-License-Identifier: BSD-3-Clause
// Quarter of a square compact with rounded vertical edges, x >= 0, y >= 0, z is
// the pressing axis [m]: a square block, two flat ones along the walls as wide
// as the rounding, and a quarter of a butterfly in the corner.
// Make a mesh:  gmsh -3 -format msh41 -setnumber c 2e-3 -setnumber nc 2 \
//               square_die_quarter.geo -o my_mesh.msh
DefineConstant[
  W = {12e-3, Name "side of the square, wall to wall [m]"},
  c = {2e-3, Name "radius of the vertical edges [m]"},
  H = {7e-3, Name "fill height [m]"},
  ns = {3, Name "elements along the straight part of half a wall"},
  nc = {1, Name "elements of the corner from its square to the walls"},
  nz = {4, Name "elements along the axis"}
];
a = W / 2;
s = a - c;            // where the rounding starts
m = s + 0.5 * c;      // the corner's inner block ends on the grid's lines
d = s + 0.46 * c;     // and with its own corner here
e = s + c * Sqrt(0.5);
Point(1) = {0, 0, 0};
Point(2) = {s, 0, 0};
Point(3) = {m, 0, 0};
Point(4) = {a, 0, 0};
Point(5) = {0, s, 0};
Point(6) = {s, s, 0};
Point(7) = {m, s, 0};
Point(8) = {a, s, 0};
Point(9) = {0, m, 0};
Point(10) = {s, m, 0};
Point(11) = {d, d, 0};
Point(12) = {e, e, 0};
Point(13) = {0, a, 0};
Point(14) = {s, a, 0};
// Along x, then along y, then what makes the corner.
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {9, 10};
Line(8) = {13, 14};
Line(11) = {1, 5};
Line(12) = {2, 6};
Line(13) = {3, 7};
Line(14) = {4, 8};
Line(15) = {5, 9};
Line(16) = {6, 10};
Line(17) = {9, 13};
Line(18) = {10, 14};
Line(21) = {7, 11};
Line(22) = {10, 11};
Line(23) = {11, 12};
Circle(24) = {8, 6, 12};
Circle(25) = {12, 6, 14};
Curve Loop(1) = {1, 12, -4, -11};
Curve Loop(2) = {2, 13, -5, -12};
Curve Loop(3) = {3, 14, -6, -13};
Curve Loop(4) = {4, 16, -7, -15};
Curve Loop(5) = {7, 18, -8, -17};
Curve Loop(6) = {5, 21, -22, -16};
Curve Loop(7) = {6, 24, -23, -21};
Curve Loop(8) = {22, 23, 25, -18};
For i In {1 : 8}
  Plane Surface(i) = {i};
EndFor
Transfinite Curve {1, 4, 7, 8, 11, 12, 13, 14} = ns + 1;
Transfinite Curve {2, 5, 15, 16, 21, 22, 24, 25} = nc + 1;
Transfinite Curve {3, 6, 17, 18, 23} = nc + 1;
Transfinite Surface {1 : 8};
Recombine Surface {1 : 8};
// Every list: the top, the volume, then the sides in the order of the loop.
b1[] = Extrude {0, 0, H} { Surface{1}; Layers{nz}; Recombine; };
b2[] = Extrude {0, 0, H} { Surface{2}; Layers{nz}; Recombine; };
b3[] = Extrude {0, 0, H} { Surface{3}; Layers{nz}; Recombine; };
b4[] = Extrude {0, 0, H} { Surface{4}; Layers{nz}; Recombine; };
b5[] = Extrude {0, 0, H} { Surface{5}; Layers{nz}; Recombine; };
b6[] = Extrude {0, 0, H} { Surface{6}; Layers{nz}; Recombine; };
b7[] = Extrude {0, 0, H} { Surface{7}; Layers{nz}; Recombine; };
b8[] = Extrude {0, 0, H} { Surface{8}; Layers{nz}; Recombine; };
Physical Surface("punch_bottom", 1) = {1 : 8};
Physical Surface("punch_top", 2) =
  {b1[0], b2[0], b3[0], b4[0], b5[0], b6[0], b7[0], b8[0]};
Physical Surface("die_wall", 3) = {b3[3], b5[4], b7[3], b8[4]};
Physical Surface("symmetry_x", 4) = {b1[5], b4[5], b5[5]};
Physical Surface("symmetry_y", 5) = {b1[2], b2[2], b3[2]};
Physical Volume("powder", 6) =
  {b1[1], b2[1], b3[1], b4[1], b5[1], b6[1], b7[1], b8[1]};
