// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/mdr.h>
#include <tests/dem/laws/two_lanes.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace tamp::dem
{
namespace
{
// The grain of Zunker & Kamrin's examples, and a hard one.
const Mdr soft(1e9, 0.3, 50e6);
const Mdr hard(70e9, 0.3, 100e6);

/// A contact that remembers.
struct Contact {
  PairShape<double> pair;
  std::array<double, Mdr::more> more = {};
  NormalMemory<double> memory = {0, 0, nullptr};

  Contact(double first, double second)
      : pair{first + second,
             first * second / (first + second),
             second - first,
             0}
  {
    memory.more = more.data();
  }
  Contact(const Contact &) = delete;

  NormalAnswer<double> press(const Mdr &law, double overlap)
  {
    return law(overlap, pair, memory);
  }
  /// Force at an overlap, nothing remembered.
  double probe(const Mdr &law, double overlap) const
  {
    std::array<double, Mdr::more> copy = more;
    NormalMemory<double> tried = {memory.largest_overlap, 0, copy.data()};
    return law(overlap, pair, tried).force;
  }
};

TEST(Mdr, GivesTheSameOnPacks)
{
  constexpr double tolerance = 1e-15; // the same operations
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int trial = 0; trial < 1000; ++trial) {
    Contact one(0.5, 0.3 + share(random)), two(0.2, 0.4);
    for (Contact *c : {&one, &two}) {
      c->memory.largest_overlap = 0.3 * share(random);
      for (int k = 0; k < 2; ++k) {
        double *more = c->more.data() + k * MdrMemory<double>::size;
        more[0] = 0.1 * share(random);
        more[1] = 0.02 * share(random);
        more[2] = std::max(0.0, 1e9 * (share(random) - 0.5));
        more[3] = 0.1 * share(random);
      }
    }
    const auto both = [](double x, double y) { return Two(x, y); };
    PairShape<Two> pair = {
        both(one.pair.radius_sum, two.pair.radius_sum),
        both(one.pair.reduced_radius, two.pair.reduced_radius),
        both(one.pair.radius_difference, two.pair.radius_difference),
        Two(0.0)};
    std::array<Two, Mdr::more> more;
    for (int k = 0; k < Mdr::more; ++k)
      more[k] = both(one.more[k], two.more[k]);
    NormalMemory<Two> memory = {
        both(one.memory.largest_overlap, two.memory.largest_overlap),
        Two(0.0),
        more.data()};
    const Two overlap(0.4 * share(random) - 0.02, 0.2 * share(random));
    const auto push = soft(overlap, pair, memory);
    int lane = 0;
    for (Contact *c : {&one, &two}) {
      const auto alone = c->press(soft, overlap.lane[lane]);
      EXPECT_NEAR(push.force.lane[lane], alone.force, tolerance * alone.force);
      EXPECT_NEAR(push.contact_radius.lane[lane],
                  alone.contact_radius,
                  tolerance * alone.contact_radius);
      for (int k = 0; k < Mdr::more; ++k)
        EXPECT_EQ(more[k].lane[lane], c->more[k]);
      ++lane;
    }
  }
}

TEST(Mdr, EqualGrainsShareTheOverlapEqually)
{
  Contact contact(0.5, 0.5);
  for (double overlap : {.01, .05, .2, .15, .12, .3}) {
    contact.press(soft, overlap);
    const auto side = soft.sides(overlap, contact.pair, contact.memory);
    EXPECT_DOUBLE_EQ(side[0].overlap, overlap / 2);
    EXPECT_DOUBLE_EQ(side[1].overlap, overlap / 2);
    EXPECT_DOUBLE_EQ(side[0].force, side[1].force);
    // And each is a grain on a flat.
    const FlatPeak<double> peak =
        soft.flat().peak(contact.memory.largest_overlap / 2, 0.5);
    EXPECT_DOUBLE_EQ(contact.probe(soft, overlap),
                     soft.flat().push(overlap / 2, peak, 0.5).force);
  }
}

TEST(Mdr, SidesAddUpToTheOverlap)
{
  constexpr double tolerance = 1e-14; // rounding
  Contact contact(0.5, 0.2);
  for (double overlap : {.01, .05, .2, .15, .12, .3, .25}) {
    contact.press(soft, overlap);
    const auto side = soft.sides(overlap, contact.pair, contact.memory);
    EXPECT_NEAR(side[0].overlap + side[1].overlap, overlap, tolerance);
  }
}

TEST(Mdr, ChangesNothingWhenGrainsAreSwapped)
{
  constexpr double tolerance = 1e-12; // rounding
  Contact one(0.5, 0.2), other(0.2, 0.5);
  for (double overlap : {.01, .05, .2, .15, .12, .3, .25}) {
    const double force = one.press(soft, overlap).force;
    EXPECT_NEAR(other.press(soft, overlap).force, force, tolerance * force);
  }
}

TEST(Mdr, SmallOverlapsAreHertzOfTwoSpheres)
{
  // The sides' split and the sphere's curvature are of first order in it.
  constexpr double ratio = 1e-5, tolerance = 10 * ratio;
  for (double second : {1e-4, 3e-5, 1e-3}) {
    Contact contact(1e-4, second);
    const double reduced = contact.pair.reduced_radius;
    const double overlap = ratio * reduced;
    const double hertz = 4.0 / 3 * soft.flat().modulus() / 2 *
                         std::sqrt(reduced * overlap) * overlap;
    const auto push = contact.press(soft, overlap);
    EXPECT_NEAR(push.force / hertz, 1, tolerance);
    EXPECT_NEAR(
        push.contact_radius / std::sqrt(reduced * overlap), 1, tolerance);
    EXPECT_FALSE(soft.is_plastic(contact.pair, contact.memory));
    EXPECT_NEAR(soft.loading_slope(overlap, contact.pair, contact.memory) /
                    (1.5 * hertz / overlap),
                1,
                tolerance);
  }
}

TEST(Mdr, ForceIsContinuousInLoading)
{
  // A step of 1e-6 R* changes the force by its slope times that.
  for (const Mdr *law : {&soft, &hard})
    for (double second : {.5, .1}) {
      Contact contact(0.5, second);
      const double step = 1e-6 * contact.pair.reduced_radius;
      const double slope =
          4 * law->flat().modulus() * contact.pair.reduced_radius;
      double before = 0;
      for (int i = 1; i < 600000; ++i) {
        const double force = contact.press(*law, i * step).force;
        ASSERT_NEAR(force, before, slope * step) << i;
        ASSERT_GT(force, before) << i;
        before = force;
      }
      EXPECT_TRUE(law->is_plastic(contact.pair, contact.memory));
    }
}

TEST(Mdr, LargerGrainYieldsOnWhereTheSmallerIsFlat)
{
  constexpr double rounding = 1e-14;
  constexpr double limit = SphereOnFlat::overlap_limit;
  for (double second : {.45, .2}) {
    Contact contact(0.5, second);
    const double deepest = soft.deepest_overlap(contact.pair);
    const double step = 1e-5 * deepest;
    // The steepest that the geometric area lets the force grow.
    const double slope =
        4 * soft.flat().modulus() * contact.pair.reduced_radius;
    double before = contact.press(soft, 0.5 * deepest).force;
    bool flat = false;
    for (int i = 50001; i <= 100000; ++i) {
      const double overlap = i * step;
      const double force = contact.press(soft, overlap).force;
      const auto side = soft.sides(overlap, contact.pair, contact.memory);
      ASSERT_NEAR(side[0].overlap + side[1].overlap, overlap, rounding);
      flat = side[1].overlap > (1 - rounding) * limit * second;
      ASSERT_LE(side[1].overlap, (1 + rounding) * limit * second);
      ASSERT_NEAR(force, before, slope * step) << i;
      if (i < 99000) { // at the very end p_Y falls faster than areas grow
        ASSERT_GT(force, before) << i;
      }
      before = force;
    }
    EXPECT_TRUE(flat);
  }
}

TEST(Mdr, ReloadsAlongTheUnloadingCurveUpToTheLargestOverlap)
{
  constexpr double tolerance = 1e-12; // rounding
  for (double second : {.5, .15}) {
    Contact contact(0.5, second);
    const double largest = 0.3 * contact.pair.reduced_radius;
    const double peak = contact.press(soft, largest).force;
    std::vector<double> down;
    for (int i = 0; i <= 100; ++i)
      down.push_back(contact.press(soft, largest * (1 - i / 100.0)).force);
    EXPECT_EQ(down.back(), 0);
    for (int i = 100; i >= 0; --i)
      EXPECT_NEAR(contact.press(soft, largest * (1 - i / 100.0)).force,
                  down[i],
                  tolerance * peak);
    EXPECT_NEAR(down[0], peak, tolerance * peak);
    // Beyond, it follows the virgin curve as if nothing had happened.
    Contact virgin(0.5, second);
    EXPECT_NEAR(contact.press(soft, 1.1 * largest).force,
                virgin.press(soft, 1.1 * largest).force,
                tolerance * peak);
  }
}

TEST(Mdr, SteepestSlopeBoundsTheUnloading)
{
  constexpr double tolerance = 1e-3; // of the difference quotient
  for (const Mdr *law : {&soft, &hard})
    for (double second : {.5, .15})
      for (double share : {1e-6, .01, .1, .4}) {
        Contact contact(0.5, second);
        const double largest = share * contact.pair.reduced_radius;
        contact.press(*law, largest);
        const double bound = law->steepest_slope(contact.pair, contact.memory);
        double steepest = 0;
        for (int i = 0; i < 1000; ++i) {
          const double overlap = largest * (1 - i * 1e-3),
                       step = largest * 1e-6;
          steepest = std::max(steepest,
                              (contact.probe(*law, overlap) -
                               contact.probe(*law, overlap - step)) /
                                  step);
        }
        EXPECT_LE(steepest, bound * (1 + tolerance));
        // It is the slope itself where both sides have yielded.
        if (second == 0.5 && law->is_plastic(contact.pair, contact.memory)) {
          EXPECT_GE(steepest, bound * (1 - tolerance));
        }
      }
}

TEST(Mdr, EnergyIsTheWorkDone)
{
  constexpr double tolerance = 1e-6; // trapezoidal rule with 1e5 steps
  for (double second : {.5, .15}) {
    Contact contact(0.5, second);
    const double largest = 0.3 * contact.pair.reduced_radius;
    constexpr int steps = 100000;
    double work = 0, before = 0;
    const auto go = [&](double from, double to) {
      for (int i = 1; i <= steps; ++i) {
        const double force =
            contact.press(soft, from + (to - from) * i / steps).force;
        work += 0.5 * (force + before) * (to - from) / steps;
        before = force;
      }
      const NormalEnergy energy = soft.energy(to, contact.pair, contact.memory);
      EXPECT_NEAR((energy.elastic + energy.dissipated) / work, 1, tolerance);
    };
    go(0, 0.05 * largest); // elastic
    EXPECT_EQ(
        soft.energy(0.05 * largest, contact.pair, contact.memory).dissipated,
        0);
    go(0.05 * largest, largest);
    go(largest, 0.9 * largest);
    go(0.9 * largest, 0.95 * largest);
    go(0.95 * largest, 1.5 * largest);
    go(1.5 * largest, 0);
    EXPECT_EQ(soft.energy(0, contact.pair, contact.memory).elastic, 0);
    const double deepest = soft.deepest_overlap(contact.pair);
    go(0, 0.5 * deepest);
    go(0.5 * deepest, deepest);
  }
}

TEST(Mdr, LossNeverFallsOnRandomPaths)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  for (int path = 0; path < 100; ++path) {
    Contact contact(1e-4, 1e-4 * (0.2 + share(random)));
    const Mdr &law = path % 2 ? soft : hard;
    const double scale = contact.pair.reduced_radius * share(random);
    double lost = 0;
    for (int step = 0; step < 1000; ++step) {
      const double overlap = scale * (1.1 * share(random) - 0.1);
      const auto push = contact.press(law, overlap);
      const NormalEnergy energy =
          law.energy(overlap, contact.pair, contact.memory);
      ASSERT_TRUE(std::isfinite(push.force) && push.force >= 0);
      ASSERT_EQ(push.contact_radius > 0, push.force > 0);
      ASSERT_GE(energy.elastic, 0);
      const double rounding = 1e-9 * (energy.elastic + energy.dissipated);
      ASSERT_GE(energy.dissipated, lost - rounding);
      lost = std::max(lost, energy.dissipated);
    }
  }
}

