// SPDX-License-Identifier: BSD-3-Clause
#include <fem/ranks.h>
#include <tests/fem/same_everywhere.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tamp::fem
{
TEST(Ranks, SharesCoverEverythingOnce)
{
  const Ranks ranks(MPI_COMM_WORLD);
  for (const std::size_t count : {0, 1, 2, 3, 7, 1000}) {
    const Share share = ranks.share(count);
    std::vector<double> holders(count, 0.);
    for (std::size_t i = 0; i < count; ++i)
      holders[i] = share.holds(i) ? 1 : 0;
    std::vector<double> sizes = {static_cast<double>(share.size())};
    ranks.sum(holders);
    ranks.sum(sizes);
    EXPECT_EQ(holders, std::vector<double>(count, 1.));
    EXPECT_EQ(sizes[0], count);
    // no rank has more than one above another
    EXPECT_LE(share.size(), count / ranks.size() + 1);
    EXPECT_GE(share.size(), count / ranks.size());
  }
}

TEST(Ranks, SumsAreTheSameBitsEverywhere)
{
  const Ranks ranks(MPI_COMM_WORLD);
  // Numbers whose sum depends on the order of adding.
  std::vector<double> values(1000);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::sin(i + 0.1 * ranks.rank()) * std::pow(10., ranks.rank());
  ranks.sum(values);
  EXPECT_TRUE(test::same_everywhere(values, ranks));
  for (std::size_t i = 0; i < values.size(); ++i) {
    double expected = 0;
    for (unsigned rank = 0; rank < ranks.size(); ++rank)
      expected += std::sin(i + 0.1 * rank) * std::pow(10., rank);
    ASSERT_NEAR(values[i], expected, 1e-11); // rounding of numbers below 1e4
  }
}

TEST(Ranks, BytesGetToAnotherRankAndToAll)
{
  const Ranks ranks(MPI_COMM_WORLD);
  const unsigned last = ranks.size() - 1;
  const auto bytes_of = [](unsigned rank) {
    return std::vector<char>(3 + 100 * rank, static_cast<char>('a' + rank));
  };
  for (unsigned from = 0; from < ranks.size(); ++from) {
    std::vector<char> bytes = bytes_of(ranks.rank());
    ranks.move(bytes, from, last);
    EXPECT_EQ(bytes, bytes_of(ranks.rank() == last ? from : ranks.rank()));
    bytes = bytes_of(ranks.rank());
    ranks.spread(bytes, from);
    EXPECT_EQ(bytes, bytes_of(from));
  }
  std::vector<char> nothing;
  ranks.move(nothing, 0, last);
  ranks.spread(nothing);
  EXPECT_TRUE(nothing.empty());
}

TEST(Ranks, AllAgreeOnWhatOneRankKnows)
{
  const Ranks ranks(MPI_COMM_WORLD);
  const unsigned last = ranks.size() - 1;
  EXPECT_TRUE(ranks.all(true));
  EXPECT_FALSE(ranks.all(ranks.rank() != last));
  EXPECT_EQ(ranks.largest(ranks.rank()), last);
  EXPECT_EQ(ranks.largest(-1. - ranks.rank()), -1);
  std::vector<double> values = {1. + ranks.rank(), 0.5};
  ranks.spread(values, last);
  EXPECT_EQ(values, (std::vector<double>{1. + last, 0.5}));
}

TEST(Ranks, ADifferenceOfTheLastBitIsSeen)
{
  const Ranks ranks(MPI_COMM_WORLD);
  std::vector<double> values = {1., 2.};
  EXPECT_TRUE(test::same_everywhere(values, ranks));
  if (ranks.rank() + 1 == ranks.size())
    values[1] += std::numeric_limits<double>::epsilon() * 2;
  EXPECT_EQ(test::same_everywhere(values, ranks), ranks.size() == 1);
}
} // namespace tamp::fem
