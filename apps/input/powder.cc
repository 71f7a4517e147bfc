// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/powder.h>
#include <fem/laws/agcusnin.h>

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
namespace
{
/// Entries and their values, as they would stand in a file, in SI.
using Values = std::vector<std::pair<std::string, std::string>>;

std::string list(const std::vector<double> &numbers)
{
  return fmt::format("{}", fmt::join(numbers, ", "));
}

Values values_of(const fem::DruckerPragerCapParameters &powder)
{
  std::vector<double> hardening_density;
  for (const double strain : powder.hardening.rows().x)
    hardening_density.push_back(powder.reference_density * std::exp(strain));
  const auto &elasticity = powder.elasticity;
  return {{"Initial relative density", list({powder.initial_relative_density})},
          {"Elastic densities", list(elasticity.youngs_modulus.rows().x)},
          {"Young's modulus", list(elasticity.youngs_modulus.rows().y)},
          {"Poisson's ratio", list(elasticity.poissons_ratio.rows().y)},
          {"Shape densities", list(powder.cohesion.rows().x)},
          {"Cohesion", list(powder.cohesion.rows().y)},
          {"Friction angle", list(powder.friction_angle.rows().y)},
          {"Cap eccentricity", list(powder.eccentricity.rows().y)},
          {"Hardening densities", list(hardening_density)},
          {"Hydrostatic yield pressure", list(powder.hardening.rows().y)},
          {"Transition", list({powder.transition})},
          {"Dilation",
           powder.dilation == fem::Dilation::full ? "full" : "bounded"}};
}
} // namespace

void take_powder(ParameterTable &table)
{
  const std::string section = "Material/Drucker-Prager cap/";
  if (table.word(section + "Powder") != "agcusnin")
    return; // the defaults are those of mcc ph102
  for (const auto &[name, value] : values_of(fem::agcusnin::parameters()))
    if (!table.given(section + name))
      table.set(section + name + " = " + value);
}
} // namespace tamp::apps
