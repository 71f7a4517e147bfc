// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/corotated_response.h>
#include <fem/laws/modified_cam_clay.h>
#include <fem/laws/plastic_path.h>
#include <fem/require.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tamp::fem
{
namespace
{
/// The law during one increment. The hardening variable is ln(p_c / p_floor);
/// a stage's p is the pressure without plastic compaction in it.
class CamClayIncrement
{
public:
  CamClayIncrement(const ModifiedCamClayParameters &parameters,
                   const double specific_volume)
      : parameters_(parameters), specific_volume_(specific_volume),
        plastic_index_(parameters.compression_index -
                       parameters.swelling_index),
        shear_ratio_(1.5 * (1 - 2 * parameters.poissons_ratio) /
                     (1 + parameters.poissons_ratio))
  {
  }

  template <class Number>
  CamClaySurface<Number> surface(const Number &hardening) const
  {
    using std::exp;
    return {parameters_.critical_state_slope,
            Number(parameters_.floor_pressure * exp(hardening))};
  }

  double size(const CamClaySurface<double> &surface) const
  {
    return surface.yield_pressure + 1e-3 * parameters_.floor_pressure;
  }

  template <class Number>
  StagePlace<Number> place(const Stage<Number> &stage, const Number &u) const
  {
    const Number volume = specific_volume(stage.compaction);
    const Number p = pressure(Number(
        logarithm(stage.p) - plastic_index_ / parameters_.swelling_index * u));
    return {p, shear(bulk(p, volume)), Number(plastic_index_ * u / volume)};
  }

  template <class Number>
  bool start_stage(const PlasticPoint<Number> &start,
                   const PlasticPoint<Number> *middle,
                   Stage<Number> &stage) const
  {
    Number flown = 0.; // plastic specific volume over lambda - kappa
    if (middle)
      flown = TwoStageMethod::base * (middle->hardening - start.hardening);
    stage.hardening = start.hardening + flown;
    stage.p = pressure(
        Number(logarithm(start.p) +
               (specific_volume(start.compaction) -
                specific_volume(stage.compaction) - plastic_index_ * flown) /
                   parameters_.swelling_index));
    return true;
  }

  template <class Number>
  PlasticPoint<Number> elastic(const PlasticPoint<Number> &point,
                               const Components<Number> &strain,
                               const Number &share) const
  {
    const Number rate = compaction_of(strain);
    PlasticPoint<Number> end = point;
    end.compaction += share * rate;
    end.p = pressure(
        Number(logarithm(point.p) + (specific_volume(point.compaction) -
                                     specific_volume(end.compaction)) /
                                        parameters_.swelling_index));
    // The secant: change of pressure over compaction, times the share.
    Number secant = share * bulk(point);
    if (std::abs(value_of(rate)) > 1e-6)
      secant = (end.p - point.p) / rate;
    else
      secant *= 1. + 0.5 * share * rate * stiffening(point);
    const auto shape = deviator_of(strain);
    for (unsigned k = 0; k < 6; ++k)
      end.deviator[k] += 2. * shear(secant) * shape[k];
    end.yielding = false;
    return end;
  }

  struct Moduli {
    double bulk, shear; ///< [Pa]
  };
  template <class Number>
  Moduli moduli(const PlasticPoint<Number> &point) const
  {
    const double K = value_of(bulk(point));
    return {K, shear(K)};
  }

private:
  template <class Number>
  Number specific_volume(const Number &compaction) const
  {
    using std::exp;
    return Number(specific_volume_ * exp(-compaction));
  }

  /// psi(p).
  template <class Number>
  Number logarithm(const Number &p) const
  {
    using std::log;
    const Number x = p / parameters_.floor_pressure;
    return x > 1. ? Number(log(x)) : Number(x - 1.);
  }

  /// The pressure where psi has this value.
  template <class Number>
  Number pressure(const Number &logarithm) const
  {
    using std::exp;
    return logarithm > 0.
               ? Number(parameters_.floor_pressure * exp(logarithm))
               : Number(parameters_.floor_pressure * (1. + logarithm));
  }

  template <class Number>
  Number bulk(const Number &p, const Number &volume) const
  {
    Number felt = parameters_.floor_pressure;
    if (p > felt)
      felt = p;
    return Number(volume * felt / parameters_.swelling_index);
  }
  template <class Number>
  Number bulk(const PlasticPoint<Number> &point) const
  {
    return bulk(point.p, specific_volume(point.compaction));
  }
  template <class Number>
  Number shear(const Number &bulk) const
  {
    return Number(shear_ratio_ * bulk);
  }

  /// (dK / d compaction) / K in elastic compaction.
  template <class Number>
  Number stiffening(const PlasticPoint<Number> &point) const
  {
    if (point.p > parameters_.floor_pressure)
      return Number(
          specific_volume(point.compaction) / parameters_.swelling_index - 1.);
    return -1.;
  }

  const ModifiedCamClayParameters &parameters_;
  const double specific_volume_, plastic_index_, shear_ratio_;
};

/// Integrates with or without derivatives. False if the increment failed.
template <class Number>
bool integrate(const ModifiedCamClayParameters &parameters,
               const ModifiedCamClay::State &old,
               const Corotation &corotation,
               ModifiedCamClay::State &now,
               dealii::SymmetricTensor<4, 3> &tangent)
{
  const CamClayIncrement law(parameters, 1 / old.relative_density);
  auto point = start_from<Number>(old.stress);
  point.hardening = std::log(old.yield_pressure / parameters.floor_pressure);
  const PlasticPath<CamClayIncrement, Number> path(
      law,
      independent<Number>(corotation.log_stretch()),
      parameters.integration_tolerance);
  if (!path.advance(point))
    return false;
  const auto answer = corotated_stress(point);
  now.stress = corotation.rotate(answer.stress);
  now.yield_pressure = law.surface(value_of(point.hardening)).yield_pressure;
  now.plastic_compaction += point.plastic_compaction;
  now.plastic_shear += point.plastic_shear;
  now.yielding = point.yielding;
  if constexpr (!std::is_same_v<Number, double>)
    tangent = corotation.tangent(answer);
  return std::isfinite(now.stress.norm()) && std::isfinite(tangent.norm()) &&
         now.yield_pressure > 0;
}
} // namespace

void ModifiedCamClayParameters::check() const
{
  require(critical_state_slope > 0 && critical_state_slope < 3,
          "critical state slope [-]",
          critical_state_slope,
          "above 0 and below 3");
  require(swelling_index > 0, "swelling index [-]", swelling_index, "above 0");
  require(compression_index > swelling_index &&
              std::isfinite(compression_index),
          "compression index [-]",
          compression_index,
          "above the swelling index");
  require(poissons_ratio > -1 && poissons_ratio < 0.5,
          "Poisson's ratio [-]",
          poissons_ratio,
          "between -1 and 0.5");
  require(initial_relative_density > 0 && initial_relative_density <= 1,
          "initial relative density [-]",
          initial_relative_density,
          "above 0 and up to 1");
  require(initial_yield_pressure > 0 && std::isfinite(initial_yield_pressure),
          "initial yield pressure [Pa]",
          initial_yield_pressure,
          "above 0");
  require(floor_pressure > 0 && std::isfinite(floor_pressure),
          "floor pressure [Pa]",
          floor_pressure,
          "above 0");
  require(integration_tolerance > 0 && integration_tolerance <= 0.01,
          "integration tolerance [-]",
          integration_tolerance,
          "above 0 and up to 0.01");
}

ModifiedCamClay::ModifiedCamClay(const ModifiedCamClayParameters &parameters)
    : parameters_(parameters)
{
  parameters_.check();
}

ModifiedCamClay::State ModifiedCamClay::initial_state() const
{
  State state;
  state.relative_density = parameters_.initial_relative_density;
  state.yield_pressure = parameters_.initial_yield_pressure;
  return state;
}

Response ModifiedCamClay::respond(const State &old,
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
        return end.relative_density > 1 ? Status::doubtful : Status::converged;
      });
}

std::vector<Variable> ModifiedCamClay::variables()
{
  return {{"plastic_volumetric_strain", "-", "compaction since the start"},
          {"plastic_shear_strain", "-", "sum of equivalent increments"},
          {"yielding", "-", "1 where the last increment ended plastic"},
          {"hydrostatic_yield_pressure", "Pa", "p_c"}};
}

void ModifiedCamClay::variables_of(const State &state,
                                   std::span<double> values) const
{
  const std::array<double, 4> now{state.plastic_compaction,
                                  state.plastic_shear,
                                  static_cast<double>(state.yielding),
                                  state.yield_pressure};
  std::ranges::copy(now, values.begin());
}

CamClaySurface<double> ModifiedCamClay::surface(const State &state) const
{
  return {parameters_.critical_state_slope, state.yield_pressure};
}
} // namespace tamp::fem
