// SPDX-License-Identifier: BSD-3-Clause
#include <fem/element.h>

#include <cmath>

namespace tamp::fem
{
namespace
{
ShapeValues shape_values(const std::array<double, 3> &place,
                         bool is_quadrilateral)
{
  ShapeValues result;
  const unsigned directions = is_quadrilateral ? 2 : 3;
  for (unsigned a = 0; a < 1u << directions; ++a) {
    std::array<double, 3> factor{1, 1, 1}, slope{0, 0, 0};
    for (unsigned d = 0; d < directions; ++d) {
      const bool upper = (a >> d & 1) != 0;
      factor[d] = upper ? place[d] : 1 - place[d];
      slope[d] = upper ? 1 : -1;
    }
    result.value[a] = factor[0] * factor[1] * factor[2];
    for (unsigned d = 0; d < directions; ++d) {
      double gradient = slope[d];
      for (unsigned e = 0; e < directions; ++e)
        if (e != d)
          gradient *= factor[e];
      result.gradient[a][is_quadrilateral ? 2 * d : d] = gradient;
    }
  }
  return result;
}
} // namespace

Element::Element(bool is_quadrilateral)
{
  const double gauss[2] = {0.5 - std::sqrt(1. / 12), 0.5 + std::sqrt(1. / 12)};
  const unsigned number = is_quadrilateral ? 4 : 8;
  for (unsigned q = 0; q < number; ++q) {
    points[q] = shape_values(
        {gauss[q & 1], gauss[q >> 1 & 1], gauss[q >> 2 & 1]}, is_quadrilateral);
    points[q].weight = 1. / number;
  }
  centre = shape_values({0.5, 0.5, 0.5}, is_quadrilateral);
  centre.weight = 1;
}
} // namespace tamp::fem
