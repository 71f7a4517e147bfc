// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/nearest_name.h>
#include <apps/input/parameter_table.h>
#include <apps/input/powder.h>
#include <apps/input/run_input.h>
#include <coupling/unit_cell_points.h>
#include <dem/unit_cell_bytes.h>
#include <fem/kinematics.h>

#include <array>
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

TEST_F(Parameters, OneEntryOfAListIsSetAndTheOthersStay)
{
  table.set("Material/Elastic/Young's modulus = 1, 2 GPa, 3 MPa");
  table.set("Material/Elastic/Young's modulus[2] = 50 MPa");
  table.set("Material/Elastic/Young's modulus[3] = 7000");
  const auto values = table.numbers("Material/Elastic/Young's modulus");
  EXPECT_EQ(values, (std::vector<double>{1e6, 50e6, 7000}));
  EXPECT_EQ(table.number("Material/Elastic/Young's modulus[2]"), 50e6);
  EXPECT_EQ(table.list_size("Material/Elastic/Young's modulus"), 3u);
  EXPECT_FALSE(table.list_size("Grains/Count"));
  table.set("Die/Elements = 2, 3");
  table.set("Die/Elements[1] = 4");
  EXPECT_EQ(table.indices("Die/Elements"), (std::vector<std::size_t>{4, 3}));
}

TEST_F(Parameters, AnEntryThatAListHasNotIsRefusedWithTheReason)
{
  const auto says = [&](const std::string &setting, const std::string &part) {
    try {
      table.set(setting);
      ADD_FAILURE() << setting;
    } catch (const InputError &error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("--set \"" + setting), std::string::npos) << text;
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  };
  table.set("Material/Elastic/Young's modulus = 1, 2 GPa");
  says("Material/Elastic/Young's modulus[3] = 1 GPa", "[1] to [2]");
  says("Material/Elastic/Young's modulus[0] = 1 GPa", "[1] to [2]");
  says("Material/Elastic/Young's modulus[1] = 1 mm", "a pressure");
  says("Material/Elastic/Young's modulus[1] = 1, 2", "a pressure");
  says("Grains/Young's modulus[1] = 1 GPa", "is no list of numbers");
  says("Contact/Limiting contact pressures[1] = 1 GPa", "is empty");
  says("Contact/Limiting presures[1] = 1 GPa",
       "did you mean 'Limiting contact pressures'");
  says("Die/Elements[1] = 2.5", "a whole number");
}

TEST_F(Parameters, PressuresAdjustedToTheDensityAreTaken)
{
  table.set("Contact/Normal law = thornton-ning-adjusted");
  table.set("Contact/Limiting contact pressures = 20, 60, 200 MPa");
  table.set("Contact/Densities of limiting contact pressures = 0.6, 0.7, 0.85");
  const auto material =
      read_input(table, Need::probe).material.packing.material;
  EXPECT_EQ(material.adjusted_pressures,
            (std::vector<tamp::dem::PressureAtDensity>{
                {0.6, 20e6}, {0.7, 60e6}, {0.85, 200e6}}));
}

