// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/packing.h>
#include <dem/random_start.h>
#include <dem/unit_cell.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

namespace tamp::dem
{
namespace
{
using test::alumina_cell;
using test::alumina_request;
using test::message_of;

double pressure(const UnitCell &cell)
{
  return -measure(cell).stress.trace() / 3;
}

TEST(Packing, HasThePressureThatWasAskedFor)
{
  constexpr double promised = 0.01; // in dem/packing.h
  EXPECT_NEAR(pressure(alumina_cell()), 0.5e6, promised * 0.5e6);
}

TEST(Packing, IsAtEquilibrium)
{
  UnitCell cell = alumina_cell();
  const CellAnswer answer = deform(cell, Stretch::Identity(), {});
  EXPECT_EQ(answer.outcome, Outcome::settled);
  // It was left at the unbalance tolerance already.
  EXPECT_LE(answer.evaluations, 2u);
  EXPECT_LT(measure(alumina_cell()).asymmetry, 1e-3);
}

TEST(Packing, IsNearlyIsotropic)
{
  const CellMeasures found = measure(alumina_cell());
  // 200 grains: a few per cent of the pressure by chance.
  EXPECT_LT((found.stress + 0.5e6 * Matrix3::Identity()).norm(), 0.2 * 0.5e6);
  EXPECT_NEAR(found.fabric.trace(), 1, 1e-12);
  EXPECT_LT((found.fabric - Matrix3::Identity() / 3).norm(), 0.05);
}

TEST(Packing, SameRequestGivesTheSameBits)
{
  EXPECT_EQ(make_packing(alumina_request()), alumina_cell());
}

TEST(Packing, OtherSeedGivesAnotherPacking)
{
  PackingRequest request = alumina_request();
  request.seed = 2;
  const UnitCell other = make_packing(request);
  EXPECT_NE(other.place, alumina_cell().place);
  EXPECT_NEAR(pressure(other), 0.5e6, 0.01 * 0.5e6);
  // Another arrangement of the same grains, in about the same space.
  EXPECT_NEAR(other.solid_volume() / alumina_cell().solid_volume(), 1, 1e-12);
  EXPECT_NEAR(
      other.relative_density(), alumina_cell().relative_density(), 0.02);
}

TEST(Packing, StartsWithoutAPast)
{
  const UnitCell &cell = alumina_cell();
  EXPECT_EQ(cell.reference_volume, cell.box.volume());
  EXPECT_EQ(cell.last, LastMotion{});
  EXPECT_EQ(cell.energy, EnergyAccount{});
  EXPECT_TRUE(cell.velocity.empty());
  EXPECT_TRUE(cell.spin.empty());
  EXPECT_EQ(cell.contact, alumina_request().contact);
  EXPECT_EQ(cell.materials, std::vector{alumina_request().material});
}

TEST(Packing, FrictionWhilePackingMakesItLooser)
{
  PackingRequest request = alumina_request();
  request.friction_during_packing = 0;
  const UnitCell smooth = make_packing(request);
  EXPECT_EQ(smooth.contact.friction_coefficient, 0.35);
  EXPECT_GT(smooth.relative_density(),
            alumina_cell().relative_density() + 0.02);
  // Smooth grains are isostatic when they jam: Z_m = 6, and more above.
  EXPECT_GT(measure(smooth).mechanical_coordination_number, 5.9);
}

TEST(Packing, RandomStartTouchesNothing)
{
  const UnitCell cell = random_start(alumina_request());
  EXPECT_EQ(cell.size(), 200u);
  EXPECT_NEAR(cell.relative_density(), 0.35, 1e-12);
  for (std::size_t i = 0; i < cell.size(); ++i)
    for (std::size_t j = i + 1; j < cell.size(); ++j)
      EXPECT_GT(cell.box.nearest_image(cell.place[j] - cell.place[i]).norm(),
                cell.radius[i] + cell.radius[j]);
}

TEST(Packing, RefusalsNameTheValue)
{
  const auto refusal = [](const PackingRequest &request) {
    return message_of<std::invalid_argument>(
        [&] { (void)make_packing(request); });
  };
  const auto names = [](const std::string &message, const char *part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  PackingRequest request = alumina_request();
  request.grain_count = 7;
  names(refusal(request), "grain count = 7");
  request = alumina_request();
  request.pressure = -3;
  names(refusal(request), "packing pressure = -3");
  request = alumina_request();
  request.initial_relative_density = 0.7;
  names(refusal(request), "initial relative density = 0.7");
  request = alumina_request();
  request.material.poissons_ratio = 0.5;
  names(refusal(request), "Poisson's ratio = 0.5");
  request = alumina_request();
  request.contact.friction_coefficient = std::nan("");
  names(refusal(request), "friction coefficient = nan");
  request = alumina_request();
  request.sizes.minimum_diameter = 0;
  names(refusal(request), "minimum diameter = 0");
}
} // namespace
} // namespace tamp::dem
