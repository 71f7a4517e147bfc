// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/modified_cam_clay.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace tamp::fem
{
namespace
{
template <class Law>
class LawVariables : public testing::Test
{
protected:
  ContinuumPoints<Law> points{Law(), 1};

  /// All axes get this logarithmic strain; the density that comes of it.
  double strain(double value)
  {
    Deformation deformation;
    for (unsigned i = 0; i < 3; ++i)
      deformation.relative_F[i][i] = std::exp(value);
    Response response;
    points.evaluate({&deformation, 1}, Want::stress, {&response, 1});
    EXPECT_NE(response.status, Status::failed);
    points.commit();
    return response.relative_density;
  }

  std::map<std::string, double> variables() const
  {
    const auto names = points.variables();
    std::vector<double> values(names.size(), std::nan(""));
    points.variables_of(0, values);
    std::map<std::string, double> result;
    for (std::size_t i = 0; i < names.size(); ++i)
      result[names[i].name] = values[i];
    EXPECT_EQ(result.size(), names.size());
    return result;
  }

  static double flows(const std::map<std::string, double> &variables)
  {
    const auto yielding = variables.find("yielding");
    return yielding != variables.end() ? yielding->second
                                       : variables.at("active_surface");
  }
};

using Laws = testing::Types<DruckerPragerCap, ModifiedCamClay, FkmGurson>;
TYPED_TEST_SUITE(LawVariables, Laws);
} // namespace

TYPED_TEST(LawVariables, PlasticStrainIsWhatUnloadingLeaves)
{
  const double start = this->variables().at("hydrostatic_yield_pressure");
  EXPECT_EQ(this->variables().at("plastic_volumetric_strain"), 0);
  EXPECT_EQ(this->flows(this->variables()), 0);
  const double first = this->strain(0);
  double density = first;
  for (unsigned i = 0; i < 20; ++i)
    density = this->strain(-5e-3);
  const auto pressed = this->variables();
  const double total = std::log(density / first);
  const double plastic = pressed.at("plastic_volumetric_strain");
  // Compaction is positive; what is not plastic is elastic. Cam-Clay is soft
  // before it yields.
  EXPECT_NEAR(total, 0.3, 1e-12);
  EXPECT_LT(plastic, total);
  EXPECT_GT(plastic, 0.4 * total);
  EXPECT_GT(pressed.at("hydrostatic_yield_pressure"), start);
  EXPECT_GT(this->flows(pressed), 0);
  // An isotropic path shears nothing, but for rounding.
  EXPECT_NEAR(pressed.at("plastic_shear_strain"), 0, 1e-9);

  this->strain(1e-5);
  const auto unloaded = this->variables();
  EXPECT_EQ(unloaded.at("plastic_volumetric_strain"), plastic);
  EXPECT_EQ(this->flows(unloaded), 0);
}

TYPED_TEST(LawVariables, EachHasAUnitAndAMeaning)
{
  for (const Variable &variable : this->points.variables()) {
    EXPECT_TRUE(variable.unit == "-" || variable.unit == "Pa") << variable.name;
    EXPECT_FALSE(variable.meaning.empty()) << variable.name;
    EXPECT_TRUE(std::ranges::all_of(variable.name, [](char letter) {
      return letter == '_' || (letter >= 'a' && letter <= 'z');
    })) << variable.name;
  }
}
} // namespace tamp::fem
