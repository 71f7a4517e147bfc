// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/law_text.h>
#include <apps/input/parameter_table.h>
#include <apps/input/run_input.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "fit_place.h"
#include "law_probe.h"

namespace tamp::apps
{
namespace
{
/// Numbers are written with seven digits, of which the logarithm of a density
/// may cost one.
constexpr double digits = 1e-6;
constexpr double degree = std::numbers::pi / 180;

coupling::CapChoice some_law()
{
  coupling::CapChoice law;
  law.relative_density = {0.55, 0.6123456789, 0.7, 0.81};
  law.cohesion = {12345.678, 2e5, 7.7777777e5, 3e6};
  law.friction_angle = {55 * degree, 1.05, 1.1, 1.14};
  law.cap_eccentricity = {0.4, 0.5, 0.61234567, 0.8};
  law.elasticity = {{0.55, 0.7, 0.81}, {1e8, 3e9, 7.654321e9}, {0.1, 0.2, 0.3}};
  for (int i = 0; i < 40; ++i) {
    law.hardening_density.push_back(0.5 + 0.01 * i + 1e-3 / 7);
    law.hydrostatic_yield.push_back(1e6 * std::pow(1.2, i));
  }
  law.initial_relative_density = 0.55;
  return law;
}

using Rows = std::vector<std::vector<double>>;

// The data lines below a keyword, empty fields as zero.
Rows read_rows(const std::string &text, const std::string &keyword)
{
  std::istringstream in(text);
  bool inside = false;
  Rows rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("**"))
      continue;
    if (line.starts_with("*")) {
      inside = line.substr(0, line.find(',')) == keyword;
      continue;
    }
    if (!inside)
      continue;
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');)
      rows.back().push_back(field == " " ? 0 : std::stod(field));
  }
  return rows;
}

double remark_value(const std::string &text, const std::string &name)
{
  return std::stod(text.substr(text.find(name + " = ") + name.size() + 3));
}

coupling::CapChoice read_abaqus(const std::string &text)
{
  coupling::CapChoice law;
  const double reference = remark_value(text, "D_ref");
  for (const auto &row : read_rows(text, "*ELASTIC")) {
    law.elasticity.youngs_modulus.push_back(row.at(0));
    law.elasticity.poissons_ratio.push_back(row.at(1));
    law.elasticity.relative_density.push_back(row.at(3));
  }
  for (const auto &row : read_rows(text, "*CAP PLASTICITY")) {
    law.cohesion.push_back(row.at(0));
    law.friction_angle.push_back(row.at(1) * degree);
    law.cap_eccentricity.push_back(row.at(2));
    law.initial_relative_density = reference * std::exp(row.at(3));
    law.transition = row.at(4);
    EXPECT_EQ(row.at(5), 1); // K
    law.relative_density.push_back(row.at(7));
  }
  for (const auto &row : read_rows(text, "*CAP HARDENING")) {
    law.hydrostatic_yield.push_back(row.at(0));
    law.hardening_density.push_back(reference * std::exp(row.at(1)));
  }
  return law;
}

coupling::CapChoice read_prm(const FitPlace &place, const std::string &text)
{
  place.write("law.prm", text);
  ParameterTable table;
  declare_parameters(table);
  table.read(place / "law.prm");
  const RunInput input = read_input(table, Need::point);
  EXPECT_EQ(input.material.kind, coupling::MaterialKind::drucker_prager_cap);
  return input.material.cap;
}

void expect_near(const std::vector<double> &a, const std::vector<double> &b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i] / b[i], 1, digits) << i;
}

void expect_same(const coupling::CapChoice &a, const coupling::CapChoice &b)
{
  expect_near(a.relative_density, b.relative_density);
  expect_near(a.cohesion, b.cohesion);
  expect_near(a.friction_angle, b.friction_angle);
  expect_near(a.cap_eccentricity, b.cap_eccentricity);
  expect_near(a.hardening_density, b.hardening_density);
  expect_near(a.hydrostatic_yield, b.hydrostatic_yield);
  expect_near(a.elasticity.relative_density, b.elasticity.relative_density);
  expect_near(a.elasticity.youngs_modulus, b.elasticity.youngs_modulus);
  expect_near(a.elasticity.poissons_ratio, b.elasticity.poissons_ratio);
  expect_near({a.initial_relative_density}, {b.initial_relative_density});
  EXPECT_EQ(a.transition, b.transition);
}

TEST(LawText, SectionMaterialIsReadAsTheLaw)
{
  const FitPlace place;
  expect_same(read_prm(place, cap_text(some_law(), {"A remark.", "Another."})),
              some_law());
}

