// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_two_stage_part_h
#define fem_laws_two_stage_part_h

#include <fem/laws/stage_return.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace tamp::fem
{
/// The stiffly accurate diagonally implicit Runge-Kutta method of second order
/// with two stages, and the method of first order embedded in it. Source: P.
/// Ellsiepen, S. Hartmann, Int. J. Numer. Meth. Eng. 51 (2001) 679.
struct TwoStageMethod {
  /// Share of a part that each stage takes.
  static constexpr double share = 1 - std::numbers::sqrt2 / 2;
  /// The second stage starts from start + base (middle - start), where middle
  /// is the end of the first.
  static constexpr double base = (1 - share) / share;
  /// Weight of the difference of the two stages' rates in the error.
  static constexpr double embedded = share - (2 - 1.25 * std::numbers::sqrt2);
};

/// Estimated error of the stress of a part [Pa].
template <class Number>
double error_of_part(const PlasticPoint<Number> &start,
                     const PlasticPoint<Number> &middle,
                     const PlasticPoint<Number> &end)
{
  using Method = TwoStageMethod;
  const auto difference = // of the rates
      [](const Number &a, const Number &b, const Number &c) {
        return (value_of(c) - value_of(a) -
                (1 + Method::base) * (value_of(b) - value_of(a))) /
               Method::share;
      };
  Components<double> deviator;
  for (unsigned k = 0; k < 6; ++k)
    deviator[k] =
        difference(start.deviator[k], middle.deviator[k], end.deviator[k]);
  return Method::embedded * std::hypot(difference(start.p, middle.p, end.p),
                                       equivalent_stress(deviator));
}

/// Takes a point along a share of a strain by one plastic part; gives its
/// estimated error over the law's size of stress [-], infinite if a stage has
/// no solution.
///
/// A Law has, for Number double and with derivatives: surface(hardening);
/// place(stage, u), the end of a stage, falling in p; start_stage(start,
/// middle, stage), which sets p and hardening where a stage starts, the first
/// one if middle is null, and says whether that is possible; size(surface), the
/// stress that errors are compared with [Pa].
template <class Law, class Number>
double take_part(const Law &law,
                 const PlasticPoint<Number> &start,
                 const Components<Number> &strain,
                 const Number &share,
                 PlasticPoint<Number> &end)
{
  using Method = TwoStageMethod;
  constexpr double impossible = std::numeric_limits<double>::infinity();
  const PlasticPoint<Number> *const nothing = nullptr;
  const auto shape = deviator_of(strain);
  Stage<Number> stage;
  stage.strain = Method::share * share * compaction_of(strain);
  for (unsigned k = 0; k < 6; ++k)
    stage.shape[k] = Method::share * share * shape[k];
  stage.deviator = start.deviator;
  stage.compaction = start.compaction + stage.strain;
  if (!law.start_stage(start, nothing, stage))
    return impossible;
  const auto middle = finish_stage(law, stage);
  if (!middle)
    return impossible;

  for (unsigned k = 0; k < 6; ++k)
    stage.deviator[k] =
        start.deviator[k] +
        Method::base * (middle->deviator[k] - start.deviator[k]);
  stage.compaction = start.compaction + stage.strain / Method::share;
  if (!law.start_stage(start, &*middle, stage))
    return impossible;
  const auto last = finish_stage(law, stage);
  if (!last)
    return impossible;
  end = *last;
  end.plastic_compaction +=
      start.plastic_compaction + Method::base * middle->plastic_compaction;
  end.plastic_shear +=
      start.plastic_shear + Method::base * middle->plastic_shear;
  const double error = error_of_part(start, *middle, end) /
                       law.size(law.surface(value_of(end.hardening)));
  return std::isfinite(error) ? error : impossible;
}
} // namespace tamp::fem

#endif
