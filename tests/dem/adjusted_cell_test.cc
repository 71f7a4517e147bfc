// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/dynamics.h>
#include <dem/measures.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// Cells whose limiting contact pressure is adjusted to their density.
namespace tamp::dem
{
namespace
{
using test::message_of;

/// Small cells of granules whose p_y follows a table.
PackingRequest request_of(const std::vector<PressureAtDensity> &table)
{
  PackingRequest request = test::alumina_request();
  request.grain_count = 60;
  request.contact.normal_law = NormalLaw::thornton_ning_adjusted;
  request.material.adjusted_pressures = table;
  return request;
}

const std::vector<PressureAtDensity> constant = {{0.5, 50e6}};
// Of the packing of 60 grains, at 0.63, and what 8 % of strain make of it.
const std::vector<PressureAtDensity> rising = {{0.62, 20e6}, {0.68, 200e6}};

UnitCell packed(const std::vector<PressureAtDensity> &table)
{
  return make_packing(request_of(table));
}

Stretch isotropic(double log_strain)
{
  return std::exp(log_strain) * Stretch::Identity();
}

TEST(AdjustedCell, PressureIsThatOfTheTable)
{
  GrainMaterial material;
  material.adjusted_pressures = {{0.6, 20e6}, {0.7, 80e6}, {0.8, 40e6}};
  const auto at = [&](double density) {
    return material.at_density(density).limiting_pressure;
  };
  EXPECT_EQ(at(0.3), 20e6);
  EXPECT_EQ(at(0.6), 20e6);
  EXPECT_DOUBLE_EQ(at(0.65), 40e6); // the geometric mean
  EXPECT_EQ(at(0.7), 80e6);
  EXPECT_DOUBLE_EQ(at(0.775), 80e6 / std::pow(2, 0.75));
  EXPECT_EQ(at(0.8), 40e6);
  EXPECT_EQ(at(1.2), 40e6);
  EXPECT_TRUE(material.at_density(0.65).adjusted_pressures.empty());
  EXPECT_EQ(GrainMaterial().at_density(0.7), GrainMaterial());
}

TEST(AdjustedCell, TheSofterOfTwoMaterialsYieldsAtTheDensityOfTheCell)
{
  UnitCell cell =
      test::fcc_cell(1e-3, {.normal_law = NormalLaw::thornton_ning_adjusted});
  test::mix_species(cell); // the second yields at 1.2 GPa
  const double density = cell.relative_density(), radius = 5e-5;
  cell.materials[0].adjusted_pressures = {{density - 0.1, 20e6},
                                          {density + 0.1, 80e6}};
  const CellLaws laws(cell);
  const auto slope = [&](std::size_t kind) {
    double more[AdjustedThorntonNing::more] = {};
    return std::get<AdjustedThorntonNing>(laws.of_kind(kind).normal)
        .loading_slope(0.1 * radius, {4 * radius, radius, 0, 0}, {0, 0, more});
  };
  constexpr double pi = std::numbers::pi;
  EXPECT_DOUBLE_EQ(slope(0), pi * 40e6 * radius); // the geometric mean
  EXPECT_DOUBLE_EQ(slope(1), pi * 40e6 * radius);
  EXPECT_DOUBLE_EQ(slope(2), pi * 1.2e9 * radius);
}

TEST(AdjustedCell, TablesThatAreNoneAreRefused)
{
  const auto refusal = [](const std::vector<PressureAtDensity> &table) {
    GrainMaterial material;
    material.adjusted_pressures = table;
    return message_of<std::invalid_argument>([&] { material.check(); });
  };
  EXPECT_EQ(refusal({{0.6, 1e6}, {0.7, 1e6}}), "");
  EXPECT_NE(refusal({{0.6, 1e6}, {0.6, 2e6}}).find("rise"), std::string::npos);
  EXPECT_NE(refusal({{-0.6, 1e6}}).find("-0.6"), std::string::npos);
  EXPECT_NE(refusal({{0.6, 0}}).find("adjusted limiting contact pressure = 0"),
            std::string::npos);
}

TEST(AdjustedCell, AnotherLawRefusesATable)
{
  UnitCell cell = packed(constant);
  cell.contact.normal_law = NormalLaw::thornton_ning;
  cell.contacts.clear();
  cell.more_memory.clear();
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              deform(cell, isotropic(-1e-4), {});
            }).find("thornton-ning-adjusted"),
            std::string::npos);
}

/// The same cell under the law of a table, with what its contacts remember
/// then.
UnitCell converted(UnitCell cell, const std::vector<PressureAtDensity> &table)
{
  const CellLaws laws(cell);
  for (const ContactMemory &contact : cell.contacts) {
    const auto &law = std::get<ThorntonNing>(laws.of(contact.pair).normal);
    const PairShape<double> shape = cell.shape(contact.pair);
    NormalMemory<double> memory = {contact.largest_overlap,
                                   contact.contact_radius};
    const bool yielded = law.is_plastic(shape, memory);
    const double lost = law.energy(0, shape, memory).dissipated;
    const auto peak = law(contact.largest_overlap, shape, memory);
    for (double number : {peak.force, lost})
      cell.more_memory.push_back(yielded ? number : 0);
  }
  cell.contact.normal_law = NormalLaw::thornton_ning_adjusted;
  cell.materials[0].adjusted_pressures = table;
  return cell;
}

