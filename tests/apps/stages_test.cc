// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/contact_parameters.h>
#include <apps/input/parameter_table.h>
#include <apps/input/probe_path.h>
#include <apps/input/run_input.h>
#include <apps/input/schedule.h>
#include <apps/input/units.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <tuple>
#include <unistd.h>

using namespace tamp;
using namespace tamp::apps;

using Control = fem::ComponentTarget::Control;
using StageTarget = fem::StageTarget;

TEST(PairStages, GoOnFromWhereTheLastOneEnded)
{
  const auto stages = parse_pair_stages(
      "overlap to 2 um in 100; slip_x to -1 um spin to 3 deg in 50 steps;");
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].steps, 100u);
  EXPECT_EQ(stages[1].steps, 50u);
  EXPECT_DOUBLE_EQ(stages[1].end[coordinate::overlap], 2e-6);
  EXPECT_DOUBLE_EQ(stages[1].end[coordinate::slip_x], -1e-6);
  EXPECT_NEAR(stages[1].end[coordinate::spin], 0.05235987756, 1e-11);
  EXPECT_EQ(stages[1].end[coordinate::rotation_z], 0);
}

TEST(Schedule, ReadsPressUnloadEject)
{
  const auto stages = parse_schedule(
      "press to density 0.85; unload to 5 % of peak; eject by 1 mm holding 5% "
      "of peak; hold 3 steps",
      {});
  ASSERT_EQ(stages.size(), 4u);
  EXPECT_EQ(stages[0].kind, fem::StageKind::press);
  EXPECT_EQ(stages[0].target, fem::StageTarget::density);
  EXPECT_DOUBLE_EQ(stages[0].value, 0.85);
  EXPECT_EQ(stages[1].target, fem::StageTarget::peak_share);
  EXPECT_DOUBLE_EQ(stages[1].value, 0.05);
  EXPECT_EQ(stages[2].kind, fem::StageKind::eject);
  EXPECT_DOUBLE_EQ(stages[2].value, 1e-3);
  EXPECT_DOUBLE_EQ(stages[2].hold_share, 0.05);
  EXPECT_EQ(stages[3].steps, 3u);
}

TEST(Schedule, TurnsPressureIntoForce)
{
  const auto stages =
      parse_schedule("press to pressure 50 MPa", {.punch_area = 2e-4});
  EXPECT_EQ(stages[0].target, fem::StageTarget::force);
  EXPECT_DOUBLE_EQ(stages[0].value, 1e4);
}

TEST(Schedule, AnEjectionThatSaysNothingHoldsTheDefault)
{
  const auto stages =
      parse_schedule("eject to rim", {.default_hold_share = 0.03});
  EXPECT_EQ(stages[0].target, fem::StageTarget::rim);
  EXPECT_DOUBLE_EQ(stages[0].hold_share, 0.03);
}

TEST(Schedule, ReadsWhoPresses)
{
  const auto stages = parse_schedule("press upper to density 0.7; press lower "
                                     "to displacement 1 mm; press both "
                                     "to force 2 kN; press to density 0.8",
                                     {});
  ASSERT_EQ(stages.size(), 4u);
  EXPECT_EQ(stages[0].pressing, fem::Pressing::upper);
  EXPECT_EQ(stages[1].pressing, fem::Pressing::lower);
  EXPECT_EQ(stages[1].target, StageTarget::displacement);
  EXPECT_EQ(stages[2].pressing, fem::Pressing::both);
  EXPECT_DOUBLE_EQ(stages[2].value, 2e3);
  EXPECT_EQ(stages[3].pressing, fem::Pressing::upper);
}

TEST(Schedule, ReadsUnloadingToNothing)
{
  for (const char *text :
       {"unload to nothing", "unload to force 0 N", "unload to 0 % of peak"})
    EXPECT_TRUE(parse_schedule(text, {}).at(0).frees()) << text;
  EXPECT_FALSE(parse_schedule("unload to 1 % of peak", {}).at(0).frees());
  EXPECT_FALSE(parse_schedule("unload by 1 um", {}).at(0).frees());
}

