// SPDX-License-Identifier: BSD-3-Clause
#include <dem/neighbours.h>
#include <dem/random_numbers.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
using test::message_of;

/// Grains at random places, in a skewed box of a given width over the reach of
/// the largest pair.
struct Sample {
  PeriodicBox box;
  std::vector<Vector3> place;
  std::vector<double> radius;
  double skin = 0.3;
};

Matrix3 random_matrix(RandomNumbers &random, double size)
{
  Matrix3 m;
  for (int k = 0; k < 9; ++k)
    m(k / 3, k % 3) = size * (2 * random.next() - 1);
  return m;
}

Sample random_sample(std::uint64_t seed, std::size_t count, double widths)
{
  RandomNumbers random(seed);
  Sample sample;
  for (std::size_t i = 0; i < count; ++i) {
    sample.radius.push_back(0.7 + 0.6 * random.next());
    sample.place.emplace_back(
        3 * random.next() - 1, 3 * random.next() - 1, 3 * random.next() - 1);
  }
  const double reach = 2 * std::ranges::max(sample.radius) + sample.skin;
  Matrix3 h = random_matrix(random, 0.35);
  for (int a = 0; a < 3; ++a)
    h(a, a) += 1 + 0.3 * random.next();
  const double width = PeriodicBox{h}.smallest_width();
  sample.box.h = h * (widths * reach / width);
  return sample;
}

/// Distance of the nearest image, by trying many of them.
double nearest(const PeriodicBox &box, Vector3 difference)
{
  for (int a = 0; a < 3; ++a)
    difference[a] -= std::floor(difference[a]);
  double best = std::numeric_limits<double>::infinity();
  for (int x = -2; x <= 1; ++x)
    for (int y = -2; y <= 1; ++y)
      for (int z = -2; z <= 1; ++z)
        best = std::min(best, (box.h * (difference + Vector3(x, y, z))).norm());
  return best;
}

std::vector<Pair> brute_force(const Sample &sample, double gap)
{
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < sample.place.size(); ++i)
    for (std::uint32_t j = i + 1; j < sample.place.size(); ++j)
      if (nearest(sample.box, sample.place[j] - sample.place[i]) <
          sample.radius[i] + sample.radius[j] + gap)
        pairs.push_back({i, j});
  return pairs;
}

void expect_all_pairs(const Sample &s)
{
  const std::vector<Pair> wanted = brute_force(s, s.skin);
  for (InstructionSet set : instruction_sets()) {
    const Neighbours found =
        find_neighbours(s.box, s.place, s.radius, s.skin, set);
    EXPECT_TRUE(found.pairs == wanted) << name_of(set);
  }
}

TEST(Neighbours, GridFindsWhatTryingAllPairsFindsOnEverySet)
{
  // From the narrowest box that is allowed (two bins an edge) to six bins.
  for (double widths : {2.001, 2.3, 2.999, 3.001, 3.7, 4.5, 6.2})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(testing::Message() << widths << " widths, seed " << seed);
      expect_all_pairs(random_sample(seed, 80, widths));
    }
}

TEST(Neighbours, GridOfAnotherNumberOfBinsOnEachAxisMissesNoPair)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (int longest = 0; longest < 3; ++longest) {
      SCOPED_TRACE(testing::Message() << longest << ", seed " << seed);
      Sample s = random_sample(seed, 150, 2.001);
      s.box.h.col(longest) *= 3;
      s.box.h.col((longest + 1) % 3) *= 1.6;
      expect_all_pairs(s);
    }
}

TEST(Neighbours, GrainsWithoutNeighboursAndEmptyBinsAreNoTrouble)
{
  Sample s = random_sample(3, 80, 6.2);
  s.place.resize(2);
  s.radius.resize(2, 1.0);
  expect_all_pairs(s);
}

std::vector<NearPair> near_pairs(const Sample &s, InstructionSet set)
{
  const Neighbours found =
      find_neighbours(s.box, s.place, s.radius, s.skin, set);
  std::vector<NearPair> near(3); // what was in it is gone
  find_near_pairs(found, s.box, s.place, s.radius, 0.06, near, set);
  return near;
}

