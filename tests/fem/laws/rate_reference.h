// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_laws_rate_reference_h
#define tests_fem_laws_rate_reference_h

#include <fem/laws/continuum_points.h>

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

/// The rate equations of an isotropic law with one hardening variable and
/// associated flow, integrated explicitly in thousands of steps: nothing is
/// shared with the laws but the meaning of their symbols.
namespace tamp::fem
{
using Stress = dealii::SymmetricTensor<2, 3>;

/// A leg of a path: a constant rate of deformation without spin, that is the
/// logarithmic strain of the leg, and how many increments the law takes it in.
struct Leg {
  Stress strain; ///< tension positive [-]
  unsigned increments = 1;
};

inline Leg leg(const std::array<double, 6> &strain, const unsigned increments)
{
  Leg result;
  for (unsigned k = 0; k < 6; ++k) // xx, yy, zz, xy, xz, yz
    result.strain.access_raw_entry(k) = strain[k];
  result.increments = increments;
  return result;
}

/// What a law says at a state; p and q compression positive.
struct RateCoefficients {
  double bulk, shear;              ///< K, G [Pa]
  double yield;                    ///< F
  double by_p, by_q, by_hardening; ///< of F
  double hardening_rate;           ///< d hardening / d eps_v^pl
};

struct ReferenceState {
  Stress stress;
  double density = 0, hardening = 0;
};

/// @param Law  RateCoefficients operator()(p, q, density, hardening).
template <class Law>
class RateReference
{
public:
  explicit RateReference(Law law) : law_(std::move(law)) {}

  /// Runge-Kutta steps of fourth order; a step that leaves the surface from
  /// inside is first taken to the surface.
  void drive(ReferenceState &state, const Leg &leg, const unsigned steps) const
  {
    for (unsigned i = 0; i < steps; ++i) {
      double left = 1. / steps;
      if (coefficients(state).yield < 0) {
        double low = 0, high = left;
        if (coefficients(stepped(state, leg.strain, left, false)).yield <= 0)
          low = left;
        for (unsigned k = 0; k < 30 && low < left; ++k) {
          const double middle = (low + high) / 2;
          (coefficients(stepped(state, leg.strain, middle, false)).yield < 0
               ? low
               : high) = middle;
        }
        state = stepped(state, leg.strain, low, false);
        left -= low;
      }
      if (left > 0)
        state = stepped(state, leg.strain, left, loads(state, leg.strain));
    }
  }

private:
  RateCoefficients coefficients(const ReferenceState &state) const
  {
    return law_(-trace(state.stress) / 3,
                std::sqrt(1.5) * deviator(state.stress).norm(),
                state.density,
                state.hardening);
  }

  Stress normal(const ReferenceState &state, const RateCoefficients &c) const
  {
    const Stress s = deviator(state.stress);
    const double q = std::sqrt(1.5) * s.norm();
    return c.by_q * (q > 0 ? 1.5 / q : 0) * s -
           c.by_p / 3 * dealii::unit_symmetric_tensor<3>();
  }

  static Stress elastic(const RateCoefficients &c, const Stress &strain)
  {
    return c.bulk * trace(strain) * dealii::unit_symmetric_tensor<3>() +
           2 * c.shear * deviator(strain);
  }

  bool loads(const ReferenceState &state, const Stress &strain) const
  {
    const auto c = coefficients(state);
    return normal(state, c) * elastic(c, strain) > 0;
  }

  ReferenceState rate(const ReferenceState &state,
                      const Stress &strain,
                      const bool plastic) const
  {
    const auto c = coefficients(state);
    ReferenceState result;
    double compaction = 0;
    Stress flow;
    if (plastic) {
      const Stress n = normal(state, c);
      const double multiplier =
          (n * elastic(c, strain)) /
          (n * elastic(c, n) - c.by_hardening * c.hardening_rate * c.by_p);
      flow = multiplier * n;
      compaction = multiplier * c.by_p;
    }
    result.stress = elastic(c, strain - flow);
    result.density = -state.density * trace(strain);
    result.hardening = c.hardening_rate * compaction;
    return result;
  }

