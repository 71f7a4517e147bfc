// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/corotated_response.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/plastic_path.h>
#include <fem/require.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tamp::fem
{
namespace
{
/// The hydrostatic yield pressure of FKM over sigma_0, and the floor: constant
/// while the formula is negative, then a parabola that touches both.
template <class Number>
Number fkm_yield(const FkmGursonParameters &parameters, const Number &density)
{
  const double loose = parameters.random_packing_density,
               floor = parameters.yield_floor;
  const Number formula =
      2.97 * density * density * (density - loose) / (1 - loose);
  if (formula <= 0.)
    return floor;
  if (formula < 2 * floor)
    return Number(floor + formula * formula / (4 * floor));
  return formula;
}

/// w: 0 up to the begin of the blend, 1 from its end, with continuous slope.
template <class Number>
Number gurson_weight(const Number &density)
{
  const Number x = (density - FkmGurson::blend_begin) /
                   (FkmGurson::blend_end - FkmGurson::blend_begin);
  if (x <= 0.)
    return 0.;
  if (x >= 1.)
    return 1.;
  return Number(x * x * (3. - 2. * x));
}

template <class Number>
FkmGursonSurface<Number> surface_at(const FkmGursonParameters &parameters,
                                    const Number &density,
                                    const Number &porosity)
{
  return {
      parameters.solid_yield_stress,
      parameters.vertex_rounding,
      Number(parameters.solid_yield_stress * fkm_yield(parameters, density)),
      porosity,
      gurson_weight(density)};
}

/// The law during an increment. The hardening variable is h = ln(D / f), which
/// keeps its digits at both ends; a stage's p is that at its start.
class FkmGursonIncrement
{
public:
  explicit FkmGursonIncrement(const FkmGursonParameters &parameters)
      : parameters_(parameters),
        bulk_ratio_(1 / (3 * (1 - 2 * parameters.solid_poissons_ratio))),
        shear_ratio_(0.5 / (1 + parameters.solid_poissons_ratio))
  {
  }

  template <class Number>
  FkmGursonSurface<Number> surface(const Number &hardening) const
  {
    return surface_at(parameters_, density(hardening), porosity(hardening));
  }

  double size(const FkmGursonSurface<double> &surface) const
  {
    return surface.largest_pressure();
  }

  template <class Number>
  StagePlace<Number> place(const Stage<Number> &stage, const Number &u) const
  {
    const Number hardening = stage.hardening + u;
    const Number E = youngs_modulus(hardening);
    const Number compaction = compaction_of_change(stage.hardening, u);
    return {Number(stage.p + bulk_ratio_ * E * (stage.strain - compaction)),
            Number(shear_ratio_ * E),
            compaction};
  }

  template <class Number>
  bool start_stage(const PlasticPoint<Number> &start,
                   const PlasticPoint<Number> *middle,
                   Stage<Number> &stage) const
  {
    stage.p = start.p;
    stage.hardening = start.hardening;
    if (!middle)
      return true;
    stage.p += TwoStageMethod::base * (middle->p - start.p);
    const Number compaction =
        TwoStageMethod::base *
        compaction_of_change(start.hardening,
                             Number(middle->hardening - start.hardening));
    // f over its value at the start, less one.
    const Number change = -density(start.hardening) /
                          porosity(start.hardening) * growth(compaction);
    if (!(change > -1.))
      return false;
    stage.hardening += compaction - log_of_growth(change);
    return true;
  }

  template <class Number>
  PlasticPoint<Number> elastic(const PlasticPoint<Number> &point,
                               const Components<Number> &strain,
                               const Number &share) const
  {
    const Number E = youngs_modulus(point.hardening);
    const auto shape = deviator_of(strain);
    const Number rate = compaction_of(strain);
    PlasticPoint<Number> end = point;
    end.compaction += share * rate;
    end.p += share * bulk_ratio_ * E * rate;
    for (unsigned k = 0; k < 6; ++k)
      end.deviator[k] += share * 2. * shear_ratio_ * E * shape[k];
    end.yielding = false;
    return end;
  }

  struct Moduli {
    double bulk, shear; ///< [Pa]
  };
  template <class Number>
  Moduli moduli(const PlasticPoint<Number> &point) const
  {
    const double E = youngs_modulus(value_of(point.hardening));
    return {bulk_ratio_ * E, shear_ratio_ * E};
  }

private:
  template <class Number>
  static Number density(const Number &hardening)
  {
    using std::exp;
    return Number(1. / (1. + exp(-hardening)));
  }
  template <class Number>
  static Number porosity(const Number &hardening)
  {
    using std::exp;
    return Number(1. / (1. + exp(hardening)));
  }

  /// exp(x) - 1 without loss of digits.
  template <class Number>
  static Number growth(const Number &x)
  {
    return Number(std::expm1(value_of(x)) +
                  std::exp(value_of(x)) * (x - value_of(x)));
  }

  /// ln(1 + x) without loss of digits.
  template <class Number>
  static Number log_of_growth(const Number &x)
  {
    return Number(std::log1p(value_of(x)) +
                  (x - value_of(x)) / (1 + value_of(x)));
  }

  /// ln(D_new / D) where h changes by u.
  template <class Number>
  static Number compaction_of_change(const Number &h, const Number &u)
  {
    return Number(-log_of_growth(Number(porosity(h) * growth(Number(-u)))));
  }

  template <class Number>
  Number youngs_modulus(const Number &hardening) const
  {
    using std::exp;
    return Number(parameters_.solid_youngs_modulus *
                  exp(-parameters_.elastic_exponent * porosity(hardening)));
  }

  const FkmGursonParameters &parameters_;
  const double bulk_ratio_, shear_ratio_;
};

/// Integrates with or without derivatives. False if the increment failed.
template <class Number>
bool integrate(const FkmGursonParameters &parameters,
               const FkmGurson::State &old,
               const Corotation &corotation,
               FkmGurson::State &now,
               dealii::SymmetricTensor<4, 3> &tangent)
{
  const FkmGursonIncrement law(parameters);
  auto point = start_from<Number>(old.stress);
  point.hardening = std::log((1 - old.porosity) / old.porosity);
  const PlasticPath<FkmGursonIncrement, Number> path(
      law,
      independent<Number>(corotation.log_stretch()),
      parameters.integration_tolerance);
  if (!path.advance(point))
    return false;
  const auto answer = corotated_stress(point);
  now.stress = corotation.rotate(answer.stress);
  if (value_of(point.hardening) != std::log((1 - old.porosity) / old.porosity))
    now.porosity = law.surface(value_of(point.hardening)).porosity;
  now.plastic_shear += point.plastic_shear;
  now.yielding = point.yielding;
  if constexpr (!std::is_same_v<Number, double>)
    tangent = corotation.tangent(answer);
  return std::isfinite(now.stress.norm()) && std::isfinite(tangent.norm()) &&
         now.porosity > 0 && now.porosity < 1;
}
} // namespace

void FkmGursonParameters::check() const
{
  require(solid_yield_stress > 0 && std::isfinite(solid_yield_stress),
          "solid yield stress [Pa]",
          solid_yield_stress,
          "above 0");
  require(solid_youngs_modulus > 0 && std::isfinite(solid_youngs_modulus),
          "solid Young's modulus [Pa]",
          solid_youngs_modulus,
          "above 0");
  require(solid_poissons_ratio > -1 && solid_poissons_ratio < 0.5,
          "solid Poisson's ratio [-]",
          solid_poissons_ratio,
          "between -1 and 0.5");
  require(elastic_exponent >= 0 && elastic_exponent <= 50,
          "elastic exponent [-]",
          elastic_exponent,
          "from 0 to 50");
  require(random_packing_density > 0 &&
              random_packing_density < FkmGurson::blend_begin,
          "random packing density [-]",
          random_packing_density,
          "above 0 and below 0.77");
  require(initial_relative_density > 0 && initial_relative_density < 1,
          "initial relative density [-]",
          initial_relative_density,
          "above 0 and below 1");
  require(yield_floor > 0 && yield_floor <= 0.1,
          "yield floor [-]",
          yield_floor,
          "above 0 and up to 0.1");
  require(vertex_rounding > 0 && vertex_rounding <= 0.1,
          "vertex rounding [-]",
          vertex_rounding,
          "above 0 and up to 0.1");
  require(integration_tolerance > 0 && integration_tolerance <= 0.01,
          "integration tolerance [-]",
          integration_tolerance,
          "above 0 and up to 0.01");
}

FkmGurson::FkmGurson(const FkmGursonParameters &parameters)
    : parameters_(parameters)
{
  parameters_.check();
}

FkmGurson::State FkmGurson::initial_state() const
{
  State state;
  state.relative_density = parameters_.initial_relative_density;
  state.porosity = 1 - parameters_.initial_relative_density;
  return state;
}

Response FkmGurson::respond(const State &old,
                            State &now,
                            const Deformation &deformation,
                            const Want want) const
{
  return corotated_response(
      old,
      now,
      deformation,
      [&](const Corotation &corotation, State &end, auto &tangent) {
        const bool good =
            want == Want::stress
                ? integrate<double>(parameters_, old, corotation, end, tangent)
                : integrate<StrainDerivative>(
                      parameters_, old, corotation, end, tangent);
        if (!good)
          return Status::failed;
        return 1 - end.porosity < parameters_.random_packing_density
                   ? Status::doubtful
                   : Status::converged;
      });
}

std::vector<Variable> FkmGurson::variables()
{
  return {
      {"plastic_volumetric_strain", "-", "compaction since the start"},
      {"plastic_shear_strain", "-", "sum of equivalent increments"},
      {"yielding", "-", "1 where the last increment ended plastic"},
      {"hydrostatic_yield_pressure", "Pa", "where the surface meets q = 0"}};
}

void FkmGurson::variables_of(const State &state, std::span<double> values) const
{
  const std::array<double, 4> now{
      std::log((1 - state.porosity) / parameters_.initial_relative_density),
      state.plastic_shear,
      static_cast<double>(state.yielding),
      surface(state.porosity).largest_pressure()};
  std::ranges::copy(now, values.begin());
}

FkmGursonSurface<double> FkmGurson::surface(const double porosity) const
{
  return surface_at(parameters_, 1 - porosity, porosity);
}
} // namespace tamp::fem