TEST_F(Parameters, PressuresAdjustedToTheDensityThatAreNoneAreRefused)
{
  const auto says = [&](const std::string &part) {
    try {
      read_input(table, Need::probe);
      ADD_FAILURE() << part;
    } catch (const InputError &error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  };
  table.set("Contact/Limiting contact pressures = 20, 60, 200 MPa");
  says("Contact/Densities of limiting contact pressures = , which are 0");
  table.set("Contact/Densities of limiting contact pressures = 0.6, 0.7");
  says("which are 2");
  table.set("Contact/Densities of limiting contact pressures = 0.6, 0.7, 0.8");
  says("expected Contact/Normal law = thornton-ning-adjusted; thornton-ning");
  for (const char *law : {"thornton-ning-jkr", "mdr", "storakers"}) {
    table.set(std::string("Contact/Normal law = ") + law);
    says(law);
  }
  table.set("Contact/Normal law = thornton-ning-adjusted");
  EXPECT_NO_THROW(read_input(table, Need::probe));
  EXPECT_THROW(read_input(table, Need::contact), InputError);
  table.set("Contact/Densities of limiting contact pressures[3] = 0.7");
  says("expected densities that rise");
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

TEST_F(Parameters, AnUnevenFillingFromAFileIsExactWhereItIsLinear)
{
  table.set("Material/Type = elastic");
  // Unevenly spaced, in no order, with a column that is not for us.
  const auto of_rz = file("rz.csv",
                          "# 0.3 + 20 r - 5 z, in metres\n"
                          "z[mm], r[mm], who[-], relative_density[%]\n"
                          "7, 6, 1, 38.5\n0, 1, 1, 32\n7, 0, 1, 26.5\n"
                          "0, 0, 1, 30\n0, 6, 1, 42\n7, 1, 1, 28.5\n");
  const auto of_xyz = file("xyz.csv",
                           "x[m],y[m],z[m],relative_density[-]\n"
                           "0,0,0,0.3\n0,0,0.007,0.265\n"
                           "0,6e-3,0,0.36\n0,6e-3,0.007,0.325\n"
                           "6e-3,0,0,0.42\n6e-3,0,0.007,0.385\n"
                           "6e-3,6e-3,0,0.48\n6e-3,6e-3,0.007,0.445\n");
  for (const bool radial : {true, false}) {
    table.set("Die/Initial density file = " +
              (radial ? of_rz : of_xyz).string());
    table.set(radial ? "Die/Symmetry = axisymmetric"
                     : "Die/Symmetry = quarter");
    const RunInput input = read_input(table, Need::die);
    const auto places = tamp::fem::point_positions(input.mesh.mesh);
    ASSERT_EQ(input.material.densities.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      // Rounding of a few products below 1.
      EXPECT_NEAR(input.material.densities[i],
                  0.3 + 20 * places[i][0] - 5 * places[i][2] +
                      (radial ? 0 : 10 * places[i][1]),
                  1e-14);
    EXPECT_EQ(input.files, std::vector{radial ? of_rz : of_xyz});
  }
}

TEST_F(Parameters, AFileOfDensitiesThatCannotBeUsedIsNamedWithItsLine)
{
  table.set("Material/Type = elastic");
  const auto complaint = [&](const std::string &text) {
    table.set("Die/Initial density file = " + file("f.csv", text).string());
    try {
      read_input(table, Need::die);
    } catch (const InputError &error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string head = "r[mm],z[mm],relative_density[-]\n";
  const std::string low = "0,0,0.3\n6,0,0.3\n", all = low + "0,7,0.3\n";
  for (const auto &[text, words] : std::vector<std::array<std::string, 2>>{
           {"", "f.csv:1: expected a header"},
           {"r[mm],x[mm],z[mm],relative_density[-]\n", "f.csv:1: expected"},
           {"r[mm],z[s],relative_density[-]\n", ":1: 'z[s]': expected a unit"},
           {"r[mm],r[m],z[m],relative_density[-]\n", "two columns 'r'"},
           {head + "0,0\n", "f.csv:2: '0,0': expected 3 values"},
           {head + "0,0,a\n", "f.csv:2: 'a': expected a finite number in"},
           {head + "0,0,1.3\n", ":2: '1.3': expected a relative density"},
           {head + low + "0,0,0.3\n", "f.csv:4: the place of"},
           {head + low, "f.csv:3: expected at least two different values of z"},
           {head + all,
            "f.csv:4: there is no density at r = 0.006 m, z = 0.00"},
           {head + "0,0,.3\n5,0,.3\n0,7,.3\n5,7,.3\n", "is outside the grid"},
       })
    EXPECT_NE(complaint(text).find(words), std::string::npos)
        << words << " is not in " << complaint(text);
  EXPECT_EQ(complaint(head + all + "6,7,0.3\n"), "");
  table.set("Die/Initial density = 0.3");
  EXPECT_THROW(read_input(table, Need::die), InputError);
  table.set("Die/Initial density = ");
  table.set("Die/Initial density file = none.csv");
  EXPECT_THROW(read_input(table, Need::die), InputError);
}

TEST_F(Parameters, PointsTakeTheDifferentPackingsInTurn)
{
  table.set("Grains/Count = 60");
  const auto cells_of = [&](const std::string &setting, std::size_t first) {
    table.set(setting);
    auto choice = read_input(table, Need::die).material;
    choice.first_point = first;
    constexpr std::size_t count = 7;
    const auto material = make_material(choice, count);
    std::vector<std::vector<char>> cells(count);
    for (std::size_t i = 0; i < count; ++i)
      tamp::dem::to_bytes(material.cells->cell(i), cells[i]);
    return cells;
  };
  const auto three = cells_of("Packing/Different packings = 3", 0);
  for (std::size_t i = 0; i < three.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(three[i] == three[j], i % 3 == j % 3) << i << ", " << j;
  // Points of another rank, which begin with number 2.
  const auto later = cells_of("Packing/Different packings = 3", 2);
  for (std::size_t i = 0; i + 2 < three.size(); ++i)
    EXPECT_TRUE(later[i] == three[i + 2]) << i;
  const auto one = cells_of("Packing/Different packings = 1", 0);
  table.set("Packing/Different packings = 0");
  EXPECT_TRUE(one == cells_of("Packing/Same at all points = true", 0));
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
