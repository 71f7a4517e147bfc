// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_increment.h>
#include <fem/laws/cap_tables.h>
#include <fem/laws/corotated_response.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/require.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tamp::fem
{
using dealii::SymmetricTensor;

namespace
{
bool outside_tables(const DruckerPragerCapParameters &parameters,
                    const double compaction)
{
  const double density = parameters.reference_density * std::exp(compaction);
  return parameters.elasticity.at(density).outside ||
         parameters.cohesion.read(density).outside ||
         parameters.friction_angle.read(density).outside ||
         parameters.eccentricity.read(density).outside ||
         parameters.hardening.read(compaction).outside;
}

} // namespace

double pressure(const SymmetricTensor<2, 3> &stress)
{
  return -trace(stress) / 3;
}

double deviatoric_stress(const SymmetricTensor<2, 3> &stress)
{
  return std::sqrt(1.5) * deviator(stress).norm();
}

void DruckerPragerCapParameters::check() const
{
  elasticity.check();
  require(cohesion.smallest() >= 0,
          "cohesion [Pa]",
          cohesion.smallest(),
          "not below 0");
  require(friction_angle.smallest() > 0,
          "friction angle [rad]",
          friction_angle.smallest(),
          "above 0");
  require(friction_angle.largest() < 1.5,
          "friction angle [rad]",
          friction_angle.largest(),
          "below 1.5 (86 degrees)");
  require(eccentricity.smallest() > 0,
          "cap eccentricity [-]",
          eccentricity.smallest(),
          "above 0");
  require(hardening.smallest() > 0,
          "hydrostatic yield pressure [Pa]",
          hardening.smallest(),
          "above 0");
  require(hardening.is_increasing(),
          "hydrostatic yield pressure [Pa], from",
          hardening.smallest(),
          "a table that does not decrease");
  require(reference_density > 0 && reference_density < 1,
          "reference density [-]",
          reference_density,
          "between 0 and 1");
  require(initial_relative_density > 0 && initial_relative_density <= 1,
          "initial relative density [-]",
          initial_relative_density,
          "above 0 and up to 1");
  require(transition >= 0 && transition <= 0.1 &&
              1 + transition - transition / std::cos(friction_angle.largest()) >
                  0.1,
          "transition alpha [-]",
          transition,
          "from 0 to 0.1 and below 0.9 / (1 / cos(beta) - 1)");
  require(maximum_strain_increment > 0,
          "maximum strain increment [-]",
          maximum_strain_increment,
          "above 0");
  require(integration_tolerance > 0,
          "integration tolerance [-]",
          integration_tolerance,
          "above 0");
}

DruckerPragerCap::DruckerPragerCap(const DruckerPragerCapParameters &parameters)
    : parameters_(parameters)
{
  parameters_.check();
}

DruckerPragerCap::State DruckerPragerCap::initial_state() const
{
  State state;
  state.relative_density = parameters_.initial_relative_density;
  state.plastic_compaction = std::log(parameters_.initial_relative_density /
                                      parameters_.reference_density);
  return state;
}

Response DruckerPragerCap::respond(const State &old,
                                   State &now,
                                   const Deformation &deformation,
                                   const Want want) const
{
  return corotated_response(
      old,
      now,
      deformation,
      [&](const Corotation &corotation, State &end, auto &tangent) {
        const auto answer =
            integrate_cap(parameters_, old, corotation.log_stretch(), want);
        if (!answer)
          return Status::failed;
        if (want == Want::stress_and_tangent)
          tangent = corotation.tangent(answer->stress);
        if (!std::isfinite(tangent.norm()))
          return Status::failed;
        end.stress = corotation.rotate(answer->stress.stress);
        end.plastic_compaction = answer->plastic_compaction;
        end.plastic_shear = answer->plastic_shear;
        end.surface = answer->surface;
        end.outside_tables =
            outside_tables(parameters_, end.plastic_compaction);
        return end.outside_tables || !answer->is_resolved ? Status::doubtful
                                                          : Status::converged;
      });
}

std::vector<Variable> DruckerPragerCap::variables()
{
  return {{"plastic_volumetric_strain", "-", "compaction since the start"},
          {"plastic_shear_strain", "-", "sum of equivalent increments"},
          {"active_surface",
           "-",
           "0 elastic, 1 shear failure, 2 transition, 3 cap, 4 apex"},
          {"hydrostatic_yield_pressure", "Pa", "p_b"},
          {"outside_tables", "-", "1 where a table of the law was left"}};
}

void DruckerPragerCap::variables_of(const State &state,
                                    std::span<double> values) const
{
  const std::array<double, 5> now{
      state.plastic_compaction - initial_state().plastic_compaction,
      state.plastic_shear,
      static_cast<double>(state.surface),
      parameters_.hardening.read(state.plastic_compaction).value,
      static_cast<double>(state.outside_tables)};
  std::ranges::copy(now, values.begin());
}

CapSurface<double>
DruckerPragerCap::surface(const double plastic_compaction) const
{
  return values_of(CapTables(parameters_).surface(plastic_compaction));
}

double DruckerPragerCap::yield(const State &state) const
{
  const auto s = surface(state.plastic_compaction);
  return s.yield(pressure(state.stress), deviatoric_stress(state.stress)) /
         (s.radius() + s.strength);
}
} // namespace tamp::fem
