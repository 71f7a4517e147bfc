// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_plastic_path_h
#define fem_laws_plastic_path_h

#include <fem/laws/bracketed_root.h>
#include <fem/laws/two_stage_part.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tamp::fem
{
/// Takes a point of an isotropic elastic-plastic law with one hardening
/// variable and associated flow along a straight strain.
///
/// The elastic way to the surface is exact: the law integrates its elasticity,
/// and the crossing is a bracketed root. From there parts are taken as
/// take_part() says. A part is accepted if its estimated error is at most
/// `tolerance`; it is halved otherwise and lengthened again when the error
/// allows. Fails, and leaves the point undefined, when a part falls below 2^-20
/// of the way or more than 20000 are needed.
///
/// A Law has, besides what take_part() asks of it, elastic(point, strain,
/// share), the exact elastic way along a share of a strain, and moduli(point),
/// K and G.
template <class Law, class Number>
class PlasticPath
{
public:
  using Point = PlasticPoint<Number>;

  PlasticPath(const Law &law,
              const Components<Number> &strain,
              const double tolerance)
      : law_(law), strain_(strain), shape_(deviator_of(strain)),
        tolerance_(tolerance)
  {
  }

  /// Takes a point to the end of the strain.
  [[nodiscard]] bool advance(Point &point) const
  {
    if (is_at_rest()) {
      point = law_.elastic(point, strain_, Number(1.));
      return true;
    }
    Number span = 1.; // what is left of the strain since the last crossing
    double done = 0, step = 1; // shares of the span
    bool flows = false;        // from where it is, with any step
    for (unsigned part = 0; part < most_parts; ++part) {
      if (!flows && !(is_on_surface(point) && leads_out(point))) {
        const Number left = span * (1 - done);
        const Point end = law_.elastic(point, strain_, left);
        if (yield(end) <= 1e-13) {
          point = end;
          return true;
        }
        const Number share = crossing(point, left);
        point = law_.elastic(point, strain_, share);
        span = left - share;
        step = std::min(1., step / (1 - done));
        done = 0;
      }
      flows = true;
      Point end = point;
      const double error =
          take_part(law_, point, strain_, Number(span * step), end);
      if (error <= tolerance_) {
        point = end;
        flows = false;
        done += step;
        if (done >= 1)
          return true;
        if (error < tolerance_ / 8)
          step *= 2;
        step = std::min(step, 1 - done);
      } else {
        step /= 2;
        if (step < smallest_step)
          return false;
      }
    }
    return false;
  }

private:
  static constexpr unsigned most_parts = 20000;
  static constexpr double smallest_step = 0x1p-20;

  /// Nothing moves: the answer and its derivatives are elastic.
  bool is_at_rest() const
  {
    return std::ranges::all_of(
        strain_, [](const Number &e) { return std::abs(value_of(e)) <= 0; });
  }

  double yield(const Point &point) const
  {
    return law_.surface(value_of(point.hardening))
        .yield(value_of(point.p), value_of(equivalent_stress(point.deviator)));
  }

  bool is_on_surface(const Point &point) const { return yield(point) > -1e-9; }

  /// dF / d share of an elastic step [-].
  double slope(const Point &point) const
  {
    const auto surface = law_.surface(value_of(point.hardening));
    const auto moduli = law_.moduli(point);
    const double p = value_of(point.p),
                 q = value_of(equivalent_stress(point.deviator));
    double along = 0; // s : e
    for (unsigned k = 0; k < 6; ++k)
      along +=
          (k < 3 ? 1 : 2) * value_of(point.deviator[k]) * value_of(shape_[k]);
    return surface.by_p(p, q) * moduli.bulk * value_of(compaction_of(strain_)) +
           surface.by_q_over_q(p, q) * 3 * moduli.shear * along;
  }

  bool leads_out(const Point &point) const { return slope(point) >= 0; }

  /// The share of the strain after which an elastic way leaves the surface;
  /// it starts inside or leads inside, and is outside after `left`.
  Number crossing(const Point &point, const Number &left) const
  {
    const double end = value_of(left);
    const auto outside = [&](const double share) {
      return yield(law_.elastic(point, strain_, Number(share)));
    };
    double inside = 0;
    if (is_on_surface(point)) {
      inside = end / 2;
      while (inside > 1e-12 * end && outside(inside) >= 0)
        inside /= 2;
      if (inside <= 1e-12 * end)
        return 0.;
    }
    const auto root = bracketed_root(outside, inside, end);
    if (!root)
      return 0.;
    // A Newton step that carries derivatives.
    const Point there = law_.elastic(point, strain_, Number(*root));
    const Number error = law_.surface(there.hardening)
                             .yield(there.p, equivalent_stress(there.deviator));
    const double rate = slope(there);
    return rate > 0 ? Number(*root - error / rate) : Number(*root);
  }

  const Law &law_;
  const Components<Number> strain_, shape_;
  const double tolerance_;
};
} // namespace tamp::fem

#endif
