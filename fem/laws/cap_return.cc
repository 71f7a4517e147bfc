// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/bracketed_root.h>
#include <fem/laws/cap_return.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace tamp::fem
{
namespace
{
using Surface = DruckerPragerCap::Surface;
using Unknowns = std::array<double, 2>;

/// Value and derivative by the two unknowns of a return.
using Derivative2 = Sacado::Fad::SFad<double, 2>;

/// Goes from 0 in steps of growing size, first `step`, until f has the sign of
/// the step reversed, which it has in the end; then finds the root.
template <class Function>
std::optional<double> root_from_zero(const Function &f, double step)
{
  double far = step;
  for (unsigned i = 0; i < 60; ++i, far *= 2)
    if (f(far) * step <= 0)
      return bracketed_root(f, 0, far);
  return {};
}

class Return
{
public:
  Return(CapTables &tables,
         const CapSurface<ByCompaction> &start,
         const CapTrial<double> &trial)
      : tables_(tables), start_(values_of(start)), trial_(trial)
  {
  }

  CapReturn solve()
  {
    const double scale = start_.radius() + start_.top();
    if (start_.yield(trial_.p, trial_.q) <= 1e-13 * scale) {
      CapReturn inside;
      inside.converged = true;
      return inside;
    }
    const bool on_cap = trial_.p > start_.centre;
    const auto found = newton(on_cap, guess(on_cap));
    if (found.converged && is_admissible(on_cap, found))
      return found;
    const auto unknowns = on_cap ? cap() : shear();
    if (!unknowns)
      return {};
    return newton(on_cap, *unknowns);
  }

private:
  CapSurface<double> surface(const double x)
  {
    return values_of(tables_.surface(trial_.compaction + x));
  }
  double p(const double x) const { return trial_.p - trial_.bulk * x; }

  /// The trial state, drawn straight to the surface it left.
  Unknowns guess(const bool on_cap) const
  {
    return {0,
            on_cap ? std::atan2(trial_.q / start_.top(),
                                (trial_.p - start_.centre) / start_.radius())
                   : std::max(0., start_.shear_limit(trial_.p))};
  }

  /// Whether plastic flow goes outwards, on the branch it was sought on.
  bool is_admissible(const bool on_cap, const CapReturn &found) const
  {
    constexpr double slack = 1e-12;
    const double x = found.compaction_change, position = found.position;
    if (on_cap)
      return x >= -slack && position >= -slack &&
             position <= std::numbers::pi / 2 + slack;
    const auto s = values_of(found.at);
    return x <= slack && position >= 0 && position <= trial_.q &&
           p(x) <= s.centre + slack * s.radius();
  }

  std::optional<Unknowns> cap()
  {
    const double stride =
        (trial_.p - surface(0).apex()) / trial_.bulk; // beyond the root
    const auto end = root_from_zero(
        [&](const double x) { return p(x) - surface(x).centre; }, stride);
    if (!end)
      return {};
    double begin = 0;
    if (trial_.p - surface(0).centre > surface(0).radius()) {
      const auto on_axis = bracketed_root(
          [&](const double x) {
            const auto s = surface(x);
            return p(x) - s.centre - s.radius();
          },
          0,
          *end);
      if (!on_axis)
        return {};
      begin = *on_axis;
      if (trial_.q <= 1e-14 * surface(begin).top())
        return Unknowns{begin, 0.};
    }
    const auto height = [&](const double x) { // of the cap at p, over its top
      const auto s = surface(x);
      const double place = (p(x) - s.centre) / s.radius();
      return std::sqrt(std::max(0., 1 - place * place));
    };
    const auto x = bracketed_root(
        [&](const double x) {
          const auto s = surface(x);
          return (trial_.q - s.top() * height(x)) * (p(x) - s.centre) /
                     s.radius() -
                 3 * trial_.shear * x * s.eccentricity / s.factor * height(x);
        },
        begin,
        *end);
    if (!x)
      return Unknowns{begin, 0.}; // a trial that lies on the axis
    const auto s = surface(*x);
    return Unknowns{*x,
                    std::atan2(height(*x), (p(*x) - s.centre) / s.radius())};
  }

  std::optional<Unknowns> shear()
  {
    const auto start = surface(0);
    const double stride =
        (start.centre - trial_.p + start.strength) / trial_.bulk;
    const auto end = root_from_zero(
        [&](const double x) { return p(x) - surface(x).centre; }, -stride);
    if (!end)
      return {};
    double begin = 0;
    if (trial_.p < start.apex()) {
      const auto apex = bracketed_root(
          [&](const double x) { return p(x) - surface(x).apex(); }, 0, *end);
      if (!apex)
        return {};
      begin = *apex;
    }
    const auto limit = [&](const double x) {
      return std::max(0., surface(x).shear_limit(p(x)));
    };
    const auto x = bracketed_root(
        [&](const double x) {
          return return_residual<double>(
              surface(x), trial_, false, {x, limit(x)})[1];
        },
        begin,
        *end);
    if (!x)
      return Unknowns{begin, limit(begin)};
    return Unknowns{*x, limit(*x)};
  }

  /// Newton steps until they are lost in round-off; keeps the best.
  CapReturn newton(const bool on_cap, Unknowns unknowns)
  {
    CapReturn best;
    double best_error = 1e300;
    for (unsigned iteration = 0; iteration < 20; ++iteration) {
      const auto at = tables_.surface(trial_.compaction + unknowns[0]);
      const auto e = residual(on_cap, at, unknowns);
      const double scale = value_of(at.radius()) + value_of(at.top());
      const double error =
          std::max(std::abs(e[0].val()),
                   std::abs(e[1].val()) / (on_cap ? 1 : scale)) /
          scale;
      const double a = e[0].dx(0), b = e[0].dx(1), c = e[1].dx(0),
                   d = e[1].dx(1), determinant = a * d - b * c;
      if (!(error < best_error) && (best_error < 1e-10 || iteration > 12))
        break;
      if (!std::isfinite(error) || !(std::abs(determinant) > 0))
        break;
      if (error < best_error) {
        best_error = error;
        best = {Surface::none,
                unknowns[0],
                unknowns[1],
                {{{d / determinant, -b / determinant},
                  {-c / determinant, a / determinant}}},
                at,
                error < 1e-10};
      }
      if (error < 1e-14)
        break;
      unknowns[0] -= (d * e[0].val() - b * e[1].val()) / determinant;
      unknowns[1] -= (a * e[1].val() - c * e[0].val()) / determinant;
    }
    best.surface = name_of(on_cap, best);
    return best;
  }

  std::array<Derivative2, 2> residual(const bool on_cap,
                                      const CapSurface<ByCompaction> &at,
                                      const Unknowns &unknowns) const
  {
    const CapTrial<Derivative2> trial{
        trial_.p, trial_.q, trial_.bulk, trial_.shear, trial_.compaction};
    const Derivative2 x(2, 0, unknowns[0]);
    return return_residual<Derivative2>(
        carry(at, x), trial, on_cap, {x, Derivative2(2, 1, unknowns[1])});
  }

  Surface name_of(const bool on_cap, const CapReturn &found) const
  {
    if (on_cap)
      return Surface::cap;
    const auto s = values_of(found.at);
    if (found.position <= 1e-6 * s.top())
      return Surface::apex;
    return s.transition > 0 && p(found.compaction_change) > s.transition_begin()
               ? Surface::transition
               : Surface::shear;
  }

  CapTables &tables_;
  const CapSurface<double> start_;
  const CapTrial<double> trial_;
};
} // namespace

CapReturn return_to_surface(CapTables &tables,
                            const CapSurface<ByCompaction> &start,
                            const CapTrial<double> &trial)
{
  return Return(tables, start, trial).solve();
}
} // namespace tamp::fem
