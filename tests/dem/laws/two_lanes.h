// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_two_lanes_h
#define tests_dem_laws_two_lanes_h

#include <algorithm>
#include <cmath>
#include <functional>

namespace tamp::dem
{
/// Two lanes and their mask, with no conversion to bool.
struct TwoMask {
  bool lane[2];
};
struct Two {
  double lane[2];
  Two() = default;
  explicit Two(double x) : lane{x, x} {}
  Two(double x, double y) : lane{x, y} {}
};
template <class Operation>
Two each(const Two &a, const Two &b, Operation &&of)
{
  return {of(a.lane[0], b.lane[0]), of(a.lane[1], b.lane[1])};
}
inline Two operator+(const Two &a, const Two &b)
{
  return each(a, b, std::plus<>());
}
inline Two operator-(const Two &a, const Two &b)
{
  return each(a, b, std::minus<>());
}
inline Two operator*(const Two &a, const Two &b)
{
  return each(a, b, std::multiplies<>());
}
inline Two operator/(const Two &a, const Two &b)
{
  return each(a, b, std::divides<>());
}
inline Two max(const Two &a, const Two &b)
{
  return each(a, b, [](double x, double y) { return std::max(x, y); });
}
inline Two min(const Two &a, const Two &b)
{
  return each(a, b, [](double x, double y) { return std::min(x, y); });
}
inline Two sqrt(const Two &a)
{
  return {std::sqrt(a.lane[0]), std::sqrt(a.lane[1])};
}
inline Two arc_cosine(const Two &a)
{
  return {std::acos(a.lane[0]), std::acos(a.lane[1])};
}
inline TwoMask operator>(const Two &a, const Two &b)
{
  return {{a.lane[0] > b.lane[0], a.lane[1] > b.lane[1]}};
}
inline Two select(const TwoMask &mask, const Two &yes, const Two &no)
{
  return {mask.lane[0] ? yes.lane[0] : no.lane[0],
          mask.lane[1] ? yes.lane[1] : no.lane[1]};
}
} // namespace tamp::dem

#endif