TEST(Schedule, ReadsHowACompactLeavesTheDie)
{
  const fem::Ejection push = fem::Ejection::push,
                      withdrawal = fem::Ejection::withdrawal;
  const std::tuple<const char *, StageTarget, double, fem::Ejection> cases[] = {
      {"eject to rim", StageTarget::rim, 0.03, push},
      {"eject to out freely", StageTarget::out, 0, push},
      {"eject to out holding 7 % of peak", StageTarget::out, 0.07, push},
      {"eject by 2 mm by withdrawal",
       StageTarget::displacement,
       0.03,
       withdrawal},
      {"eject to rim freely by withdrawal", StageTarget::rim, 0, withdrawal},
      {"eject to rim by withdrawal holding 5 % of peak",
       StageTarget::rim,
       0.05,
       withdrawal}};
  for (const auto &[text, target, share, way] : cases) {
    const auto stages = parse_schedule(text, {.default_hold_share = 0.03});
    ASSERT_EQ(stages.size(), 1u) << text;
    EXPECT_EQ(stages[0].target, target) << text;
    EXPECT_DOUBLE_EQ(stages[0].hold_share, share) << text;
    EXPECT_EQ(stages[0].ejection, way) << text;
  }
}

TEST(Schedule, UnitCellsStayLoadedAndInTheDie)
{
  for (const char *text : {"press to density 0.8; unload to nothing",
                           "press to density 0.8; unload to force 0 N",
                           "press to density 0.8; eject to rim freely",
                           "press to density 0.8; eject to out"}) {
    ParameterTable table;
    declare_parameters(table);
    table.set(std::string("Schedule/Stages = ") + text);
    table.set("Schedule/Floating die = true");
    EXPECT_THROW(read_input(table, Need::die), InputError) << text;
    table.set("Material/Type = drucker-prager cap");
    const RunInput input = read_input(table, Need::die);
    EXPECT_EQ(input.die.stages.size(), 2u) << text;
    EXPECT_TRUE(input.die.floating_die);
  }
}

TEST(Schedule, NamesTheNearestWord)
{
  const std::pair<const char *, const char *> cases[] = {
      {"press uper to density 0.8", "nearest: 'upper'"},
      {"unload to nothin", "nearest: 'nothing'"},
      {"eject to outt", "nearest: 'out'"},
      {"eject to rim frely", "nearest: 'freely'"},
      {"eject to rim by withdraw", "'withdrawal'"}};
  for (const auto &[text, words] : cases)
    try {
      parse_schedule(text, {});
      ADD_FAILURE() << text;
    } catch (const InputError &error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos)
          << error.what();
    }
}

TEST(Schedule, NamesTheWordThatIsWrong)
{
  for (const char *text : {"",
                           "pres to density 0.8",
                           "press to densty 0.8",
                           "press to density 8 mm",
                           "press to density 0.8 please",
                           "unload to 5 %",
                           "eject to 1 mm",
                           "hold 0 steps",
                           "press upper lower to density 0.8",
                           "unload to force -1 N",
                           "eject to rim freely holding 5 % of peak",
                           "eject to rim by withdrawal by withdrawal",
                           "eject to rim freely by withdrawal freely"})
    EXPECT_THROW(parse_schedule(text, {}), InputError) << text;
}

TEST(ProbePath, CompressionBecomesNegativeStrain)
{
  const auto path = parse_path("uniaxial to strain 0.15", {});
  ASSERT_EQ(path.stages.size(), 1u);
  const auto &components = path.stages[0].stage.components;
  EXPECT_EQ(components[2].control, Control::strain);
  EXPECT_DOUBLE_EQ(components[2].value, -0.15);
  EXPECT_FALSE(components[2].relative);
  for (const unsigned other : {0u, 1u, 3u, 4u, 5u}) {
    EXPECT_TRUE(components[other].relative);
    EXPECT_DOUBLE_EQ(components[other].value, 0);
  }
}