TEST(AdjustedCell, IsThatOfThorntonNingUnderAConstantPressure)
{
  constexpr double round_off = 1e-12;
  // Two ways to settle within the unbalance, see instruction_sets_test.cc.
  constexpr double among_ways = 1e-3;
  UnitCell plain = test::alumina_cell();
  UnitCell adjusted = converted(plain, constant);
  const Matrix3 start = love_weber_stress(plain);
  EXPECT_LT((love_weber_stress(adjusted) - start).norm(),
            round_off * start.norm());
  EXPECT_NEAR(survey_contacts(adjusted).plastic_loss,
              survey_contacts(plain).plastic_loss,
              round_off * survey_contacts(plain).plastic_loss);
  const CellAnswer wanted = test::compress(plain, -5e-3, 5, {});
  const CellAnswer found = test::compress(adjusted, -5e-3, 5, {});
  EXPECT_GT((wanted.stress - start).norm(), 0.1 * start.norm());
  EXPECT_LT((found.stress - wanted.stress).norm(),
            among_ways * wanted.stress.norm());
}

TEST(AdjustedCell, ForcesDoNotJumpWithThePressure)
{
  // The cell at rest is in equilibrium under the p_y of its density, too.
  UnitCell cell = packed(rising);
  const double fraction = 1e-9; // of an overlap, to the power 3/2 at most
  for (int k = 0; k < 6; ++k) {
    const CellAnswer answer = deform(cell, isotropic(-4e-3), {});
    ASSERT_EQ(answer.outcome, Outcome::settled);
    UnitCell other = cell;
    other.materials[0].adjusted_pressures = {{0.5, 1e6}};
    EXPECT_LT((love_weber_stress(other) - answer.stress).norm(),
              fraction * answer.stress.norm());
    other.materials[0].adjusted_pressures = {{0.5, 1e9}};
    EXPECT_LT((love_weber_stress(other) - answer.stress).norm(),
              fraction * answer.stress.norm());
  }
}

TEST(AdjustedCell, StressStaysBetweenThoseOfTheEnds)
{
  const auto pressure = [](const std::vector<PressureAtDensity> &table) {
    UnitCell cell = packed({{0.5, 20e6}});
    cell.materials[0].adjusted_pressures = table;
    return -test::compress(cell, -0.12, 15, {}).stress.trace() / 3;
  };
  const double low = pressure({{0.5, 20e6}}), high = pressure({{0.5, 200e6}});
  const double between = pressure(rising);
  EXPECT_GT(between, 1.2 * low);
  EXPECT_LT(between, 0.8 * high);
}

TEST(AdjustedCell, PartsOfAnIncrementHaveThePressuresOfTheirDensities)
{
  Driving driving;
  driving.quasi_static.maximum_strain_increment = 5e-3;
  UnitCell whole = packed(rising), parts = whole, stale = whole;
  const CellAnswer one = deform(whole, isotropic(-0.03), driving);
  CellAnswer other;
  for (int k = 0; k < 6; ++k)
    other = deform(parts, isotropic(-5e-3), driving);
  const double now =
      stale.materials_now()[0].limiting_pressure; // kept all along
  stale.materials[0].adjusted_pressures = {{0.5, now}};
  const CellAnswer third = deform(stale, isotropic(-0.03), driving);
  // A product of stretches, and what settling makes of its round-off.
  EXPECT_LT((one.stress - other.stress).norm(), 1e-2 * one.stress.norm());
  EXPECT_GT((one.stress - third.stress).norm(), 5e-2 * one.stress.norm());
}

/// What a cell holds and what it has lost, less the work done on it [J].
double balance(const UnitCell &cell, const Driving &driving)
{
  const EnergyAccount &spent = cell.energy;
  return measure(cell).elastic_energy +
         measure_dynamics(cell, driving.dynamics, 1).kinetic_energy +
         spent.plastic_dissipation + spent.friction_dissipation +
         spent.damping_dissipation - spent.work;
}

TEST(AdjustedCell, LedgerClosesInDynamicsWhileThePressureChanges)
{
  // As in energy_ledger_test.cc: what time steps leave open.
  constexpr double of_the_work = 0.01;
  for (Precision precision : {Precision::double_precision, Precision::mixed}) {
    Driving driving;
    driving.method = Method::dynamics;
    driving.dynamics.strain_rate = 1e-3;
    driving.arithmetic.precision = precision;
    UnitCell cell = packed(rising);
    const double start = balance(cell, driving);
    double open = 0, plastic = 0;
    for (double strain : {-0.02, -0.02, 0.04, -0.03, -0.02, 0.1}) {
      ASSERT_NE(deform(cell, isotropic(strain), driving).outcome,
                Outcome::diverged);
      open = std::max(open, std::abs(balance(cell, driving) - start));
      EXPECT_GE(cell.energy.plastic_dissipation,
                plastic * (1 - 1e-5)); // single precision
      plastic = cell.energy.plastic_dissipation;
    }
    EXPECT_EQ(measure(cell).contacts, 0u); // all has opened
    EXPECT_GT(plastic, 0.2 * cell.energy.work);
    EXPECT_LT(open, of_the_work * cell.energy.work);
  }
}

TEST(AdjustedCell, MapLosesByYieldingWhatItsContactsLost)
{
  // The map books differences of the same energies; a cell whose contacts have
  // all opened has none left that could be booked twice.
  UnitCell cell = packed(rising);
  const double made = survey_contacts(cell).plastic_loss;
  test::compress(cell, -0.06, 8, {});
  const double lost = survey_contacts(cell).plastic_loss - made;
  EXPECT_GT(lost, 0);
  EXPECT_GT(cell.energy.plastic_dissipation, 0.9 * lost); // others have parted
  EXPECT_LT(cell.energy.plastic_dissipation, 1.1 * lost);
  const double before = cell.energy.plastic_dissipation;
  for (int k = 0; k < 8; ++k)
    deform(cell, isotropic(0.01), {});
  EXPECT_GE(cell.energy.plastic_dissipation, before * (1 - 1e-6));
}
} // namespace
} // namespace tamp::dem
