// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/bracketed_root.h>
#include <fem/laws/cap_return.h>
#include <fem/laws/strain_derivative.h>

#include <algorithm>
#include <cmath>
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
  Return(const DruckerPragerCapParameters &parameters,
         const CapTrial<double> &trial)
      : parameters_(parameters), trial_(trial)
  {
  }

  CapReturn solve() const
  {
    const auto start = cap_surface(parameters_, trial_.compaction);
    const double scale = start.radius() + start.top();
    if (start.yield(trial_.p, trial_.q) <= 1e-13 * scale)
      return {Surface::none, 0, 0, {}, true};
    const bool on_cap = trial_.p > start.centre;
    const auto unknowns = on_cap ? cap() : shear();
    if (!unknowns)
      return {};
    return polish(on_cap, *unknowns);
  }

private:
  CapSurface<double> surface(const double x) const
  {
    return cap_surface(parameters_, trial_.compaction + x);
  }
  double p(const double x) const { return trial_.p - trial_.bulk * x; }

  std::optional<Unknowns> cap() const
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

  std::optional<Unknowns> shear() const
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
              parameters_, trial_, false, {x, limit(x)})[1];
        },
        begin,
        *end);
    if (!x)
      return Unknowns{begin, limit(begin)};
    return Unknowns{*x, limit(*x)};
  }

  /// Newton steps from a good start; keeps the best.
  CapReturn polish(const bool on_cap, Unknowns unknowns) const
  {
    CapReturn best;
    double best_error = 1e300;
    for (unsigned iteration = 0; iteration < 12; ++iteration) {
      const auto e = evaluate(on_cap, unknowns);
      const auto s = surface(unknowns[0]);
      const double scale = s.radius() + s.top();
      const double error =
          std::max(std::abs(e[0].val()),
                   std::abs(e[1].val()) / (on_cap ? 1 : scale)) /
          scale;
      const double a = e[0].dx(0), b = e[0].dx(1), c = e[1].dx(0),
                   d = e[1].dx(1), determinant = a * d - b * c;
      if (!(error < best_error) || !(std::abs(determinant) > 0))
        break;
      best_error = error;
      best = {name_of(on_cap, unknowns),
              unknowns[0],
              unknowns[1],
              {{{d / determinant, -b / determinant},
                {-c / determinant, a / determinant}}},
              error < 1e-10};
      const auto &inverse = best.inverse_jacobian;
      for (unsigned i = 0; i < 2; ++i)
        unknowns[i] -= inverse[i][0] * e[0].val() + inverse[i][1] * e[1].val();
      if (error < 1e-15)
        break;
    }
    return best;
  }

  std::array<Derivative2, 2> evaluate(const bool on_cap,
                                      const Unknowns &unknowns) const
  {
    const CapTrial<Derivative2> trial{
        trial_.p, trial_.q, trial_.bulk, trial_.shear, trial_.compaction};
    return return_residual<Derivative2>(
        parameters_,
        trial,
        on_cap,
        {Derivative2(2, 0, unknowns[0]), Derivative2(2, 1, unknowns[1])});
  }

  Surface name_of(const bool on_cap, const Unknowns &unknowns) const
  {
    if (on_cap)
      return Surface::cap;
    const auto s = surface(unknowns[0]);
    if (unknowns[1] <= 1e-6 * s.top())
      return Surface::apex;
    return s.transition > 0 && p(unknowns[0]) > s.transition_begin()
               ? Surface::transition
               : Surface::shear;
  }

  const DruckerPragerCapParameters &parameters_;
  const CapTrial<double> trial_;
};
} // namespace

template <class Number>
CapSurface<Number> cap_surface(const DruckerPragerCapParameters &parameters,
                               const Number &compaction)
{
  using std::exp;
  const Number density = parameters.reference_density * exp(compaction);
  return CapSurface<Number>({read(parameters.cohesion, density),
                             read(parameters.friction_angle, density),
                             read(parameters.eccentricity, density),
                             read(parameters.hardening, compaction),
                             parameters.transition});
}

template <class Number>
std::array<Number, 2>
return_residual(const DruckerPragerCapParameters &parameters,
                const CapTrial<Number> &trial,
                const bool on_cap,
                const std::array<Number, 2> &unknowns)
{
  using std::cos;
  using std::sin;
  const auto &[x, position] = unknowns;
  const CapSurface<Number> s =
      cap_surface(parameters, Number(trial.compaction + x));
  const Number p = trial.p - trial.bulk * x;
  if (on_cap) {
    const Number cosine = cos(position), sine = sin(position);
    return {Number(s.centre + s.radius() * cosine - p),
            Number((trial.q - s.top() * sine) * cosine -
                   3. * trial.shear * x * s.eccentricity / s.factor * sine)};
  }
  return {
      Number(position - s.shear_limit(p)),
      Number(3. * trial.shear * x * position / (s.factor * s.factor) +
             (trial.q - position) * (s.centre - p) * s.tan_beta * s.tan_beta)};
}

CapReturn return_to_surface(const DruckerPragerCapParameters &parameters,
                            const CapTrial<double> &trial)
{
  return Return(parameters, trial).solve();
}

template CapSurface<double> cap_surface(const DruckerPragerCapParameters &,
                                        const double &);
template CapSurface<StrainDerivative>
cap_surface(const DruckerPragerCapParameters &, const StrainDerivative &);
template std::array<double, 2>
return_residual(const DruckerPragerCapParameters &,
                const CapTrial<double> &,
                bool,
                const std::array<double, 2> &);
template std::array<StrainDerivative, 2>
return_residual(const DruckerPragerCapParameters &,
                const CapTrial<StrainDerivative> &,
                bool,
                const std::array<StrainDerivative, 2> &);
} // namespace tamp::fem
