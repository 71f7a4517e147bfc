// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_bracketed_root_h
#define fem_laws_bracketed_root_h

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tamp::fem
{
/// Root between a and b, where the function changes its sign; none otherwise.
/// @param precision  width of the last bracket over its place [-].
template <class Function>
std::optional<double> bracketed_root(const Function &f,
                                     const double a,
                                     const double b,
                                     const double precision = 1e-15)
{
  const double fa = f(a), fb = f(b);
  if (!std::isfinite(fa) || !std::isfinite(fb) || (fa > 0) == (fb > 0)) {
    if (std::abs(fa) <= 0)
      return a;
    if (std::abs(fb) <= 0)
      return b;
    return {};
  }
  const bool turned = a > b;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      f,
      turned ? b : a,
      turned ? a : b,
      turned ? fb : fa,
      turned ? fa : fb,
      [precision](const double l, const double r) {
        return std::abs(r - l) <= precision * std::abs(l + r) + 1e-300;
      },
      iterations);
  return 0.5 * (bracket.first + bracket.second);
}

/// The first of the places begin + step, begin + 2 step, begin + 4 step, ...
/// where f is not positive; none among the first sixty.
template <class Function>
std::optional<double>
end_of_bracket(const Function &f, const double begin, double step)
{
  for (unsigned i = 0; i < 60; ++i, step *= 2)
    if (f(begin + step) <= 0)
      return begin + step;
  return {};
}
} // namespace tamp::fem

#endif
