// SPDX-License-Identifier: BSD-3-Clause
#include <fem/punch_area.h>

#include <cmath>
#include <numbers>

namespace tamp::fem
{
double punch_area(const Mesh &mesh, Tool punch)
{
  const auto &faces = mesh.tools[punch].faces;
  double area = 0;
  for (std::size_t i = 0; i < faces.size(); i += mesh.nodes_per_face()) {
    const auto corner = [&](unsigned a) { return mesh.nodes[faces[i + a]]; };
    if (mesh.is_axisymmetric())
      area += std::numbers::pi * std::abs(corner(1)[0] * corner(1)[0] -
                                          corner(0)[0] * corner(0)[0]);
    else
      area += 0.5 * std::abs(dealii::cross_product_3d(
                        corner(3) - corner(0), corner(2) - corner(1))[2]);
  }
  return area * mesh.multiplicity();
}
} // namespace tamp::fem
