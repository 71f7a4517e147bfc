// SPDX-License-Identifier: BSD-3-Clause
#include <apps/selftest/self_checks.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace tamp::apps;

namespace
{
SelfCheck check(double value, double reference, double tolerance)
{
  return {"a quantity", value, reference, tolerance, "a source"};
}
constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace

TEST(SelfChecks, DifferenceIsOverAReferenceThatIsNotZero)
{
  EXPECT_DOUBLE_EQ(difference(check(-101, -100, 0)), -0.01);
  EXPECT_DOUBLE_EQ(difference(check(-0.5, 0, 0)), -0.5);
}

TEST(SelfChecks, FailWhereTheyAreOffByMoreThanTheTolerance)
{
  for (const double sign : {1., -1.}) {
    EXPECT_TRUE(passes(check(100 + sign * 0.9, 100, 0.01)));
    EXPECT_FALSE(passes(check(100 + sign * 1.1, 100, 0.01)));
    EXPECT_TRUE(passes(check(sign * 0.9e-6, 0, 1e-6)));
    EXPECT_FALSE(passes(check(sign * 1.1e-6, 0, 1e-6)));
    EXPECT_FALSE(passes(check(sign * infinity, 1, 0.1)));
  }
  EXPECT_FALSE(passes(check(NAN, 1, 0.1)));
  EXPECT_FALSE(passes(check(NAN, 0, infinity)));
  EXPECT_TRUE(passes(check(0, 0, 0)));
  EXPECT_FALSE(passes(check(1, 0, 0)));
}

TEST(SelfChecks, TableTellsWhatFailed)
{
  std::vector<SelfCheckRoom> rooms{
      {"a room", {check(1, 1, 0), check(2, 1, 0.1), check(NAN, 1, 0.1)}, 0, ""},
      {"another room", {check(1, 1, 0)}, 0, "no memory"}};
  EXPECT_EQ(failures(rooms), 3u);
  const std::string table = self_check_table(rooms);
  const auto times = [&](const std::string &word) {
    unsigned count = 0;
    for (auto at = table.find(word); at != table.npos;
         at = table.find(word, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(times("passed"), 2u);
  EXPECT_EQ(times("FAILED  a source"), 2u);
  EXPECT_EQ(times("FAILED before the end: no memory"), 1u);
  EXPECT_EQ(times("a room"), 1u);
  rooms = {{"a room", {check(1, 1, 0)}, 0, ""}};
  EXPECT_EQ(failures(rooms), 0u);
}

TEST(SelfChecks, KnowADeviationOfTheLawsFromItsReference)
{
  // Whoever doubles a reference by mistake is told: every check of the contacts
  // can fail.
  for (SelfCheck law : check_contacts()) {
    EXPECT_TRUE(passes(law)) << law.quantity;
    law.reference *= 2;
    EXPECT_FALSE(passes(law)) << law.quantity;
  }
}