  static ReferenceState
  along(const ReferenceState &a, const ReferenceState &rate, const double t)
  {
    return {a.stress + t * rate.stress,
            a.density + t * rate.density,
            a.hardening + t * rate.hardening};
  }

  ReferenceState stepped(const ReferenceState &start,
                         const Stress &strain,
                         const double t,
                         const bool plastic) const
  {
    const auto a = rate(start, strain, plastic);
    const auto b = rate(along(start, a, t / 2), strain, plastic);
    const auto c = rate(along(start, b, t / 2), strain, plastic);
    const auto d = rate(along(start, c, t), strain, plastic);
    return along(
        along(along(along(start, a, t / 6), b, t / 3), c, t / 3), d, t / 6);
  }

  Law law_;
};

/// exp(strain) as a relative F.
inline dealii::Tensor<2, 3> exponential(const Stress &strain)
{
  const auto eigen = dealii::eigenvectors(
      strain, dealii::SymmetricTensorEigenvectorMethod::jacobi);
  dealii::Tensor<2, 3> F;
  for (const auto &[value, axis] : eigen)
    F += std::exp(value) * outer_product(axis, axis);
  return F;
}

/// Takes all points along a leg; false if one fails.
[[nodiscard]] inline bool follow(MaterialPoints &points, const Leg &leg)
{
  const std::vector<Deformation> step(
      points.size(), {exponential(leg.strain / leg.increments)});
  std::vector<Response> answer(points.size());
  for (unsigned i = 0; i < leg.increments; ++i) {
    points.evaluate(step, Want::stress, answer);
    if (answer[0].status == Status::failed)
      return false;
    points.commit();
  }
  return true;
}

/// Takes point 0 and the reference along legs; the largest difference of
/// stress at the ends of legs, over the stress there.
template <class Law, class Rates>
double worst_difference(ContinuumPoints<Law> &points,
                        const RateReference<Rates> &reference,
                        ReferenceState state,
                        const std::vector<Leg> &legs)
{
  double worst = 0;
  for (const Leg &leg : legs) {
    EXPECT_TRUE(follow(points, leg));
    reference.drive(state, leg, 20000);
    worst = std::max(worst,
                     (points.state(0).stress - state.stress).norm() /
                         state.stress.norm());
  }
  return worst;
}

/// A mixed problem: from where the points are, axial strain `axial` is
/// prescribed and the lateral strain sought that keeps the lateral stress.
/// Solved by Newton's method with the tangent; the residuals [Pa] down to
/// rounding, from the first one on.
inline std::vector<double> newton_residuals(MaterialPoints &points,
                                            const double axial,
                                            const double lateral_stress)
{
  std::vector<double> residuals;
  std::vector<Response> answer(points.size());
  double lateral = 0;
  for (unsigned iteration = 0; iteration < 12; ++iteration) {
    const auto trial = leg({lateral, lateral, axial, 0, 0, 0}, 1);
    points.evaluate(
        std::vector<Deformation>(points.size(), {exponential(trial.strain)}),
        Want::stress_and_tangent,
        answer);
    const double residual = answer[0].stress[0][0] - lateral_stress;
    residuals.push_back(std::abs(residual));
    if (std::abs(residual) < 1e-11 * std::abs(lateral_stress))
      break;
    lateral -= residual /
               (answer[0].tangent[0][0][0][0] + answer[0].tangent[0][0][1][1]);
  }
  return residuals;
}

/// Order of convergence from the last three residuals above rounding.
inline double newton_order(const std::vector<double> &residuals,
                           const double rounding)
{
  std::vector<double> good;
  for (const double residual : residuals)
    if (residual > rounding)
      good.push_back(std::log(residual));
  if (good.size() < 3)
    return 0;
  const auto last = good.end();
  return (last[-1] - last[-2]) / (last[-2] - last[-3]);
}
} // namespace tamp::fem

#endif