TEST(Mdr, ClosedCyclesGainNoEnergy)
{
  // Trapezoidal rule of 200 steps a cycle; its error is of that order.
  constexpr double tolerance = 1e-4;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int path = 0; path < 500; ++path) {
    Contact contact(1e-4, 1e-4 * (0.2 + share(random)));
    const double scale = 0.8 * contact.pair.reduced_radius;
    contact.press(soft, scale * share(random));
    const double low = scale * share(random), high = scale * share(random);
    double before = contact.press(soft, low).force, work = 0, gross = 0;
    for (int i = 1; i <= 200; ++i) {
      const double phase = i <= 100 ? i / 100.0 : 2 - i / 100.0;
      const double force =
          contact.press(soft, low + (high - low) * phase).force;
      const double step = (i <= 100 ? 1 : -1) * (high - low) / 100;
      work += 0.5 * (force + before) * step;
      gross += 0.5 * (force + before) * std::abs(step);
      before = force;
    }
    EXPECT_GE(work, -tolerance * gross);
  }
}

TEST(Mdr, StaysFiniteAtAbsurdOverlaps)
{
  for (double second : {1e-4, 1e-5})
    for (double overlap : {-1.0, -1e-9, 0.0, 1e-30, 1.9e-4, 2e-4, 1e-3, 1.0}) {
      Contact contact(1e-4, second);
      const auto push = contact.press(soft, overlap);
      EXPECT_TRUE(std::isfinite(push.force)) << overlap;
      EXPECT_TRUE(std::isfinite(push.contact_radius)) << overlap;
      if (overlap <= 0) {
        EXPECT_EQ(push.force, 0);
      }
    }
}

