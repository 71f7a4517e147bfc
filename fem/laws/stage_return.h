// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_stage_return_h
#define fem_laws_stage_return_h

#include <fem/laws/bracketed_root.h>
#include <fem/laws/implicit_stage.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tamp::fem
{
/// Solves a stage. The law's surface is convex with one place, its centre,
/// where dF/dp = 0; p falls and the surface grows as u rises. A trial beyond
/// the centre therefore has its root between u = 0 (or the u that brings the
/// trial onto the q = 0 axis) and the u that brings p to the centre: it is
/// bracketed there, then polished by Newton steps.
template <class Law>
class StageReturn
{
public:
  StageReturn(const Law &law, const Stage<double> &stage)
      : law_(law), stage_(stage)
  {
  }

  StageSolution solve() const
  {
    const auto trial = law_.place(stage_, 0.);
    const auto surface = law_.surface(stage_.hardening);
    const double yield = surface.yield(trial.p, trial_q(0));
    if (yield <= 1e-13)
      return {0, 0, {}, false, true};
    if (std::isnan(yield))
      return {};
    const double side = trial.p >= surface.centre() ? 1 : -1;
    for (const double precision : {1e-3, 1e-15}) {
      const auto u = bracket(side, precision);
      if (!u)
        return {};
      const auto solution = polish(*u);
      if (solution.converged)
        return solution;
    }
    return {};
  }

private:
  /// Beyond the surface's largest (side 1) or smallest pressure (side -1):
  /// positive.
  double beyond(const double side, const double u) const
  {
    const auto surface = law_.surface(stage_.hardening + u);
    const double p = law_.place(stage_, u).p;
    return side > 0 ? p - surface.largest_pressure()
                    : surface.smallest_pressure() - p;
  }

  /// The flow rule on the surface: positive at the beginning of the bracket,
  /// negative at the centre and after it.
  double flow(const double side, const double u) const
  {
    const auto surface = law_.surface(stage_.hardening + u);
    const auto place = law_.place(stage_, u);
    if (!(side * (place.p - surface.centre()) > 0))
      return -1;
    const double q = surface.shear_limit(place.p);
    return side * ((trial_q(u) - q) * surface.by_p(place.p, q) -
                   3 * place.shear * place.compaction * q *
                       surface.by_q_over_q(place.p, q));
  }

  std::optional<double> bracket(const double side, const double precision) const
  {
    double begin = 0;
    const double step = side * 1e-3;
    const auto outside = [&](const double u) { return beyond(side, u); };
    if (beyond(side, 0) > 0) {
      const auto end = end_of_bracket(outside, 0, step);
      const auto axis = end ? bracketed_root(outside, 0, *end) : end;
      if (!axis)
        return {};
      begin = *axis;
    }
    const auto rule = [&](const double u) { return flow(side, u); };
    if (!(rule(begin) > 0))
      return begin; // on the axis or at the centre
    const auto end = end_of_bracket(rule, begin, step);
    return end ? bracketed_root(rule, begin, *end, precision) : end;
  }

  /// Newton steps from a good start; keeps the best.
  StageSolution polish(const double u_start) const
  {
    using Derivative2 = Sacado::Fad::SFad<double, 2>;
    Stage<Derivative2> stage;
    for (unsigned k = 0; k < 6; ++k) {
      stage.deviator[k] = stage_.deviator[k];
      stage.shape[k] = stage_.shape[k];
    }
    stage.p = stage_.p;
    stage.hardening = stage_.hardening;
    stage.strain = stage_.strain;
    stage.compaction = stage_.compaction;
    double u = u_start;
    double q =
        law_.surface(stage_.hardening + u).shear_limit(law_.place(stage_, u).p);
    StageSolution best;
    double best_error = 1e300;
    for (unsigned iteration = 0; iteration < 16; ++iteration) {
      const auto e = stage_residual(
          law_, stage, Derivative2(2, 0, u), Derivative2(2, 1, q));
      const double a = e[0].dx(0), b = e[0].dx(1), c = e[1].dx(0),
                   d = e[1].dx(1), determinant = a * d - b * c;
      const double error = std::max(std::abs(e[0].val()), std::abs(e[1].val()));
      if (!(error < best_error) || !(std::abs(determinant) > 0))
        break;
      best_error = error;
      best = {u,
              q,
              {{{d / determinant, -b / determinant},
                {-c / determinant, a / determinant}}},
              true,
              error < 1e-11};
      const auto &inverse = best.inverse_jacobian;
      u -= inverse[0][0] * e[0].val() + inverse[0][1] * e[1].val();
      q -= inverse[1][0] * e[0].val() + inverse[1][1] * e[1].val();
      if (error < 1e-15)
        break;
    }
    return best;
  }

  double trial_q(const double u) const
  {
    return equivalent_stress(trial_deviator(stage_, law_.place(stage_, u)));
  }

  const Law &law_;
  const Stage<double> &stage_;
};

/// Solves a stage and says where it ends; plastic strains are those of the
/// stage alone. None if it has no solution. Derivatives follow from the
/// implicit function theorem: one more Newton step, with numbers that carry
/// them.
template <class Law, class Number>
std::optional<PlasticPoint<Number>> finish_stage(const Law &law,
                                                 const Stage<Number> &stage)
{
  const auto values = values_of(stage);
  const StageSolution found = StageReturn<Law>(law, values).solve();
  if (!found.converged)
    return {};
  Number u = found.hardening_change, q = found.q, ratio = 1.;
  if (found.plastic) {
    const auto error = stage_residual(law, stage, u, q);
    const auto &inverse = found.inverse_jacobian;
    u -= inverse[0][0] * error[0] + inverse[0][1] * error[1];
    q -= inverse[1][0] * error[0] + inverse[1][1] * error[1];
  }
  const auto place = law.place(stage, u);
  PlasticPoint<Number> end;
  end.deviator = trial_deviator(stage, place);
  end.p = place.p;
  end.hardening = stage.hardening + u;
  end.compaction = stage.compaction;
  end.yielding = found.plastic;
  if (!found.plastic)
    return end;
  const Number trial = equivalent_stress(end.deviator);
  const auto surface = law.surface(end.hardening);
  const Number bend = surface.by_q_over_q(place.p, q);
  if (found.q * found.q * value_of(bend) > 1e-6) {
    ratio = q / trial;
  } else { // close to q = 0: from the flow rule, which is regular there
    const Number slope = surface.by_p(place.p, q);
    ratio = slope / (slope + 3. * place.shear * place.compaction * bend);
  }
  for (Number &s : end.deviator)
    s *= ratio;
  end.plastic_compaction = value_of(place.compaction);
  end.plastic_shear = (value_of(trial) - found.q) / (3 * value_of(place.shear));
  return end;
}
} // namespace tamp::fem

#endif
