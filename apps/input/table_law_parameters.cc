// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/law_parameters.h>
#include <apps/input/parameter_table.h>

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace tamp::apps
{
namespace
{
constexpr Range a_density{0, 1, true, false};
constexpr Range a_poissons_ratio{-1, 0.5, true, true};
/// In the order of fem::Dilation.
const std::vector<std::string> dilations{"full", "bounded"};

void declare_elasticity(ParameterTable &table)
{
  table.quantities("Elastic densities",
                   "0.30, 0.40, 0.50, 0.60, 0.70, 0.803, 0.904, 0.98",
                   dimension::number,
                   a_density,
                   "Relative densities of the two elastic tables, increasing; "
                   "default: Avicel PH-102");
  table.quantities("Young's modulus",
                   "45, 177, 482, 1053, 2057, 3715, 6324, 9306 MPa",
                   dimension::pressure,
                   positive,
                   "E of the compact at the elastic densities");
  table.quantities("Poisson's ratio",
                   "0.016, 0.035, 0.061, 0.094, 0.136, 0.188, 0.251, 0.309",
                   dimension::number,
                   a_poissons_ratio,
                   "nu of the compact at the elastic densities");
}

void check_same_length(const ParameterTable &table,
                       const std::string &nodes,
                       const std::string &values)
{
  const std::size_t expected = table.numbers(nodes).size();
  if (table.numbers(values).size() != expected)
    table.complain(
        values,
        fmt::format("expected {} values, one for each of {}", expected, nodes));
}

std::vector<double> increasing(const ParameterTable &table,
                               const std::string &path)
{
  const std::vector<double> nodes = table.numbers(path);
  if (nodes.empty())
    table.complain(path, "expected at least one relative density");
  if (std::ranges::adjacent_find(nodes, std::greater_equal<>()) != nodes.end())
    table.complain(path, "expected densities that increase");
  return nodes;
}

coupling::ElasticTable read_elasticity(const ParameterTable &table,
                                       const std::string &section)
{
  coupling::ElasticTable elasticity;
  const std::string nodes = section + "/Elastic densities";
  elasticity.relative_density = increasing(table, nodes);
  check_same_length(table, nodes, section + "/Young's modulus");
  check_same_length(table, nodes, section + "/Poisson's ratio");
  elasticity.youngs_modulus = table.numbers(section + "/Young's modulus");
  elasticity.poissons_ratio = table.numbers(section + "/Poisson's ratio");
  return elasticity;
}

// Shape and hardening of the cap over density.
void declare_cap_tables(ParameterTable &table)
{
  table.quantities(
      "Shape densities",
      "0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.93, 0.96, 0.99",
      dimension::number,
      a_density,
      "Relative densities of the next three tables, increasing; default: "
      "Avicel PH-102 (public tables credited to Panos 2007)");
  table.quantities("Cohesion",
                   "0.0268, 0.7225, 1.156, 3.124, 5.849, 10.51, 18.65, 29.98, "
                   "34.08, 56.86 MPa",
                   dimension::pressure,
                   not_negative,
                   "d of the shear line at the shape densities");
  table.quantities("Friction angle",
                   "54.35, 68.78, 68.34, 68.03, 68.07, 67.42, 66.51, 66.32, "
                   "65.69, 63.40 deg",
                   dimension::angle,
                   {0, 1.5, true, true},
                   "beta of the shear line in the p-q plane at the shape "
                   "densities");
  table.quantities("Cap eccentricity",
                   "0.271, 0.312, 0.586, 0.640, 0.690, 0.789, 0.907, 1.02, "
                   "1.30, 1.608",
                   dimension::number,
                   positive,
                   "R of the cap at the shape densities");
  table.quantities(
      "Hardening densities",
      "0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 0.93, 0.956980, 0.99, 0.999",
      dimension::number,
      a_density,
      "Relative densities of the hydrostatic yield pressure, increasing");
  table.quantities("Hydrostatic yield pressure",
                   "0.609, 4.03, 10.7, 20.5, 35.78, 64.7, 127.9, 170, 257, "
                   "368, 823 MPa",
                   dimension::pressure,
                   positive,
                   "p_b, where the cap meets the pressure axis, at the "
                   "hardening densities");
}
} // namespace

void declare_elastic(ParameterTable &table)
{
  table.enter("Elastic");
  table.quantity("Initial relative density",
                 "0.6",
                 dimension::number,
                 a_density,
                 "Of the powder at the start");
  declare_elasticity(table);
  table.leave();
}

void declare_cap(ParameterTable &table)
{
  table.enter("Drucker-Prager cap");
  table.choice("Powder",
               "mcc ph102",
               {"mcc ph102", "agcusnin"},
               "Whose tables hold where nothing else is given below: Avicel "
               "PH-102 (the defaults that stand here) or the metal powder "
               "AgCuSnIn (public tables after Zhou et al. 2017; angle, "
               "eccentricity and elasticity linear between their ends)");
  table.quantity("Initial relative density",
                 "0.3411",
                 dimension::number,
                 a_density,
                 "Of the powder at the start");
  declare_elasticity(table);
  declare_cap_tables(table);
  table.quantity("Transition",
                 "0",
                 dimension::number,
                 {0, 0.1},
                 "alpha, the size of the arc between shear line and cap; 0: a "
                 "corner");
  table.choice("Dilation",
               "bounded",
               dilations,
               "In shear failure: full, after the flow potential of Abaqus, or "
               "bounded, so that plastic work is positive; of use where "
               "cohesion is small");
  table.quantity("Integration tolerance",
                 "1.5e-4",
                 dimension::number,
                 {0, 1, true, false},
                 "Estimated relative error of stress by which increments are "
                 "divided; the answer is more accurate");
  table.leave();
}

coupling::ElasticChoice read_elastic(const ParameterTable &table)
{
  coupling::ElasticChoice elastic;
  elastic.initial_relative_density =
      table.number("Material/Elastic/Initial relative density");
  elastic.elasticity = read_elasticity(table, "Material/Elastic");
  return elastic;
}

coupling::CapChoice read_cap(const ParameterTable &table)
{
  const std::string section = "Material/Drucker-Prager cap";
  coupling::CapChoice cap;
  cap.initial_relative_density =
      table.number(section + "/Initial relative density");
  cap.elasticity = read_elasticity(table, section);
  cap.transition = table.number(section + "/Transition");
  cap.dilation = chosen<fem::Dilation>(table, section + "/Dilation", dilations);
  cap.integration_tolerance = table.number(section + "/Integration tolerance");
  const std::string shape = section + "/Shape densities";
  cap.relative_density = increasing(table, shape);
  for (const char *name : {"/Cohesion", "/Friction angle", "/Cap eccentricity"})
    check_same_length(table, shape, section + name);
  cap.cohesion = table.numbers(section + "/Cohesion");
  cap.friction_angle = table.numbers(section + "/Friction angle");
  cap.cap_eccentricity = table.numbers(section + "/Cap eccentricity");
  const std::string hardening = section + "/Hardening densities";
  cap.hardening_density = increasing(table, hardening);
  check_same_length(table, hardening, section + "/Hydrostatic yield pressure");
  cap.hydrostatic_yield =
      table.numbers(section + "/Hydrostatic yield pressure");
  if (std::ranges::adjacent_find(cap.hydrostatic_yield,
                                 std::greater_equal<>()) !=
      cap.hydrostatic_yield.end())
    table.complain(section + "/Hydrostatic yield pressure",
                   "expected pressures that increase with density");
  return cap;
}
} // namespace tamp::apps
