// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_helpful_length_h
#define fem_helpful_length_h

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace tamp::fem
{
/// Looks for how much of a step helps: the last share that `pull` is asked for;
/// all of the step if it is not asked. The unbalanced forces, times the step,
/// fall along it and would be negative beyond the place where the energy is
/// least; it ends where little is left of them. The norm of the forces is no
/// guide: contact is so much stiffer than powder.
/// @param pull  unbalanced forces times the step, at a share of it [J]
template <class Pull>
void find_helpful_length(const Pull &pull, double at_begin, double at_end)
{
  constexpr double little = 0.1, narrow = 1e-6;
  if (!(at_begin > 0) || at_end >= -little * at_begin)
    return;
  double left = at_end;
  std::uintmax_t evaluations = 30;
  boost::math::tools::toms748_solve(
      [&](double share) { return left = pull(share); },
      0.,
      1.,
      at_begin,
      at_end,
      [&](double low, double high) {
        return std::abs(left) <= little * at_begin || high - low <= narrow;
      },
      evaluations);
}
} // namespace tamp::fem

#endif