TEST(LawText, BlockOfAbaqusReadBackIsTheSectionMaterial)
{
  const FitPlace place;
  const auto block = read_abaqus(abaqus_text(some_law(), {"A remark."}));
  expect_same(block, read_prm(place, cap_text(some_law(), {})));
}

fem::ModifiedCamClayParameters some_clay()
{
  fem::ModifiedCamClayParameters law;
  law.critical_state_slope = 1.3123456;
  law.compression_index = 0.2;
  law.swelling_index = 0.02;
  law.poissons_ratio = 0.2;
  law.initial_relative_density = 0.6;
  law.initial_yield_pressure = 2.3456789e6;
  return law;
}

/// What stands in the block of Abaqus.
struct AbaqusClay {
  double kappa, poissons_ratio, lambda, slope, size, pressure, void_ratio;
};

AbaqusClay read_clay(const std::string &text)
{
  const auto elastic = read_rows(text, "*POROUS ELASTIC").at(0),
             clay = read_rows(text, "*CLAY PLASTICITY").at(0);
  const auto first_of = [&](const std::string &type) {
    const std::string start = "TYPE=" + type + "\n**   powder, ";
    return std::stod(text.substr(text.find(start) + start.size()));
  };
  EXPECT_EQ(clay.at(3), 1); // beta: the same ellipse on the wet side
  EXPECT_EQ(clay.at(4), 1); // K
  return {elastic.at(0),
          elastic.at(1),
          clay.at(0),
          clay.at(1),
          clay.at(2),
          -first_of("STRESS"),
          first_of("RATIO")};
}

TEST(LawText, BlockOfCamClayReadBackIsTheLaw)
{
  const auto law = some_clay();
  const AbaqusClay block = read_clay(abaqus_text(law, 0.9, {"A remark."}));
  EXPECT_NEAR(block.kappa / law.swelling_index, 1, digits);
  EXPECT_NEAR(block.poissons_ratio / law.poissons_ratio, 1, digits);
  EXPECT_NEAR(block.lambda / law.compression_index, 1, digits);
  EXPECT_NEAR(block.slope / law.critical_state_slope, 1, digits);
  EXPECT_NEAR(2 * block.size / law.initial_yield_pressure, 1, digits);
  EXPECT_NEAR(block.pressure / law.initial_yield_pressure, 1, digits);
}

// Abaqus Materials Guide: J_el - 1 = kappa / (1 + e_0) ln(p_0 / p) and
// a = a_0 exp((1 + e_0) (1 - J_pl) / (lambda - kappa J_pl)), so that on the
// line of first compression, p = 2 a, the volume is (1 + e_0) J_el J_pl.
TEST(LawText, CamClayOfAbaqusHasTheSameLineOfFirstCompression)
{
  const fem::ModifiedCamClay law(some_clay());
  const std::string text = abaqus_text(some_clay(), 0.85, {});
  const AbaqusClay block = read_clay(text);
  const double volume = 1 + block.void_ratio;
  auto state = law.initial_state();
  double stiffer = 0;
  while (state.relative_density < 0.85) {
    const auto old = state;
    (void)law.respond(old, state, {stretch(true, 5e-3)}, fem::Want::stress);
    const double p = fem::pressure(state.stress),
                 growth = std::log(p / block.pressure);
    if (growth < 0)
      continue;
    const double plastic = (volume - block.lambda * growth) /
                           (volume - block.kappa * growth),
                 elastic = 1 - block.kappa / volume * growth;
    EXPECT_NEAR(volume * elastic * plastic * state.relative_density, 1, 1e-6);
    stiffer =
        volume * elastic * p / block.kappa / elastic_moduli(law, state).at(0);
  }
  // What is said of elasticity, with three digits; half an increment in D.
  const double said = std::stod(text.substr(
      text.find("at the start to ") + std::string("at the start to ").size()));
  EXPECT_NEAR(stiffer / said, 1, 0.01);
  EXPECT_GT(said, 1.1);
}

TEST(LawText, LinesOfFilesAreShort)
{
  const std::string remark(
      "So long a remark that it has to be broken into more than one line, as "
      "nobody wants to scroll sideways to read what a file says of itself.");
  for (const std::string &text : {cap_text(some_law(), {remark}),
                                  abaqus_text(some_law(), {remark}),
                                  abaqus_text(some_clay(), 0.9, {remark})}) {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      EXPECT_LE(line.size(), 80u) << line;
  }
}
} // namespace
} // namespace tamp::apps
