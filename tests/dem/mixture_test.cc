// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/dynamics.h>
#include <dem/measures.h>
#include <dem/motion.h>
#include <dem/packing.h>
#include <dem/servo.h>
#include <dem/time_step.h>
#include <dem/unit_cell.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace tamp::dem
{
namespace
{
using test::alumina_cell;
using test::alumina_request;
using test::message_of;

/// Granules with a fifth, by number, of other, larger grains.
PackingRequest mixture_request()
{
  PackingRequest request = alumina_request();
  GrainPopulation binder;
  binder.number_share = 0.2;
  binder.sizes.minimum_diameter = 700e-6;
  binder.sizes.maximum_diameter = 800e-6;
  binder.material = {0.5e9, 0.4, 1200, 10e6};
  request.others = {binder};
  return request;
}

TEST(Mixture, HasItsSharesSizesAndMaterials)
{
  const PackingRequest request = mixture_request();
  const UnitCell cell = make_packing(request);
  ASSERT_EQ(cell.species.size(), 200u);
  EXPECT_EQ(std::ranges::count(cell.species, 1), 40);
  EXPECT_EQ(cell.materials.at(0), request.material);
  EXPECT_EQ(cell.materials.at(1), request.others[0].material);
  for (std::size_t i = 0; i < cell.size(); ++i) {
    EXPECT_EQ(cell.radius[i] > 340e-6, cell.species[i] == 1);
    EXPECT_EQ(cell.material_of(i).density, cell.species[i] ? 1200 : 2000);
  }
}

TEST(Mixture, IsAPackingAsAnyOther)
{
  UnitCell cell = make_packing(mixture_request());
  EXPECT_NEAR(-measure(cell).stress.trace() / 3, 0.5e6, 0.01 * 0.5e6);
  const CellAnswer answer = deform(cell, Stretch::Identity(), {});
  EXPECT_EQ(answer.outcome, Outcome::settled);
  EXPECT_EQ(make_packing(mixture_request()), make_packing(mixture_request()));
}

TEST(Mixture, OfOneMaterialAnswersAsThatMaterial)
{
  UnitCell pure = alumina_cell(), mixed = pure;
  mixed.materials.push_back(pure.materials[0]);
  for (std::size_t i = 0; i < mixed.size(); ++i)
    mixed.species.push_back(i % 3 == 0);
  const Stretch stretch = test::uniaxial(-1e-3);
  const CellAnswer a = deform(pure, stretch, {}),
                   b = deform(mixed, stretch, {});
  // Sums in another order: rounding, which the relaxation may amplify up to
  // its tolerance.
  EXPECT_LT((a.stress - b.stress).norm(), 1e-3 * a.stress.norm());
  EXPECT_EQ(a.outcome, b.outcome);
}

TEST(Mixture, YieldsFirstWhereTheSofterMaterialTouches)
{
  PackingRequest request = mixture_request();
  request.material.limiting_pressure = 500e6; // against 10 MPa
  const UnitCell cell = make_packing(request);
  std::size_t hard = 0, hard_plastic = 0, soft = 0, soft_plastic = 0;
  for (const ContactForce &contact : contact_forces(cell)) {
    const bool touches_soft =
        cell.species[contact.pair.first] || cell.species[contact.pair.second];
    (touches_soft ? soft : hard) += 1;
    (touches_soft ? soft_plastic : hard_plastic) += contact.plastic;
  }
  ASSERT_GT(hard, 50u);
  ASSERT_GT(soft, 50u);
  // At 0.5 MPa pressures in contacts are some tens of megapascals.
  EXPECT_GT(soft_plastic, 0.9 * double(soft));
  EXPECT_LT(hard_plastic, 0.1 * double(hard));
}

/// The same grains with the two materials listed the other way round.
UnitCell listed_the_other_way(UnitCell cell)
{
  std::swap(cell.materials.at(0), cell.materials.at(1));
  for (std::uint8_t &species : cell.species)
    species = 1 - species;
  return cell;
}

/// A small light grain and a large heavy one that do not touch.
UnitCell two_grains()
{
  UnitCell cell;
  cell.materials = {{70e9, 0.3, 2650, 1.2e9}, {210e9, 0.28, 7800, 0.5e9}};
  cell.species = {0, 1};
  cell.radius = {50e-6, 100e-6};
  cell.place = {Vector3(0.25, 0.5, 0.5), Vector3(0.75, 0.5, 0.5)};
  cell.box.h = 1e-3 * Matrix3::Identity();
  return cell;
}

// Exact formulae, up to rounding.
constexpr double rounding = 1e-12;

TEST(Mixture, DynamicNumbersAreThoseOfAllItsGrains)
{
  // Volumes 1 : 8, mean density (2650 + 8 x 7800) / 9; p_y the smaller one,
  // radius the smallest, diameter the mean.
  const double density = 1e12 * (2650 + 8 * 7800.0) / 9;
  const Dynamics settings; // 1e-5 per second, density scaled by 1e12
  for (const UnitCell &cell :
       {two_grains(), listed_the_other_way(two_grains())}) {
    const DynamicMeasures found = measure_dynamics(cell, settings, 100e3);
    EXPECT_NEAR(found.inertial_number /
                    (1e-5 * 150e-6 * std::sqrt(density / 100e3)),
                1,
                rounding);
    EXPECT_NEAR(found.scaling_number /
                    (1e-5 * 50e-6 * std::sqrt(density / 0.5e9)),
                1,
                rounding);
  }
}

TEST(Mixture, TimeStepIsThatOfItsQuickestGrain)
{
  const Dynamics settings;
  const double quickest = rayleigh_time_step(
      two_grains().materials[0], 50e-6, settings.density_scaling);
  ASSERT_LT(quickest,
            rayleigh_time_step(
                two_grains().materials[1], 100e-6, settings.density_scaling));
  for (UnitCell cell : {two_grains(), listed_the_other_way(two_grains())})
    EXPECT_NEAR(start_motion(cell, settings, {})->time_step() /
                    (settings.time_step_fraction * quickest),
                1,
                rounding);
}

TEST(Mixture, MovesAlikeInEitherOrderOfItsMaterials)
{
  const UnitCell start = make_packing(mixture_request());
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = 1e-3;
  const auto compressed = [&](UnitCell cell) {
    return deform(cell, test::uniaxial(-1e-3), driving);
  };
  const auto squeezed = [&](UnitCell cell) {
    const CellAnswer answer =
        servo_to_pressure(cell, {.pressure = 0.6e6}, driving.dynamics);
    EXPECT_EQ(answer.outcome, Outcome::settled);
    return cell.relative_density();
  };
  const CellAnswer one = compressed(start),
                   other = compressed(listed_the_other_way(start));
  EXPECT_EQ(one.evaluations, other.evaluations);
  // Sums in another order: rounding, which some thousand steps of sliding
  // contacts may amplify.
  constexpr double amplified = 1e-6;
  EXPECT_LT((one.stress - other.stress).norm(), amplified * one.stress.norm());
  EXPECT_NEAR(
      squeezed(start) / squeezed(listed_the_other_way(start)), 1, amplified);
}

TEST(Mixture, RefusalsNameTheValue)
{
  const auto names = [](const PackingRequest &request, const char *part) {
    const std::string message =
        message_of<std::invalid_argument>([&] { (void)make_packing(request); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  PackingRequest request = mixture_request();
  request.others[0].number_share = 0;
  names(request, "number share = 0");
  request.others[0].number_share = 0.6;
  request.others.push_back(request.others[0]);
  names(request, "sum of the number shares of further grains = 1.2");
  request = mixture_request();
  request.others[0].material.youngs_modulus = -1;
  names(request, "Young's modulus = -1");
  request = mixture_request();
  request.others[0].sizes.minimum_diameter = -1;
  names(request, "minimum diameter = -1");
}
} // namespace
} // namespace tamp::dem