TEST(ProbePath, UnloadingEndsAtAShareOfThePeak)
{
  const auto path =
      parse_path("uniaxial to stress 10 MPa; unload to 1 % of peak", {});
  ASSERT_EQ(path.stages.size(), 2u);
  EXPECT_DOUBLE_EQ(path.stages[0].stage.until_stress, -10e6);
  EXPECT_FALSE(path.stages[0].stage.until_above);
  EXPECT_DOUBLE_EQ(path.stages[1].peak_share, 0.01);
  EXPECT_TRUE(path.stages[1].stage.until_above);
}

TEST(ProbePath, HoldsLateralPressureInATriaxialTest)
{
  const auto path = parse_path("triaxial to strain 0.2 at pressure 1 MPa", {});
  const auto &components = path.stages[0].stage.components;
  EXPECT_EQ(components[0].control, Control::stress);
  EXPECT_DOUBLE_EQ(components[0].value, -1e6);
  EXPECT_DOUBLE_EQ(components[2].value, -0.2);
}

TEST(ProbePath, ReadsComponents)
{
  const auto path =
      parse_path("components zz strain 0.1, xx stress 100 kPa", {});
  const auto &components = path.stages[0].stage.components;
  EXPECT_DOUBLE_EQ(components[2].value, -0.1);
  EXPECT_EQ(components[0].control, Control::stress);
  EXPECT_DOUBLE_EQ(components[0].value, -1e5);
  EXPECT_TRUE(components[1].relative);
}

TEST(ProbePath, SimpleShearIsAPathOfGradients)
{
  // Compression is positive: a positive shear is F_xz < 0.
  const auto path = parse_path("simple shear to strain 0.1", {2e-2, 1e-3});
  const auto &gradients = path.stages[0].stage.gradients;
  ASSERT_EQ(gradients.size(), 3u); // strains, half the shear, up to 2e-2
  EXPECT_DOUBLE_EQ(gradients[0][0][2], -0.1 / 3);
  EXPECT_EQ(gradients[2][0][2], -0.1);
  EXPECT_EQ(determinant(gradients[2]), 1);
}

TEST(ProbePath, ConstantPressureShearHoldsAllNormalStresses)
{
  const auto path =
      parse_path("constant-p shear to strain 0.1 at pressure 1 MPa", {});
  const auto &components = path.stages[0].stage.components;
  for (const unsigned normal : {0u, 1u, 2u}) {
    EXPECT_EQ(components[normal].control, Control::stress);
    EXPECT_DOUBLE_EQ(components[normal].value, -1e6);
  }
  EXPECT_DOUBLE_EQ(components[4].value, -0.1);
  EXPECT_TRUE(components[3].relative);
}

TEST(ProbePath, StagesEndAtADensity)
{
  const auto path =
      parse_path("isotropic to density 0.7; uniaxial to density 0.8", {});
  fem::PathStage stage = path.stages[0].stage;
  aim_at_density(path.stages[0], 0.6, stage);
  // D = D_0 / det F.
  for (const unsigned i : {0u, 1u, 2u}) {
    EXPECT_TRUE(stage.components[i].relative);
    EXPECT_NEAR(stage.components[i].value,
                std::log(0.6 / 0.7) / 3,
                1e-15); // rounding
  }
  stage = path.stages[1].stage;
  aim_at_density(path.stages[1], 0.7, stage);
  EXPECT_NEAR(stage.components[2].value, std::log(0.7 / 0.8), 1e-15);
  EXPECT_EQ(stage.components[0].value, 0);
  EXPECT_THROW(aim_at_density(path.stages[1], 0.8, stage), InputError);
  EXPECT_THROW(parse_path("uniaxial to density 1.2", {}), InputError);
}

TEST(ProbePath, StrainsMayCountFromTheStage)
{
  const auto path =
      parse_path("triaxial by strain 0.1 at pressure 1 MPa; "
                 "constant-p compression by strain 0.2 at pressure 1 MPa",
                 {});
  const auto &triaxial = path.stages[0].stage.components;
  EXPECT_TRUE(triaxial[2].relative);
  EXPECT_DOUBLE_EQ(triaxial[2].value, -0.1);
  // xx and yy add half of zz: three halves of the mean stress.
  const fem::PathStage &stage = path.stages[1].stage;
  EXPECT_EQ(stage.axial_share, 0.5);
  EXPECT_TRUE(stage.components[2].relative);
  for (const unsigned i : {0u, 1u}) {
    EXPECT_EQ(stage.components[i].control, Control::stress);
    EXPECT_DOUBLE_EQ(stage.components[i].value, -1.5e6);
  }
}

