// SPDX-License-Identifier: BSD-3-Clause
#include <apps/nearest_name.h>
#include <apps/parameter_table.h>
#include <apps/powder.h>
#include <apps/run_input.h>
#include <fem/kinematics.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

using namespace tamp::apps;

namespace
{
class Parameters : public testing::Test
{
protected:
  Parameters()
      : folder_(std::filesystem::temp_directory_path() /
                ("tamp_parameters_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
    declare_parameters(table);
  }
  ~Parameters() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string &name, const std::string &text)
  {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  std::string message(const std::string &text)
  {
    try {
      table.read(file("input.prm", text));
    } catch (const InputError &error) {
      return error.what();
    }
    return {};
  }

  ParameterTable table;

private:
  std::filesystem::path folder_;
};
} // namespace

TEST_F(Parameters, DefaultsWork)
{
  const RunInput input = read_input(table, Need::everything);
  EXPECT_NO_THROW(input.material.packing.check());
  EXPECT_NO_THROW(input.material.driving.check());
  EXPECT_NO_THROW(input.die.check());
}

TEST_F(Parameters, FileBeatsDefaultAndSetBeatsFile)
{
  table.read(file("input.prm",
                  "subsection Contact # a remark\n  set Limiting contact "
                  "pressure = \\\n 50 MPa\nend\n"));
  EXPECT_DOUBLE_EQ(table.number("Contact/Limiting contact pressure"), 50e6);
  table.set("Contact/Limiting contact pressure = 20 MPa");
  EXPECT_DOUBLE_EQ(table.number("Contact/Limiting contact pressure"), 20e6);
}

TEST_F(Parameters, IncludedFilesKeepTheirLines)
{
  file("grains.prm", "subsection Grains\n  set Cont = 5\nend\n");
  const std::string text = message("include grains.prm\n");
  EXPECT_NE(text.find("grains.prm:2"), std::string::npos) << text;
  EXPECT_NE(text.find("'Count'"), std::string::npos) << text;
}

TEST_F(Parameters, JsonIsRead)
{
  table.read(file("input.json",
                  R"({"Grains": {"Count": 300, "Young's modulus": "1 GPa"},
                      "Die": {"Elements": [2, 3]}})"));
  EXPECT_EQ(table.whole("Grains/Count"), 300);
  EXPECT_DOUBLE_EQ(table.number("Grains/Young's modulus"), 1e9);
  EXPECT_EQ(table.indices("Die/Elements"), (std::vector<std::size_t>{2, 3}));
}

TEST_F(Parameters, TheEchoReadsBackExactly)
{
  table.set("Grains/Minimum diameter = 450 um");
  table.set("Material/Drucker-Prager cap/Friction angle = 54.35, 68.78, 68.34, "
            "68.03, 68.07, 67.42, 66.51, 66.32, 65.69, 63.41 deg");
  std::ostringstream echo;
  table.echo(echo);
  ParameterTable again;
  declare_parameters(again);
  again.read(file("echo.prm", echo.str()));
  EXPECT_EQ(again.number("Grains/Minimum diameter"),
            table.number("Grains/Minimum diameter"));
  EXPECT_EQ(again.numbers("Material/Drucker-Prager cap/Friction angle"),
            table.numbers("Material/Drucker-Prager cap/Friction angle"));
}

TEST_F(Parameters, AUnitAfterTheLastValueHoldsForAll)
{
  table.set("Material/Elastic/Young's modulus = 1, 2 GPa, 3 MPa");
  const auto values = table.numbers("Material/Elastic/Young's modulus");
  ASSERT_EQ(values.size(), 3u);
  EXPECT_DOUBLE_EQ(values[0], 1e6);
  EXPECT_DOUBLE_EQ(values[1], 2e9);
  EXPECT_DOUBLE_EQ(values[2], 3e6);
}

TEST_F(Parameters, AFreeEjectionOfCellsIsRefusedWithTheReason)
{
  table.set("Schedule/Stages = press to density 0.8; eject to rim holding 0 % "
            "of peak");
  EXPECT_THROW(read_input(table, Need::die), InputError);
  table.set("Material/Type = drucker-prager cap");
  EXPECT_NO_THROW(read_input(table, Need::die));
}

TEST_F(Parameters, EveryContinuumLawIsTaken)
{
  for (const char *type :
       {"elastic", "drucker-prager cap", "modified cam-clay", "fkm-gurson"}) {
    table.set(std::string("Material/Type = ") + type);
    for (const Need need : {Need::probe, Need::die}) {
      const auto material = read_input(table, need).material;
      EXPECT_EQ(make_material(material, 2).points->size(), 2u) << type;
      EXPECT_EQ(make_material(material, 2).cells, nullptr) << type;
    }
  }
}

TEST_F(Parameters, AnUnevenFillingGivesEveryPointItsDensity)
{
  table.set("Die/Initial density = 0.36 - 2*z + if(r < 0.003, 0.01, 0)");
  for (const char *type : {"elastic", "drucker-prager cap"}) {
    table.set(std::string("Material/Type = ") + type);
    const RunInput input = read_input(table, Need::die);
    const auto places = tamp::fem::point_positions(input.mesh.mesh);
    auto points = make_material(input.material, places.size()).points;
    std::vector<tamp::fem::Deformation> still(places.size());
    for (auto &deformation : still)
      for (unsigned i = 0; i < 3; ++i)
        deformation.relative_F[i][i] = 1;
    std::vector<tamp::fem::Response> answers(places.size());
    points->evaluate(still, tamp::fem::Want::stress, answers);
    for (std::size_t i = 0; i < places.size(); ++i)
      // Rounding of a logarithm and back.
      EXPECT_NEAR(answers[i].relative_density,
                  0.36 - 2 * places[i][2] + (places[i][0] < 3e-3 ? 0.01 : 0),
                  1e-14);
  }
}

TEST_F(Parameters, AnUnevenFillingThatCannotBeIsRefused)
{
  table.set("Material/Type = elastic");
  for (const char *formula : {"0.3 + ", "0.3 + w", "0.3 - 100*z", "1.2"}) {
    table.set(std::string("Die/Initial density = ") + formula);
    EXPECT_THROW(read_input(table, Need::die), InputError) << formula;
  }
  table.set("Die/Initial density = 0.6");
  EXPECT_NO_THROW(read_input(table, Need::die));
  table.set("Material/Type = modified cam-clay");
  EXPECT_THROW(read_input(table, Need::die), InputError);
  table.set("Material/Type = unit cell");
  EXPECT_NO_THROW(read_input(table, Need::die));
  table.set("Packing/Same at all points = true");
  EXPECT_THROW(read_input(table, Need::die), InputError);
}

TEST_F(Parameters, DefaultsOfLawsAreThoseOfTheLaws)
{
  const auto material = read_input(table, Need::probe).material;
  const tamp::fem::ModifiedCamClayParameters clay;
  EXPECT_EQ(material.cam_clay.initial_relative_density,
            clay.initial_relative_density);
  EXPECT_DOUBLE_EQ(material.cam_clay.initial_yield_pressure,
                   clay.initial_yield_pressure);
  EXPECT_EQ(material.cam_clay.critical_state_slope, clay.critical_state_slope);
  EXPECT_EQ(material.cam_clay.compression_index, clay.compression_index);
  EXPECT_EQ(material.cam_clay.swelling_index, clay.swelling_index);
  EXPECT_EQ(material.cam_clay.poissons_ratio, clay.poissons_ratio);
  EXPECT_DOUBLE_EQ(material.cam_clay.floor_pressure, clay.floor_pressure);
  EXPECT_EQ(material.cam_clay.integration_tolerance,
            clay.integration_tolerance);
  const tamp::fem::FkmGursonParameters metal;
  EXPECT_EQ(material.fkm_gurson.initial_relative_density,
            metal.initial_relative_density);
  EXPECT_EQ(material.fkm_gurson.random_packing_density,
            metal.random_packing_density);
  EXPECT_DOUBLE_EQ(material.fkm_gurson.solid_yield_stress,
                   metal.solid_yield_stress);
  EXPECT_DOUBLE_EQ(material.fkm_gurson.solid_youngs_modulus,
                   metal.solid_youngs_modulus);
  EXPECT_EQ(material.fkm_gurson.solid_poissons_ratio,
            metal.solid_poissons_ratio);
  EXPECT_EQ(material.fkm_gurson.elastic_exponent, metal.elastic_exponent);
  EXPECT_EQ(material.fkm_gurson.yield_floor, metal.yield_floor);
  EXPECT_EQ(material.fkm_gurson.vertex_rounding, metal.vertex_rounding);
  EXPECT_EQ(material.fkm_gurson.integration_tolerance,
            metal.integration_tolerance);
}

TEST_F(Parameters, APowderFillsWhatIsNotGiven)
{
  const std::string section = "Material/Drucker-Prager cap/";
  table.set(section + "Powder = agcusnin");
  table.set(section + "Transition = 0.05");
  take_powder(table);
  const auto pressure = table.numbers(section + "Hydrostatic yield pressure");
  ASSERT_EQ(pressure.size(), 9u);
  EXPECT_DOUBLE_EQ(pressure[0], 0.433e6);
  EXPECT_DOUBLE_EQ(pressure[8], 216e6);
  const auto density = table.numbers(section + "Hardening densities");
  EXPECT_DOUBLE_EQ(density[8], 0.42 * std::exp(0.795));
  EXPECT_DOUBLE_EQ(table.numbers(section + "Cohesion")[0], 24180.7);
  EXPECT_DOUBLE_EQ(table.number(section + "Initial relative density"), 0.42);
  EXPECT_DOUBLE_EQ(table.number(section + "Transition"), 0.05); // given
  table.set("Material/Type = drucker-prager cap");
  const RunInput input = read_input(table, Need::probe);
  EXPECT_EQ(input.material.cap.hydrostatic_yield, pressure);
  EXPECT_EQ(input.material.cap.dilation, tamp::fem::Dilation::bounded);
}

TEST_F(Parameters, TheEchoOfAPowderIsItsTables)
{
  const std::string section = "Material/Drucker-Prager cap/";
  table.set(section + "Powder = agcusnin");
  take_powder(table);
  std::ostringstream echo;
  table.echo(echo);
  ParameterTable again;
  declare_parameters(again);
  again.read(file("echo.prm", echo.str()));
  take_powder(again);
  for (const char *name : {"Cohesion", "Hardening densities"})
    EXPECT_EQ(again.numbers(section + name), table.numbers(section + name))
        << name;
}

TEST(NearestName, CountsSwapsAsOneMistake)
{
  EXPECT_EQ(edit_distance("hertz", "herzt"), 1u);
  EXPECT_EQ(edit_distance("Count", "count"), 0u);
  EXPECT_EQ(nearest_name("minlin", {"none", "mindlin"}), "mindlin");
}
