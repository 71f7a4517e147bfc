// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_implicit_stage_h
#define fem_laws_implicit_stage_h

#include <fem/laws/plastic_point.h>

#include <array>
#include <cmath>

namespace tamp::fem
{
/// Where one implicit stage of the integration starts, and the strain on its
/// way.
template <class Number>
struct Stage {
  Components<Number> deviator; ///< s [Pa]
  Components<Number> shape;    ///< deviatoric strain of the stage [-]
  Number p;          ///< in the sense of the law's place(), see there [Pa]
  Number hardening;  ///< [-]
  Number strain;     ///< compaction of the stage [-]
  Number compaction; ///< at the end of the stage, since the increment began [-]
};

/// What a law says of the end of a stage, once the change of its hardening
/// variable is given.
template <class Number>
struct StagePlace {
  Number p;          ///< [Pa]
  Number shear;      ///< G [Pa]
  Number compaction; ///< plastic, in the stage [-]
};

/// The solution of a stage.
struct StageSolution {
  double hardening_change = 0, q = 0;
  /// Of the residuals by (u, q) at the solution.
  std::array<std::array<double, 2>, 2> inverse_jacobian{};
  bool plastic = false, converged = false;
};

/// s + 2 G e: the deviator without plastic flow in the stage.
template <class Number>
Components<Number> trial_deviator(const Stage<Number> &stage,
                                  const StagePlace<Number> &place)
{
  Components<Number> deviator;
  for (unsigned k = 0; k < 6; ++k)
    deviator[k] = stage.deviator[k] + 2. * place.shear * stage.shape[k];
  return deviator;
}

/// The two equations of a stage in the change u of the hardening variable and
/// in q, both dimensionless and zero at the solution:
///   F(p, q) = 0,
///   (q_trial - q) dF/dp - 3 G eps_v dF/dq = 0,
/// where p, G, eps_v (plastic compaction) and the surface follow from u. The
/// second is the associated flow rule without its multiplier, and regular
/// wherever the surface is smooth.
template <class Law, class Number>
std::array<Number, 2> stage_residual(const Law &law,
                                     const Stage<Number> &stage,
                                     const Number &u,
                                     const Number &q)
{
  const auto surface = law.surface(Number(stage.hardening + u));
  const auto place = law.place(stage, u);
  const Number trial = equivalent_stress(trial_deviator(stage, place));
  return {surface.yield(place.p, q),
          Number((trial - q) * surface.by_p(place.p, q) -
                 3. * place.shear * place.compaction * q *
                     surface.by_q_over_q(place.p, q))};
}

/// The values of a stage.
template <class Number>
Stage<double> values_of(const Stage<Number> &stage)
{
  Stage<double> result;
  for (unsigned k = 0; k < 6; ++k) {
    result.deviator[k] = value_of(stage.deviator[k]);
    result.shape[k] = value_of(stage.shape[k]);
  }
  result.p = value_of(stage.p);
  result.hardening = value_of(stage.hardening);
  result.strain = value_of(stage.strain);
  result.compaction = value_of(stage.compaction);
  return result;
}

} // namespace tamp::fem

#endif
