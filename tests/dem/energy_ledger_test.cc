// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/measures.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <tuple>
#include <utility>
#include <vector>

// Work is stored, kinetic or lost: cells in dynamics whose contacts form,
// yield, slide, roll and open again.
namespace tamp::dem
{
namespace
{
// Of the work, as in dynamics_test.cc: what time steps leave open, and the loss
// of sliding, which is booked with the contact radius of the end of a step.
constexpr double of_the_work = 0.01;

/// What a cell holds and what it has lost, less the work done on it [J].
double balance(const UnitCell &cell, const Driving &driving)
{
  const EnergyAccount &spent = cell.energy;
  return measure(cell).elastic_energy +
         measure_dynamics(cell, driving.dynamics, 1).kinetic_energy +
         spent.plastic_dissipation + spent.friction_dissipation +
         spent.damping_dissipation + spent.adhesion_dissipation - spent.work;
}

/// What a cell comes to along a path of isotropic strains.
struct Ledger {
  double open = 0;                  ///< the largest change of the balance [J]
  double work = 0;                  ///< most that was done on the cell [J]
  std::size_t fewest = 0, most = 0; ///< contacts
  EnergyAccount spent;

  Ledger(UnitCell cell,
         const std::vector<double> &strains,
         Precision precision = Precision::double_precision)
  {
    Driving driving;
    driving.method = Method::dynamics;
    driving.dynamics.strain_rate = 1e-3;
    driving.arithmetic.precision = precision;
    const double start = balance(cell, driving);
    fewest = most = measure(cell).contacts;
    constexpr int parts = 4;
    for (double strain : strains)
      for (int part = 0; part < parts; ++part) {
        const Stretch stretch = Stretch::Identity() * std::exp(strain / parts);
        EXPECT_NE(deform(cell, stretch, driving).outcome, Outcome::diverged);
        open = std::max(open, std::abs(balance(cell, driving) - start));
        work = std::max(work, cell.energy.work);
        fewest = std::min(fewest, measure(cell).contacts);
        most = std::max(most, measure(cell).contacts);
      }
    spent = cell.energy;
  }
};

PackingRequest small_request(const ContactModel &contact)
{
  PackingRequest request = test::alumina_request();
  request.grain_count = 60;
  request.contact = contact;
  return request;
}

TEST(EnergyLedger, ElasticEnergyCountsAllSpringsOfAContact)
{
  UnitCell cell =
      make_packing(small_request({.normal_law = NormalLaw::hertz,
                                  .rolling_law = RollingLaw::epsd,
                                  .friction_coefficient = 0.5,
                                  .rolling_friction_coefficient = 0.5}));
  deform(cell, test::uniaxial(-0.01), {});
  const double all = survey_contacts(cell).elastic_energy;
  EXPECT_DOUBLE_EQ(all, measure(cell).elastic_energy);
  for (ContactMemory &contact : cell.contacts)
    contact.tangential_force.setZero();
  EXPECT_LT(survey_contacts(cell).elastic_energy, 0.999 * all);
}

TEST(EnergyLedger, ClosesWithRollingResistance)
{
  // Much less than what the rolling springs hold, a hundredth of the work.
  constexpr double share = 1e-3;
  for (double friction : {0.1, 1.0})
    for (Precision precision :
         {Precision::double_precision, Precision::mixed}) {
      const Ledger ledger(make_packing(small_request(
                              {.normal_law = NormalLaw::hertz,
                               .rolling_law = RollingLaw::epsd,
                               .friction_coefficient = 0.5,
                               .rolling_friction_coefficient = friction})),
                          {-0.04, 0.08, -0.08},
                          precision);
      EXPECT_GT(ledger.most, 140u);
      EXPECT_EQ(ledger.fewest, 0u); // all contacts have opened
      EXPECT_LT(ledger.open, share * ledger.work);
    }
}

TEST(EnergyLedger, ClosesWhereAdhesionFormsAndTears)
{
  for (auto [normal, precision] :
       {std::pair(NormalLaw::jkr, Precision::mixed),
        std::pair(NormalLaw::thornton_ning_jkr, Precision::double_precision)}) {
    PackingRequest request = small_request({.normal_law = normal,
                                            .rolling_law = RollingLaw::epsd,
                                            .work_of_adhesion = 100});
    request.goal.pressure = 2e4;
    const Ledger ledger(
        make_packing(request), {0.05, -0.05, 0.05, -0.05}, precision);
    EXPECT_LT(ledger.fewest + 10, ledger.most); // they come and go
    EXPECT_LT(ledger.open, of_the_work * ledger.work);
    // Far less than the jumps of adhesion alone have cost, so that they
    // cannot be missing: what steps leave open where the force jumps.
    EXPECT_LT(ledger.open, 0.05 * ledger.spent.adhesion_dissipation);
  }
}

using Laws = std::tuple<NormalLaw, TangentialLaw>;

class EnergyLedgerOf : public testing::TestWithParam<Laws>
{
};

TEST_P(EnergyLedgerOf, ClosesWithAndWithoutRollingResistance)
{
  const auto [normal, tangential] = GetParam();
  for (const ContactModel &model : test::every_contact_model())
    if (model.normal_law == normal && model.tangential_law == tangential) {
      const Ledger ledger(make_packing(small_request(model)),
                          {-0.04, 0.08, -0.08});
      EXPECT_LT(ledger.fewest, 30u);
      EXPECT_LT(ledger.open, of_the_work * ledger.work);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Laws,
    EnergyLedgerOf,
    testing::Combine(testing::Values(NormalLaw::hertz,
                                     NormalLaw::thornton_ning,
                                     NormalLaw::jkr,
                                     NormalLaw::thornton_ning_jkr,
                                     NormalLaw::storakers,
                                     NormalLaw::thornton_ning_adjusted),
                     testing::Values(TangentialLaw::none,
                                     TangentialLaw::mindlin,
                                     TangentialLaw::mindlin_deresiewicz)));
} // namespace
} // namespace tamp::dem
