// SPDX-License-Identifier: BSD-3-Clause
// Quarter of a cylindrical compact, x >= 0, y >= 0, z is the pressing axis [m]:
// a block around the axis within two blocks along the wall.
// Make a mesh:  gmsh -3 -format msh41 -setnumber nb 4 -setnumber nz 8 \
//               cylinder_quarter.geo -o my_mesh.msh
DefineConstant[
  R = {6e-3, Name "radius [m]"},
  H = {7e-3, Name "fill height [m]"},
  nb = {3, Name "elements along a side of the inner block"},
  nw = {2, Name "elements between the inner block and the wall"},
  nz = {4, Name "elements along the axis"}
];
c = R * Sqrt(0.5);
a = 0.55 * R;  // side of the inner block along x and y
d = 0.46 * R;  // its corner: 120 degrees between the three blocks
Point(1) = {0, 0, 0};
Point(2) = {a, 0, 0};
Point(3) = {d, d, 0};
Point(4) = {0, a, 0};
Point(5) = {R, 0, 0};
Point(6) = {c, c, 0};
Point(7) = {0, R, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {2, 5};
Circle(6) = {5, 1, 6};
Line(7) = {6, 3};
Circle(8) = {6, 1, 7};
Line(9) = {7, 4};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, -2};
Curve Loop(3) = {-7, 8, 9, -3};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Transfinite Curve {1, 2, 3, 4, 6, 8} = nb + 1;
Transfinite Curve {5, 7, 9} = nw + 1;
Transfinite Surface {1, 2, 3};
Recombine Surface {1, 2, 3};
// Every list: the top, the volume, then the sides in the order of the loop.
b1[] = Extrude {0, 0, H} { Surface{1}; Layers{nz}; Recombine; };
b2[] = Extrude {0, 0, H} { Surface{2}; Layers{nz}; Recombine; };
b3[] = Extrude {0, 0, H} { Surface{3}; Layers{nz}; Recombine; };
Physical Surface("punch_bottom", 1) = {1, 2, 3};
Physical Surface("punch_top", 2) = {b1[0], b2[0], b3[0]};
Physical Surface("die_wall", 3) = {b2[3], b3[3]};
Physical Surface("symmetry_x", 4) = {b1[5], b3[4]};
Physical Surface("symmetry_y", 5) = {b1[2], b2[2]};
Physical Volume("powder", 6) = {b1[1], b2[1], b3[1]};
