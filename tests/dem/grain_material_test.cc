// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_material.h>

#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
TEST(PairMaterial, OfOneMaterialIsThatOfEqualSpheres)
{
  const GrainMaterial material{70e9, 0.3, 2650, 0.5e9};
  const PairMaterial pair = pair_material(material, material);
  const double shear = 70e9 / 2.6;
  EXPECT_NEAR(pair.effective_modulus, 70e9 / (2 * 0.91), 1);
  EXPECT_NEAR(pair.effective_shear_modulus, shear / (2 * 1.7), 1);
  EXPECT_EQ(pair.limiting_pressure, 0.5e9);
  // k_t / k_n of Mindlin: 2 (1 - nu) / (2 - nu).
  EXPECT_NEAR(4 * pair.effective_shear_modulus / pair.effective_modulus,
              2 * 0.7 / 1.7,
              1e-12);
}

TEST(PairMaterial, ComplianceIsTheMeanOfBoth)
{
  constexpr double round_off = 1e-14;
  const GrainMaterial steel{210e9, 0.28, 7800, 2e9};
  const GrainMaterial salt{30e9, 0.25, 2160, 0.2e9};
  const PairMaterial mixed = pair_material(steel, salt);
  const PairMaterial hard = pair_material(steel, steel);
  const PairMaterial soft = pair_material(salt, salt);
  EXPECT_NEAR(mixed.effective_modulus / 2 *
                  (1 / hard.effective_modulus + 1 / soft.effective_modulus),
              1,
              round_off);
  EXPECT_NEAR(
      mixed.effective_shear_modulus / 2 *
          (1 / hard.effective_shear_modulus + 1 / soft.effective_shear_modulus),
      1,
      round_off);
}

TEST(PairMaterial, SofterMaterialYieldsWhicheverComesFirst)
{
  const GrainMaterial hard{70e9, 0.3, 2650, 2e9}, soft{70e9, 0.3, 2650, 2e8};
  EXPECT_EQ(pair_material(hard, soft).limiting_pressure, 2e8);
  EXPECT_EQ(pair_material(soft, hard).limiting_pressure, 2e8);
}

TEST(GrainMaterial, RefusesWhatIsNotPhysical)
{
  EXPECT_THROW((GrainMaterial{-1, .3, 2650}.check()), std::invalid_argument);
  EXPECT_THROW((GrainMaterial{7e10, .5, 2650}.check()), std::invalid_argument);
  EXPECT_THROW((GrainMaterial{7e10, .3, 0}.check()), std::invalid_argument);
  EXPECT_THROW((GrainMaterial{7e10, .3, 1, 0}.check()), std::invalid_argument);
  EXPECT_NO_THROW((GrainMaterial{7e10, .3, 2650, 1e8}.check()));
}

TEST(ContactModel, RefusesWhatIsNotPhysical)
{
  EXPECT_NO_THROW(ContactModel{}.check());
  const auto refused = [](double ContactModel::*constant, double value) {
    ContactModel contact;
    contact.*constant = value;
    EXPECT_THROW(contact.check(), std::invalid_argument) << value;
  };
  refused(&ContactModel::friction_coefficient, -0.1);
  refused(&ContactModel::work_of_adhesion, -1);
  refused(&ContactModel::rolling_friction_coefficient, -0.1);
  refused(&ContactModel::restitution_coefficient, 0);
  refused(&ContactModel::restitution_coefficient, 1.1);
}
} // namespace
} // namespace tamp::dem
