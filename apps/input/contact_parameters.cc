// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/contact_parameters.h>
#include <apps/input/parameter_table.h>
#include <apps/input/stage_reader.h>
#include <dem/law_names.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>

namespace tamp::apps
{
namespace
{
const std::vector<std::string> normal_laws(dem::normal_law_names.begin(),
                                           dem::normal_law_names.end());
const std::vector<std::string>
    tangential_laws(dem::tangential_law_names.begin(),
                    dem::tangential_law_names.end());
const std::vector<std::string> rolling_laws(dem::rolling_law_names.begin(),
                                            dem::rolling_law_names.end());

const std::vector<std::string> partners{"grain", "wall", "rigid wall"};
// In the order of their places.
const std::vector<std::string> coordinates{"overlap",
                                           "slip_x",
                                           "slip_y",
                                           "spin",
                                           "rotation_x",
                                           "rotation_y",
                                           "rotation_z"};

void declare_laws(ParameterTable &table)
{
  table.choice(
      "Normal law",
      "thornton-ning",
      normal_laws,
      "How grains push: elastic (hertz; jkr with adhesion), elastic and "
      "perfectly plastic (thornton-ning; thornton-ning-jkr with adhesion; "
      "thornton-ning-adjusted under a limiting pressure that changes), "
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

constexpr const char *adjusted_pressures = "Limiting contact pressures";
constexpr const char *adjusted_densities =
    "Densities of limiting contact pressures";

void declare_adjusted(ParameterTable &table)
{
  table.quantities(
      adjusted_pressures,
      "",
      dimension::pressure,
      positive,
      "p_y adjusted to the relative density of the cell, in place of Limiting "
      "contact pressure: one at each of the densities below, ln p_y linear "
      "between them and constant outside. A fit to a measured curve, no "
      "property of the grains. Normal law thornton-ning-adjusted, cells only; "
      "a second species keeps its own");
  table.quantities(adjusted_densities,
                   "",
                   dimension::number,
                   positive,
                   "Relative densities of a cell at which Limiting contact "
                   "pressures hold, rising");
}

PairStage read_stage(const std::string &text, unsigned number, PairPlace place)
{
  StageReader reader(text, number);
  std::vector<std::string> words = coordinates;
  for (;;) {
    const std::size_t word = reader.expect(words);
    if (word == coordinates.size())
      break;
    reader.expect({"to"});
    place[word] = reader.quantity(word < coordinate::spin ? dimension::length
                                                          : dimension::angle);
    if (words.size() == coordinates.size())
      words.emplace_back("in");
  }
  const unsigned steps = reader.whole();
  if (!reader.done())
    reader.expect({"steps", "step"});
  reader.finish();
  return {text, place, steps};
}

void declare_bodies(ParameterTable &table)
{
  table.quantity("First diameter",
                 "200 um",
                 dimension::length,
                 positive,
                 "Diameter of the first grain");
  table.choice("Partner",
               "grain",
               partners,
               "What the first grain touches: another grain of the same solid, "
               "a flat wall, or a wall that gives way nowhere");
  table.quantity("Second diameter",
                 "200 um",
                 dimension::length,
                 positive,
                 "Diameter of the second grain; partner grain only");
  table.quantity("Wall Young's modulus",
                 "210 GPa",
                 dimension::pressure,
                 positive,
                 "E of the wall, which does not yield; partner wall only");
  table.quantity("Wall Poisson's ratio",
                 "0.3",
                 dimension::number,
                 {-1, 0.5, true, true},
                 "nu of the wall; partner wall only");
}

void declare_impact(ParameterTable &table)
{
  table.flag("Impact",
             false,
             "The first grain flies freely against its partner, which is at "
             "rest, instead of following Stages");
  table.quantity("Normal speed",
                 "1 m/s",
                 dimension::speed,
                 positive,
                 "Of approach along the line of the centres; impact");
  table.quantity("Tangential speed",
                 "0 m/s",
                 dimension::speed,
                 {},
                 "Of the first grain along x; impact");
  table.quantity("Angle",
                 "0 deg",
                 dimension::angle,
                 {0, 0.5 * std::numbers::pi, false, true},
                 "Between the flight and the normal; in place of Tangential "
                 "speed, normal speed x tan(angle); impact");
  table.quantity("Spin",
                 "0 rad/s",
                 dimension::angular_speed,
                 {},
                 "Of the first grain; the patch that touches moves along x "
                 "with tangential speed + radius x spin; impact");
  table.integer(
      "Time steps", 4000, 100, "In the time of an elastic contact; impact");
  table.integer(
      "Record interval", 10, 1, "Steps between lines of curve.csv; impact");
}

void read_bodies(const ParameterTable &table, PairInput &pair)
{
  pair.first = dem::Body::grain(0.5 * table.number("Pair/First diameter"),
                                pair.material);
  const std::string partner = table.word("Pair/Partner");
  if (partner == "grain") {
    pair.partner = pair.material;
    pair.second = dem::Body::grain(0.5 * table.number("Pair/Second diameter"),
                                   pair.material);
    return;
  }
  pair.second = dem::Body::wall();
  pair.partner =
      partner == "wall"
          ? dem::elastic_wall(table.number("Pair/Wall Young's modulus"),
                              table.number("Pair/Wall Poisson's ratio"))
          : dem::rigid_wall();
}

void read_stages(const ParameterTable &table, PairInput &pair)
{
  const double radius = dem::shape_of(pair.first, pair.second).reduced_radius;
  try {
    pair.stages = parse_pair_stages(table.word("Pair/Stages"));
    for (const PairStage &stage : pair.stages)
      if (stage.end[coordinate::overlap] > 2 * radius)
        throw InputError(fmt::format("stage '{}': no law holds above twice the "
                                     "reduced radius; expected an overlap of "
                                     "at most {:.4g} um",
                                     stage.text,
                                     2e6 * radius));
  } catch (const InputError &error) {
    table.complain("Pair/Stages", error.what());
  }
}

void read_impact(const ParameterTable &table, PairInput &pair)
{
  const double normal = table.number("Pair/Normal speed");
  const double angle = table.number("Pair/Angle");
  double tangential = table.number("Pair/Tangential speed");
  if (angle > 0) {
    if (tangential != 0)
      table.complain(
          "Pair/Angle",
          "Pair/Tangential speed = " + table.word("Pair/Tangential speed") +
              " is given, too; expected one of them");
    tangential = normal * std::tan(angle);
  }
  pair.first.velocity = {tangential, 0, normal};
  pair.first.spin = {0, table.number("Pair/Spin"), 0};
  pair.time_steps = static_cast<double>(table.whole("Pair/Time steps"));
  pair.record_interval =
      static_cast<unsigned>(table.whole("Pair/Record interval"));
}
} // namespace

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
  declare_adjusted(table);
  table.quantity(
      "Work of adhesion",
      "0 J/m2",
      dimension::surface_energy,
      not_negative,
      "Gamma, of the interface: twice the surface energy of equal solids; "
      "jkr and thornton-ning-jkr, which refuses a limiting contact pressure "
      "below 0.425 (2 E*^2 Gamma / (pi^2 R*))^(1/3)");
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
  table.quantity(
      "Bulk onset",
      "0.5",
      dimension::number,
      {0, 1, false, true},
      "psi_b: share of the surface of a grain that is still free when "
      "its contacts begin to press on each other; law mdr only, in "
      "cells. To be fitted; 0: never");
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
  contact.bulk_onset = table.number("Contact/Bulk onset");
  contact.friction_coefficient = table.number("Contact/Friction coefficient");
}

std::vector<dem::PressureAtDensity>
read_adjusted_pressures(const ParameterTable &table)
{
  const std::string of_pressures = std::string("Contact/") + adjusted_pressures;
  const std::string of_densities = std::string("Contact/") + adjusted_densities;
  const std::vector<double> pressures = table.numbers(of_pressures);
  const std::vector<double> densities = table.numbers(of_densities);
  const std::string law = table.word("Contact/Normal law");
  if (pressures.size() != densities.size())
    table.complain(of_pressures,
                   fmt::format("expected as many as {} = {}, which are {}",
                               of_densities,
                               table.word(of_densities),
                               densities.size()));
  if (!pressures.empty() && law != "thornton-ning-adjusted")
    table.complain(of_pressures,
                   fmt::format("expected Contact/Normal law = "
                               "thornton-ning-adjusted; {} takes the limiting "
                               "contact pressure for constant",
                               law));
  std::vector<dem::PressureAtDensity> adjusted;
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    if (k > 0 && densities[k] <= densities[k - 1])
      table.complain(of_densities, "expected densities that rise");
    adjusted.push_back({densities[k], pressures[k]});
  }
  return adjusted;
}

std::vector<PairStage> parse_pair_stages(const std::string &stages)
{
  std::vector<PairStage> path;
  PairPlace place{};
  for (const std::string &text : split_stages(stages)) {
    path.push_back(
        read_stage(text, static_cast<unsigned>(path.size() + 1), place));
    place = path.back().end;
  }
  if (path.empty())
    throw InputError("there is no stage; expected for example 'overlap to 2 um "
                     "in 100; slip_x to 1 um in 50'");
  return path;
}

void declare_pair(ParameterTable &table)
{
  table.enter("Pair");
  declare_bodies(table);
  table.text("Stages",
             "overlap to 2 um in 100; slip_x to 1 um in 50; overlap to 0 in "
             "100",
             "Divided by semicolons: COORDINATE to VALUE ... in N steps. "
             "Coordinates are overlap, slip_x, slip_y (of the surfaces, second "
             "less first), spin (mean, about the normal), rotation_x, "
             "rotation_y, rotation_z (of the first relative to the second); "
             "those not named rest");
  declare_impact(table);
  table.leave();
}

PairInput read_pair(const ParameterTable &table,
                    const dem::GrainMaterial &material,
                    const dem::ContactModel &model)
{
  PairInput pair;
  pair.material = material;
  read_bodies(table, pair);
  if (!material.adjusted_pressures.empty())
    table.complain("Contact/Limiting contact pressures",
                   "a pair of grains is in no cell and has no relative "
                   "density; expected Contact/Limiting contact pressure");
  if (pair.second.is_wall() && model.normal_law == dem::NormalLaw::mdr)
    table.complain("Pair/Partner", "the law mdr is for two grains");
  pair.impact = table.on("Pair/Impact");
  if (pair.impact)
    read_impact(table, pair);
  else
    read_stages(table, pair);
  return pair;
}
} // namespace tamp::apps