TEST(Neighbours, NearPairsAreThoseBelowTheGapAndLieAsTheGrains)
{
  constexpr double round_off = 1e-13; // of lengths of about one
  const Sample s = random_sample(7, 150, 3.3);
  std::vector<Pair> pairs;
  for (const auto &[pair, lies, overlap] :
       near_pairs(s, InstructionSet::scalar)) {
    const auto [i, j] = pair;
    const Vector3 branch(lies);
    const double distance = nearest(s.box, s.place[j] - s.place[i]);
    EXPECT_NEAR(branch.norm(), distance, round_off);
    EXPECT_NEAR(overlap, s.radius[i] + s.radius[j] - distance, round_off);
    Vector3 shift = s.box.h.inverse() * branch - (s.place[j] - s.place[i]);
    shift -= Vector3(shift.array().round());
    EXPECT_LT(shift.norm(), round_off); // whole edges of the box
    pairs.push_back(pair);
  }
  EXPECT_GT(pairs.size(), 100u); // there is something to compare
  EXPECT_TRUE(pairs == brute_force(s, 0.06));
}

TEST(Neighbours, NearPairsAreTheSameToTheBitOnEverySet)
{
  // Numbers of listed pairs around those that fill registers and chunks.
  for (std::size_t count : {20, 40, 77, 78, 79, 80, 150, 300})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Sample s = random_sample(seed, count, 3.3);
      const auto wanted = near_pairs(s, InstructionSet::scalar);
      EXPECT_FALSE(count >= 77 && wanted.empty());
      for (InstructionSet set : instruction_sets()) {
        const auto found = near_pairs(s, set);
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
          EXPECT_EQ(found[k].pair, wanted[k].pair);
          EXPECT_EQ(Vector3(found[k].branch), Vector3(wanted[k].branch));
          EXPECT_EQ(found[k].overlap, wanted[k].overlap);
        }
      }
    }
}

/// Whether every pair below the gap is listed.
bool complete(const Neighbours &list, const Sample &now, double gap)
{
  const std::vector<Pair> needed = brute_force(now, gap);
  return std::ranges::includes(list.pairs, needed);
}

TEST(Neighbours, StillHoldNeverLies)
{
  constexpr double gap = 0.06;
  int held = 0, given_up = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Sample s = random_sample(seed, 60, 2.02 + 0.1 * double(seed % 10));
    const double largest = std::ranges::max(s.radius);
    const Neighbours list = find_neighbours(s.box, s.place, s.radius, s.skin);
    EXPECT_TRUE(still_hold(list, s.box, s.place, largest, gap));
    RandomNumbers random(seed);
    const double size = 0.06 * random.next();
    for (int step = 0; step < 4; ++step) {
      const Matrix3 strain = random_matrix(random, 0.5 * size);
      s.box.h += strain * s.box.h;
      const Matrix3 inverse = s.box.h.inverse();
      for (Vector3 &place : s.place)
        place += inverse * random_matrix(random, size).col(0);
      const bool holds = still_hold(list, s.box, s.place, largest, gap);
      ++(holds ? held : given_up);
      if (holds) {
        EXPECT_TRUE(complete(list, s, gap)) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(held, 40); // both answers are given often enough to mean something
  EXPECT_GT(given_up, 40);
}

TEST(Neighbours, ListOfAnotherNumberOfGrainsDoesNotHold)
{
  Sample s = random_sample(1, 60, 3);
  const Neighbours list = find_neighbours(s.box, s.place, s.radius, s.skin);
  s.place.pop_back();
  EXPECT_FALSE(still_hold(list, s.box, s.place, 1.3, 0.06));
}

TEST(Neighbours, TooNarrowBoxIsRefused)
{
  const Sample s = random_sample(1, 60, 1.8);
  const std::string message = message_of<std::runtime_error>(
      [&] { find_neighbours(s.box, s.place, s.radius, s.skin); });
  EXPECT_NE(message.find("use more grains"), std::string::npos) << message;
}

TEST(Neighbours, WhateverBoxIsAcceptedMissesNoPair)
{
  int accepted = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Sample s = random_sample(seed, 80, 1.9 + 0.001 * double(seed));
    try {
      const Neighbours list = find_neighbours(s.box, s.place, s.radius, s.skin);
      EXPECT_TRUE(list.pairs == brute_force(s, s.skin)) << "seed " << seed;
      ++accepted;
    } catch (const std::runtime_error &) {
      ++refused;
    }
  }
  EXPECT_GT(accepted, 50); // the samples lie on both sides of the limit
  EXPECT_GT(refused, 50);
}
} // namespace
} // namespace tamp::dem