TEST(ProbePath, AStageMayNameAFileOfGradients)
{
  const auto path = parse_path("hold 1 step; csv my path, new.csv", {});
  ASSERT_EQ(path.stages.size(), 2u);
  EXPECT_EQ(path.stages[1].file, "my path, new.csv");
  EXPECT_TRUE(path.stages[0].file.empty());
}

class GradientFile : public testing::Test
{
protected:
  GradientFile()
      : folder_(std::filesystem::temp_directory_path() /
                ("tamp_gradients_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
  }
  ~GradientFile() override { std::filesystem::remove_all(folder_); }

  ProbePath read(const std::string &stages, const std::string &text)
  {
    std::ofstream(folder_ / "path.csv") << text;
    ProbePath path = parse_path(stages, {});
    read_files(path, folder_);
    return path;
  }
  std::filesystem::path folder_;
};

TEST_F(GradientFile, ColumnsAreFoundByNameBesidesATime)
{
  const std::string text =
      "# drawn by hand\ntime[s],F_xx,F_xy,F_xz,F_yx,F_yy,F_yz,F_zx,F_zy,F_zz\n"
      "0,1,0,0,0,1,0,0,0,1\n1,1,0,0.2,0,1,0,0,0,0.9\n";
  const auto path = read("hold 1 step; csv path.csv", text);
  const auto &gradients = path.stages[1].stage.gradients;
  ASSERT_EQ(gradients.size(), 2u);
  EXPECT_EQ(gradients[1][0][2], 0.2);
  EXPECT_EQ(gradients[1][2][2], 0.9);
  EXPECT_TRUE(path.increments.empty());
}

TEST_F(GradientFile, RelativeGradientsMultiplyUpInAStage)
{
  const std::string header =
      "relative_F_xx,relative_F_xy,relative_F_xz,relative_F_yx,relative_F_yy,"
      "relative_F_yz,relative_F_zx,relative_F_zy,relative_F_zz\n";
  const std::string row = "1,0,0,0,1,0,0,0,0.5\n";
  const auto path = read("csv path.csv; hold 1 step", header + row + row);
  EXPECT_EQ(path.stages[0].stage.gradients.at(1)[2][2], 0.25);
  const auto alone = read("csv path.csv", header + row + row);
  EXPECT_EQ(alone.increments.size(), 2u); // replayed as they are
}

TEST_F(GradientFile, WhatIsWrongIsNamedWithItsLine)
{
  const auto complaint = [&](const std::string &text) {
    try {
      read("csv path.csv", text);
    } catch (const InputError &error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string good = "1,0,0,0,1,0,0,0,1\n";
  for (const char *bad :
       {"1,0,0\n", "1,0,0,0,one,0,0,0,1\n", "1,0,0,0,1,0,0,0,-1\n"})
    EXPECT_NE(complaint(good + bad).find("path.csv:2: "), std::string::npos)
        << bad;
  EXPECT_NE(complaint("F_xx,F_xy\n1,0\n").find("path.csv:1: "),
            std::string::npos);
  EXPECT_NE(complaint("# nothing\n").find("no deformation gradient"),
            std::string::npos);
}

TEST(ProbePath, NamesTheWordThatIsWrong)
{
  for (const char *text : {"",
                           "uniaxal to strain 0.1",
                           "uniaxial strain 0.1",
                           "uniaxial to strain 1 MPa",
                           "unload to 120 % of peak",
                           "hold 2.5 steps",
                           "simple to strain 1",
                           "constant-p shear to strain 0.1",
                           "csv"})
    EXPECT_THROW(parse_path(text, {}), InputError) << text;
}
