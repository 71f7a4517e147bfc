// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/laws/rate_integration.h>

#include <cmath>

namespace tamp::fem
{
namespace
{
using Three = RateIntegration::Three;

/// A tenth of what a small step changes.
constexpr double on_surface = 1e-7;

struct Invariants {
  explicit Invariants(const Three &stress)
      : p((stress[0] + stress[1] + stress[2]) / 3)
  {
    for (unsigned i = 0; i < 3; ++i)
      deviator[i] = stress[i] - p;
    q = std::sqrt(1.5 * (deviator[0] * deviator[0] + deviator[1] * deviator[1] +
                         deviator[2] * deviator[2]));
  }
  double p, q = 0;
  Three deviator{};
};

Three times(Three strain, const double factor)
{
  for (double &entry : strain)
    entry *= factor;
  return strain;
}
} // namespace

RateIntegration::RateIntegration(const DruckerPragerCapParameters &parameters)
    : law_(parameters)
{
  now_.compaction = law_.initial_state().plastic_compaction;
}

RateIntegration::Point RateIntegration::sum(const Point &point,
                                            const Point &change,
                                            const double share)
{
  Point result{point.stress, point.compaction + share * change.compaction};
  for (unsigned i = 0; i < 3; ++i)
    result.stress[i] += share * change.stress[i];
  return result;
}

double RateIntegration::yield(const Point &point) const
{
  const auto surface = law_.surface(point.compaction);
  const Invariants now(point.stress);
  return surface.yield(now.p, now.q) / (surface.radius() + surface.strength);
}

// Consistency: f_p dp + f_q dq + f_eps deps = 0 with dp = K (v - L c), dq = 3 G
// (s : e / q - L b) and deps = L c, where (c, b) is the flow.
RateIntegration::Rate RateIntegration::rate(const Point &point,
                                            const Three &strain,
                                            const bool plastic) const
{
  const auto &parameters = law_.parameters();
  const auto moduli = parameters.elasticity.at(parameters.reference_density *
                                               std::exp(point.compaction));
  const double volume = strain[0] + strain[1] + strain[2];
  const Invariants now(point.stress);
  double along = 0; // s : e / q
  for (unsigned i = 0; i < 3 && now.q > 0; ++i)
    along += now.deviator[i] * strain[i] / now.q;

  Rate result;
  double compaction = 0, shear = 0;
  if (plastic) {
    const auto surface = law_.surface(point.compaction);
    const double dp = 1e-6 * surface.radius(), de = 1e-7;
    const double by_p =
        (surface.yield(now.p + dp, now.q) - surface.yield(now.p - dp, now.q)) /
        (2 * dp);
    const double by_q =
        (surface.yield(now.p, now.q + dp) - surface.yield(now.p, now.q - dp)) /
        (2 * dp);
    const double hardening =
        (law_.surface(point.compaction + de).yield(now.p, now.q) -
         law_.surface(point.compaction - de).yield(now.p, now.q)) /
        (2 * de);
    const auto flow = surface.flow(now.p, now.q);
    const double drive =
        by_p * moduli.bulk * volume + by_q * 3 * moduli.shear * along;
    const double amount = drive / (by_p * moduli.bulk * flow.compaction +
                                   by_q * 3 * moduli.shear * flow.shear -
                                   hardening * flow.compaction);
    compaction = amount * flow.compaction;
    shear = amount * flow.shear;
    result.loading = drive > 0;
  }
  result.change.compaction = compaction;
  for (unsigned i = 0; i < 3; ++i) {
    const double turned = now.q > 0 ? 1.5 * shear * now.deviator[i] / now.q : 0;
    result.change.stress[i] =
        moduli.bulk * (volume - compaction) +
        2 * moduli.shear * (strain[i] - volume / 3 - turned);
  }
  return result;
}

RateIntegration::Point RateIntegration::step(const Point &point,
                                             const Three &strain,
                                             const bool plastic) const
{
  const Point a = rate(point, strain, plastic).change;
  const Point b = rate(sum(point, a, 0.5), strain, plastic).change;
  const Point c = rate(sum(point, b, 0.5), strain, plastic).change;
  const Point d = rate(sum(point, c, 1), strain, plastic).change;
  return sum(sum(sum(sum(point, a, 1. / 6), b, 1. / 3), c, 1. / 3), d, 1. / 6);
}

double RateIntegration::elastic_share(Point &point, const Three &strain) const
{
  const Point end = step(point, strain, false);
  if (yield(end) <= 0) {
    point = end;
    return 1;
  }
  double inside = 0, outside = 1;
  for (unsigned i = 0; i < 50; ++i) {
    const double middle = 0.5 * (inside + outside);
    (yield(step(point, times(strain, middle), false)) > 0 ? outside : inside) =
        middle;
  }
  point = step(point, times(strain, inside), false);
  return inside;
}

void RateIntegration::press(const Three &strain, const double step_size)
{
  const double size =
      std::abs(strain[0]) + std::abs(strain[1]) + std::abs(strain[2]);
  const double count = std::ceil(size / step_size);
  const Three part = times(strain, 1 / count);
  for (double i = 0; i < count; ++i) {
    double left = 1;
    if (yield(now_) < -on_surface)
      left -= elastic_share(now_, part);
    if (left > 0) {
      const Three rest = times(part, left);
      now_ = step(now_, rest, rate(now_, rest, true).loading);
    }
  }
}
} // namespace tamp::fem
