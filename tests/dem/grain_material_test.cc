// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_material.h>

#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
TEST(GrainMaterial, EffectiveModuliAreThoseOfEqualSpheres)
{
  const GrainMaterial material{70e9, 0.3, 2650};
  const double shear = 70e9 / 2.6;
  EXPECT_NEAR(material.effective_modulus(), 70e9 / (2 * 0.91), 1);
  EXPECT_NEAR(material.effective_shear_modulus(), shear / (2 * 1.7), 1);
  // k_t / k_n of Mindlin: 2 (1 - nu) / (2 - nu).
  EXPECT_NEAR(4 * material.effective_shear_modulus() /
                  material.effective_modulus(),
              2 * 0.7 / 1.7,
              1e-12);
}

TEST(GrainMaterial, RefusesWhatIsNotPhysical)
{
  EXPECT_THROW((GrainMaterial{-1, .3, 2650}.check()), std::invalid_argument);
  EXPECT_THROW((GrainMaterial{7e10, .5, 2650}.check()), std::invalid_argument);
  EXPECT_THROW((GrainMaterial{7e10, .3, 0}.check()), std::invalid_argument);
  ContactModel contact;
  contact.friction_coefficient = -0.1;
  EXPECT_THROW(contact.check(), std::invalid_argument);
  contact = {};
  contact.limiting_pressure = 0;
  EXPECT_THROW(contact.check(), std::invalid_argument);
  contact.normal_law = NormalLaw::hertz;
  EXPECT_NO_THROW(contact.check());
}
} // namespace
} // namespace tamp::dem
