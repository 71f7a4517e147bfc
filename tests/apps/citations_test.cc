// SPDX-License-Identifier: BSD-3-Clause
#include <apps/citations.h>
#include <apps/input/run_input.h>
#include <apps/run/build_facts.h>

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <set>

using namespace tamp::apps;

namespace
{
std::vector<std::string_view> used_by(const std::vector<std::string> &settings)
{
  ParameterTable table;
  declare_parameters(table);
  for (const std::string &setting : settings)
    table.set(setting);
  return citations_of(table);
}
bool contains(const std::vector<std::string_view> &keys, std::string_view key)
{
  return std::ranges::count(keys, key) > 0;
}
} // namespace

TEST(Citations, AreWholeEntriesOfDifferentKeys)
{
  const auto keys = all_citations();
  EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), keys.size());
  EXPECT_EQ(keys.front(), "tamp");
  for (const std::string_view key : keys) {
    const std::string entry = citation(key);
    EXPECT_TRUE(std::regex_search(
        entry, std::regex("^@[a-z]+\\{" + std::string(key) + ",\n")))
        << entry;
    int depth = 0;
    for (const char letter : entry) {
      depth += letter == '{' ? 1 : letter == '}' ? -1 : 0;
      EXPECT_GE(depth, 0) << entry;
    }
    EXPECT_EQ(depth, 0) << entry;
    EXPECT_NE(entry.find("  author"), entry.npos) << entry;
    EXPECT_NE(entry.find("  title"), entry.npos) << entry;
  }
}

TEST(Citations, OfAnInputAreThoseOfItsLawsAndLibraries)
{
  const auto cap = used_by({"Material/Type = drucker-prager cap",
                            "Die/Elements = 2, 2",
                            "Solver/Linear algebra = trilinos"});
  for (const char *key : {"tamp", "dealii94", "trilinos", "drucker1957"})
    EXPECT_TRUE(contains(cap, key)) << key;
  for (const char *key : {"petsc", "highway", "thornton1998", "walker2011"})
    EXPECT_FALSE(contains(cap, key)) << key;

  const auto cells = used_by({"Die/Elements = 2, 2"});
  for (const char *key : {"petsc", "thornton1998", "bitzek2006", "walker2011"})
    EXPECT_TRUE(contains(cells, key)) << key;
  EXPECT_FALSE(contains(cells, "drucker1957"));

  const auto pair = used_by({"Contact/Normal law = mdr",
                             "Contact/Tangential law = mindlin-deresiewicz",
                             "Pair/Stages = overlap to 1 um"});
  for (const char *key : {"zunker2024a", "mindlin1953"})
    EXPECT_TRUE(contains(pair, key)) << key;
  for (const char *key : {"highway", "mindlin1949", "openmpi"})
    EXPECT_FALSE(contains(pair, key)) << key;
}

TEST(Citations, EveryChoiceOfAnInputHasItsOwn)
{
  // citations_of() throws where it does not know a value.
  for (const auto &[name, values] :
       std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"Contact/Normal law",
            {"hertz",
             "thornton-ning",
             "jkr",
             "thornton-ning-jkr",
             "storakers",
             "mdr",
             "thornton-ning-adjusted"}},
           {"Contact/Tangential law",
            {"none", "mindlin", "mindlin-deresiewicz"}},
           {"Contact/Rolling law", {"none", "epsd"}},
           {"Cell/Method", {"quasi-static", "dynamics"}},
           {"Solver/Linear algebra", {"petsc", "trilinos"}},
           {"Solver/Nonlinear method", {"automatic", "newton", "anderson"}},
           {"Material/Type",
            {"unit cell",
             "elastic",
             "drucker-prager cap",
             "modified cam-clay",
             "fkm-gurson"}}})
    for (const std::string &value : values)
      EXPECT_NO_THROW(used_by({"Die/Elements = 2, 2", name + " = " + value}))
          << name << " = " << value;
}

TEST(Citations, TheCitationFileOfTheRepositorySaysTheSame)
{
  std::ifstream file(TAMP_TEST_INPUTS "/../../CITATION.cff");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string version = "\nversion: " + build_facts().version + "\n";
  EXPECT_NE(text.find(version), text.npos);
  std::string all;
  for (const std::string_view key : all_citations())
    all += citation(key);
  const std::regex doi("doi: *(\\S+)");
  unsigned count = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), doi), end;
       found != end;
       ++found, ++count)
    EXPECT_NE(all.find("{" + found->str(1) + "}"), all.npos) << found->str(1);
  EXPECT_GE(count, 3u);
  std::smatch title;
  ASSERT_TRUE(
      std::regex_search(text, title, std::regex("\ntitle: \"([^\"]+)\"")));
  EXPECT_NE(citation("tamp").find("{" + title.str(1) + "}"), all.npos);
}
