// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input_sections.h>
#include <apps/parameter_table.h>

#include <algorithm>
#include <iterator>

namespace tamp::apps
{
namespace
{
// Order as in the enumerations of dem.
const std::vector<std::string> distributions{"uniform", "normal", "lognormal"};
const std::vector<std::string> normal_laws{
    "hertz", "thornton-ning", "jkr", "thornton-ning-jkr", "storakers", "mdr"};
const std::vector<std::string> tangential_laws{
    "none", "mindlin", "mindlin-deresiewicz"};
const std::vector<std::string> rolling_laws{"none", "epsd"};
const std::vector<std::string> methods{"quasi-static", "dynamics"};

template <class Choice>
Choice chosen(const ParameterTable &table,
              const std::string &path,
              const std::vector<std::string> &choices)
{
  return static_cast<Choice>(std::distance(
      choices.begin(), std::ranges::find(choices, table.word(path))));
}

void declare_sizes(ParameterTable &table)
{
  table.enter("Grains");
  table.integer("Count", 1000, 20, "Grains in a unit cell");
  table.choice("Diameter distribution",
               "uniform",
               distributions,
               "How diameters are distributed, by number; normal and lognormal "
               "are cut off at the minimum and maximum");
  table.quantity("Minimum diameter",
                 "136 um",
                 dimension::length,
                 positive,
                 "Diameter of the smallest grain");
  table.quantity("Maximum diameter",
                 "264 um",
                 dimension::length,
                 positive,
                 "Diameter of the largest grain");
  table.quantity("Mean diameter",
                 "200 um",
                 dimension::length,
                 positive,
                 "Mean of a normal or lognormal distribution");
  table.quantity("Standard deviation",
                 "30 um",
                 dimension::length,
                 positive,
                 "Of the diameter, normal or lognormal distribution");
  table.quantity("Young's modulus",
                 "70 GPa",
                 dimension::pressure,
                 positive,
                 "E of the grains");
  table.quantity("Poisson's ratio",
                 "0.3",
                 dimension::number,
                 {-1, 0.5, true, true},
                 "nu of the grains");
  table.quantity("Density",
                 "2650 kg/m3",
                 dimension::density,
                 positive,
                 "Of the solid that grains are made of; only dynamics feels "
                 "it");
  table.leave();
}

void declare_laws(ParameterTable &table)
{
  table.choice(
      "Normal law",
      "thornton-ning",
      normal_laws,
      "How grains push: elastic (hertz; jkr with adhesion), elastic and "
      "perfectly plastic (thornton-ning; thornton-ning-jkr with adhesion), "
      "plastic (storakers), or at high relative density (mdr)");
  table.choice(
      "Tangential law",
      "mindlin",
      tangential_laws,
      "How grains rub: none, stick or slide, or slip from the rim of the "
      "contact inwards");
  table.choice(
      "Rolling law",
      "none",
      rolling_laws,
      "How grains resist rolling and twisting: not, or by a spring that slips");
}

void declare_contact(ParameterTable &table)
{
  table.enter("Contact");
  declare_laws(table);
  table.quantity("Friction coefficient",
                 "0.3",
                 dimension::number,
                 not_negative,
                 "mu between grains");
  table.quantity("Limiting contact pressure",
                 "0.5 GPa",
                 dimension::pressure,
                 positive,
                 "p_y, where the pressure in a contact is cut off; laws with "
                 "plasticity only");
  table.quantity(
      "Work of adhesion",
      "0 J/m2",
      dimension::surface_energy,
      not_negative,
      "Gamma, of the interface: twice the surface energy of equal solids; "
      "jkr and thornton-ning-jkr");
  table.quantity(
      "Rolling friction coefficient",
      "0.1",
      dimension::number,
      not_negative,
      "mu_r: largest rolling moment over reduced radius x normal force; "
      "rolling law epsd");
  table.quantity(
      "Restitution coefficient",
      "1",
      dimension::number,
      {0, 1, true, false},
      "Of an elastic impact, by viscous damping in the contact; 1: none. "
      "Felt by dynamics and impacts only");
  table.leave();
}

void declare_packing(ParameterTable &table)
{
  table.enter("Packing");
  table.choice("Source", "generate", {"generate"}, "Where packings come from");
  table.integer("Seed",
                1,
                0,
                "Of the random numbers of the run; every material point has "
                "its own, made from this and its number");
  table.quantity("Initial relative density",
                 "0.35",
                 dimension::number,
                 {0.05, 0.38, false, false},
                 "Of the loose random start, before compression");
  table.quantity("Pressure",
                 "100 kPa",
                 dimension::pressure,
                 positive,
                 "Mean stress at which packings are handed over; at least "
                 "0.5 MPa for a die");
  table.choice("Compression",
               "isotropic",
               {"isotropic"},
               "How loose packings are compressed");
  table.quantity("Friction during packing",
                 "-1",
                 dimension::number,
                 {-1, 10, false, false},
                 "mu while packing; negative: as between grains. Less friction "
                 "packs denser");
  table.flag("Same at all points",
             false,
             "All material points start from the same packing");
  table.integer("Sample",
                0,
                0,
                "Number of the run's packing that a probe takes, or the "
                "first point of a die: point N of a die is sample N of a "
                "probe with the same seed");
  table.leave();
}

void declare_cell(ParameterTable &table)
{
  table.enter("Cell");
  table.choice("Method",
               "quasi-static",
               methods,
               "How grains follow a strain: static equilibrium, or damped "
               "motion at a strain rate");
  table.quantity("Unbalance tolerance",
                 "1e-3",
                 dimension::number,
                 {0, 0.1, true, false},
                 "Mean force on a grain over mean contact force, at "
                 "equilibrium; quasi-static");
  table.quantity("Maximum strain increment",
                 "1e-2",
                 dimension::number,
                 {0, 0.1, true, false},
                 "A larger one is divided; quasi-static");
  table.integer("Maximum evaluations",
                3000,
                10,
                "Of all contact forces for an increment; quasi-static");
  table.flag("Warm start",
             true,
             "Start from the last trial of the same step: half the work, same "
             "answer within the tolerance; quasi-static");
  table.choice(
      "Precision", "double", {"double"}, "Of the numbers grains move with");
  table.quantity("Strain rate",
                 "1e-5 1/s",
                 dimension::rate,
                 positive,
                 "Largest principal rate; dynamics");
  table.quantity("Density scaling",
                 "1e12",
                 dimension::number,
                 positive,
                 "Factor on the density of the grains; dynamics");
  table.quantity("Time step fraction",
                 "0.2",
                 dimension::number,
                 {0, 1, true, false},
                 "Of the Rayleigh time step; dynamics");
  table.quantity("Global damping",
                 "0.05",
                 dimension::number,
                 not_negative,
                 "Share of the critical damping of a mean grain; dynamics");
  table.leave();
}

void read_contact(const ParameterTable &table, dem::ContactModel &contact)
{
  contact.normal_law =
      chosen<dem::NormalLaw>(table, "Contact/Normal law", normal_laws);
  contact.tangential_law = chosen<dem::TangentialLaw>(
      table, "Contact/Tangential law", tangential_laws);
  contact.rolling_law =
      chosen<dem::RollingLaw>(table, "Contact/Rolling law", rolling_laws);
  contact.work_of_adhesion = table.number("Contact/Work of adhesion");
  contact.rolling_friction_coefficient =
      table.number("Contact/Rolling friction coefficient");
  contact.restitution_coefficient =
      table.number("Contact/Restitution coefficient");
  contact.friction_coefficient = table.number("Contact/Friction coefficient");
}
} // namespace

void declare_grains(ParameterTable &table)
{
  declare_sizes(table);
  declare_contact(table);
  declare_packing(table);
  declare_cell(table);
}

void read_grains(const ParameterTable &table,
                 coupling::MaterialChoice &material)
{
  dem::PackingRequest &packing = material.packing;
  packing.grain_count = static_cast<std::size_t>(table.whole("Grains/Count"));
  dem::GrainSizes &sizes = packing.sizes;
  sizes.distribution = chosen<dem::SizeDistribution>(
      table, "Grains/Diameter distribution", distributions);
  sizes.minimum_diameter = table.number("Grains/Minimum diameter");
  sizes.maximum_diameter = table.number("Grains/Maximum diameter");
  sizes.mean_diameter = table.number("Grains/Mean diameter");
  sizes.standard_deviation = table.number("Grains/Standard deviation");
  if (sizes.minimum_diameter > sizes.maximum_diameter)
    table.complain("Grains/Minimum diameter",
                   "it is above Grains/Maximum diameter = " +
                       table.word("Grains/Maximum diameter"));
  if (sizes.distribution == dem::SizeDistribution::uniform) {
    sizes.mean_diameter =
        0.5 * (sizes.minimum_diameter + sizes.maximum_diameter);
  } else if (sizes.mean_diameter <= sizes.minimum_diameter ||
             sizes.mean_diameter >= sizes.maximum_diameter) {
    table.complain("Grains/Mean diameter",
                   "expected a diameter between the minimum, " +
                       table.word("Grains/Minimum diameter") +
                       ", and the maximum, " +
                       table.word("Grains/Maximum diameter"));
  }
  packing.material.youngs_modulus = table.number("Grains/Young's modulus");
  packing.material.poissons_ratio = table.number("Grains/Poisson's ratio");
  packing.material.density = table.number("Grains/Density");

  read_contact(table, packing.contact);
  packing.material.limiting_pressure =
      table.number("Contact/Limiting contact pressure");

  packing.seed = static_cast<std::uint64_t>(table.whole("Packing/Seed"));
  packing.initial_relative_density =
      table.number("Packing/Initial relative density");
  packing.pressure = table.number("Packing/Pressure");
  packing.friction_during_packing =
      table.number("Packing/Friction during packing");

  material.same_packing = table.on("Packing/Same at all points");
  material.first_packing =
      static_cast<std::size_t>(table.whole("Packing/Sample"));

  dem::Driving &driving = material.driving;
  driving.method = chosen<dem::Method>(table, "Cell/Method", methods);
  driving.quasi_static.unbalance_tolerance =
      table.number("Cell/Unbalance tolerance");
  driving.quasi_static.maximum_strain_increment =
      table.number("Cell/Maximum strain increment");
  driving.quasi_static.maximum_evaluations =
      static_cast<std::size_t>(table.whole("Cell/Maximum evaluations"));
  driving.dynamics.strain_rate = table.number("Cell/Strain rate");
  driving.dynamics.density_scaling = table.number("Cell/Density scaling");
  driving.dynamics.time_step_fraction = table.number("Cell/Time step fraction");
  driving.dynamics.global_damping = table.number("Cell/Global damping");
  material.warm = table.on("Cell/Warm start");
}
} // namespace tamp::apps