TEST(Mdr, BulkPressureStiffensAndTakesNoPartOfTheYieldSurface)
{
  constexpr double tolerance = 1e-5; // of the difference quotient
  Contact contact(0.5, 0.5);
  const double overlap = 0.2, stiffness = 2e9;
  const double force = contact.press(soft, overlap).force;
  for (int k = 0; k < 2; ++k) {
    auto *more = contact.more.data() + k * MdrMemory<double>::size;
    more[2] = stiffness;
    more[3] = overlap / 2;
  }
  // At first there is no bulk force, then it goes with stiffness times area.
  EXPECT_DOUBLE_EQ(contact.press(soft, overlap).force, force);
  const auto side = soft.sides(overlap, contact.pair, contact.memory);
  EXPECT_NEAR(soft.loading_slope(overlap, contact.pair, contact.memory) /
                  (stiffness * side[0].area / 2),
              1,
              tolerance);
  const double largest = contact.more[0];
  contact.press(soft, 1.1 * overlap);
  EXPECT_DOUBLE_EQ(contact.more[0], largest);
}

TEST(Mdr, ObstructedContactsCarryTheirShare)
{
  Contact contact(0.5, 0.3);
  const double overlap = 0.1;
  const double force = contact.press(soft, overlap).force;
  const NormalEnergy energy =
      soft.energy(overlap, contact.pair, contact.memory);
  contact.more[Mdr::more - 1] = 0.3;
  EXPECT_DOUBLE_EQ(contact.press(soft, overlap).force, 0.7 * force);
  const NormalEnergy less = soft.energy(overlap, contact.pair, contact.memory);
  EXPECT_DOUBLE_EQ(less.elastic, 0.7 * energy.elastic);
  EXPECT_DOUBLE_EQ(less.dissipated, 0.7 * energy.dissipated);
}
} // namespace
} // namespace tamp::dem
