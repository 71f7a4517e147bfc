// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/parameter_table.h>
#include <apps/input/run_input.h>
#include <apps/run/run_resume.h>

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>

namespace tamp::apps
{
namespace
{
std::string echo_with(const std::vector<std::string> &settings)
{
  ParameterTable table;
  declare_parameters(table);
  for (const std::string &setting : settings)
    table.set(setting);
  std::ostringstream echo;
  table.echo(echo);
  return echo.str();
}
} // namespace

TEST(RunResume, NamesEveryEntryThatDiffersAndNoOther)
{
  const std::string then = echo_with({});
  EXPECT_EQ(differences(then, then), "");
  // The same value in another unit is the same.
  EXPECT_EQ(differences(echo_with({"Die/Radius = 6 mm"}),
                        echo_with({"Die/Radius = 0.6 cm"})),
            "");
  EXPECT_EQ(differences(echo_with({"Output/Checkpoint interval = 3 h",
                                   "Output/Plot format = pdf"}),
                        then),
            "");
  // Entries of a subsection, and two at once.
  EXPECT_EQ(differences(echo_with({"Material/FKM-Gurson/Random packing density "
                                   "= 0.61",
                                   "Packing/Seed = 77"}),
                        echo_with({"Material/FKM-Gurson/Random packing density "
                                   "= 0.62"})),
            "Material/FKM-Gurson/Random packing density = 0.61, was 0.62; "
            "Packing/Seed = 77, was 1");
  EXPECT_EQ(differences(echo_with({"Die/Radius = 7 mm"}),
                        echo_with({"Die/Radius = 6 mm"})),
            "Die/Radius = 0.007 [m], was 0.006 [m]");
}

TEST(RunResume, LooksIntoTheFilesThatTheInputNames)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_resume_" + std::to_string(getpid()) + ".msh");
  const std::string echo = echo_with({});
  std::ofstream(file) << "one";
  const std::string one = whole_input(echo, {file});
  EXPECT_EQ(differences(whole_input(echo, {file}), one), "");
  std::ofstream(file) << "two";
  EXPECT_EQ(differences(whole_input(echo, {file}), one),
            "the content of " + file.filename().string() + " is another");
  EXPECT_NE(differences(echo, one), "");
  std::filesystem::remove(file);
}
} // namespace tamp::apps
