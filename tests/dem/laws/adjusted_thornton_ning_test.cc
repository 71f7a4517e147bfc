// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/adjusted_thornton_ning.h>
#include <dem/laws/thornton_ning.h>
#include <dem/random_numbers.h>
#include <tests/dem/laws/impact.h>
#include <tests/dem/laws/lane_pack.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;
constexpr double modulus = 2e9, radius = 1e-4; // E* [Pa], R* [m]
constexpr double pressure = 50e6;              // p_y [Pa]
constexpr double round_off = 1e-12;            // of a few operations
const PairShape<double> pair = test::equal_pair(radius);

AdjustedThorntonNing law_of(double limiting_pressure)
{
  return {modulus, limiting_pressure};
}

double yield_overlap(double limiting_pressure)
{
  return radius * std::pow(pi * limiting_pressure / (2 * modulus), 2);
}

/// A contact that remembers.
struct Contact {
  std::array<double, AdjustedThorntonNing::more> more = {};
  double largest = 0;

  NormalAnswer<double> press(const AdjustedThorntonNing &law, double overlap)
  {
    NormalMemory<double> memory = {largest, 0, more.data()};
    const NormalAnswer<double> answer = law(overlap, pair, memory);
    largest = memory.largest_overlap;
    return answer;
  }
  /// The same with nothing remembered.
  NormalAnswer<double> probe(const AdjustedThorntonNing &law,
                             double overlap) const
  {
    Contact copy = *this;
    return copy.press(law, overlap);
  }
  NormalEnergy energy(const AdjustedThorntonNing &law, double overlap) const
  {
    Contact copy = *this;
    return law.energy(overlap, pair, {largest, 0, copy.more.data()});
  }
  double slope(const AdjustedThorntonNing &law, double overlap) const
  {
    Contact copy = *this;
    return law.loading_slope(overlap, pair, {largest, 0, copy.more.data()});
  }
  bool yielded(const AdjustedThorntonNing &law) const
  {
    Contact copy = *this;
    return law.is_plastic(pair, {largest, 0, copy.more.data()});
  }
  bool operator==(const Contact &) const = default;
};

/// Pressed from the first touch on to an overlap, in increments.
Contact pressed(const AdjustedThorntonNing &law, double overlap, int parts = 7)
{
  Contact contact;
  for (int k = 1; k <= parts; ++k)
    contact.press(law, k < parts ? overlap * k / parts : overlap);
  return contact;
}

TEST(AdjustedThorntonNing, IsThorntonNingAsLongAsThePressureStays)
{
  // Thousands of increments, each with a few roundings.
  constexpr double tolerance = 1e-11;
  const AdjustedThorntonNing law = law_of(pressure);
  const ThorntonNing plain(modulus, pressure);
  const double yield = yield_overlap(pressure);
  RandomNumbers random(3);
  for (int path = 0; path < 200; ++path) {
    const double reach = yield * std::pow(10.0, 3 * random.next() - 1);
    Contact contact;
    NormalMemory<double> memory = {0, 0};
    double scale = 0, energy_scale = 0;
    for (int step = 0; step < 100; ++step) {
      const double overlap = reach * (1.2 * random.next() - 0.2);
      const auto wanted = plain(overlap, pair, memory);
      const auto found = contact.press(law, overlap);
      scale = std::max(scale, wanted.force);
      energy_scale = scale * memory.largest_overlap;
      ASSERT_NEAR(found.force, wanted.force, tolerance * scale);
      ASSERT_NEAR(found.contact_radius, wanted.contact_radius, 1e-6 * radius);
      ASSERT_EQ(contact.largest, memory.largest_overlap);
      ASSERT_EQ(contact.yielded(law), plain.is_plastic(pair, memory));
      const NormalEnergy a = contact.energy(law, overlap),
                         b = plain.energy(overlap, pair, memory);
      ASSERT_NEAR(a.elastic, b.elastic, tolerance * energy_scale);
      ASSERT_NEAR(a.dissipated, b.dissipated, tolerance * energy_scale);
      // The slope is that of another branch on either side of the peak.
      if (wanted.force > 0 && overlap < 0.999 * contact.largest) {
        const double slope = plain.loading_slope(overlap, pair, memory);
        ASSERT_NEAR(contact.slope(law, overlap), slope, 1e-6 * slope);
      }
    }
  }
}

TEST(AdjustedThorntonNing, ForceUnloadingAndLossStayWhenThePressureChanges)
{
  const AdjustedThorntonNing before = law_of(pressure);
  for (double depth : {0.3, 0.99, 1.5, 10.0, 300.0})
    for (double factor : {0.1, 0.5, 0.99, 1.01, 2.0, 10.0}) {
      SCOPED_TRACE(testing::Message() << depth << " " << factor);
      const AdjustedThorntonNing after = law_of(factor * pressure);
      const double overlap = depth * yield_overlap(pressure);
      const Contact contact = pressed(before, overlap);
      const double scale = contact.probe(before, overlap).force;
      EXPECT_GT(scale, 0);
      EXPECT_EQ(contact.yielded(before), depth > 1);
      for (double at = 1; at >= 0; at -= 0.01) {
        const auto old = contact.probe(before, at * overlap);
        const auto now = contact.probe(after, at * overlap);
        ASSERT_NEAR(now.force, old.force, round_off * scale);
        ASSERT_NEAR(now.contact_radius,
                    old.contact_radius,
                    1e-6 * radius); // a root where they part
        const NormalEnergy then = contact.energy(before, at * overlap);
        const NormalEnergy here = contact.energy(after, at * overlap);
        ASSERT_NEAR(here.elastic, then.elastic, round_off * scale * overlap);
        ASSERT_EQ(here.dissipated, then.dissipated);
      }
      EXPECT_EQ(contact.yielded(after), depth > 1);
      // Nor does a hair more make it jump: no slope is above 2 E* a*.
      const double hair = 1e-9 * overlap;
      const auto [force, a, none] = contact.probe(after, overlap);
      EXPECT_NEAR(contact.probe(after, overlap + hair).force,
                  force,
                  2.01 * modulus * a * hair);
    }
}

TEST(AdjustedThorntonNing, YieldsOnUnderALowerPressureWithItsSlope)
{
  // One that has yielded, and one that is elastic beyond the new yielding.
  for (double depth : {4.0, 0.5}) {
    const double lower = 0.4 * pressure;
    const double overlap = depth * yield_overlap(pressure);
    ASSERT_GT(overlap, yield_overlap(lower));
    const Contact contact = pressed(law_of(pressure), overlap);
    const double force = contact.probe(law_of(pressure), overlap).force;
    const double slope = pi * lower * radius;
    EXPECT_DOUBLE_EQ(contact.slope(law_of(lower), overlap), slope);
    for (double more : {0.1, 1.0, 5.0}) {
      const double wanted = force + slope * more * overlap;
      EXPECT_NEAR(contact.probe(law_of(lower), (1 + more) * overlap).force,
                  wanted,
                  round_off * wanted);
    }
  }
}

/// The force that loading beyond delta* comes to, step by step: with the slope
/// of yielding, or that of loading that stores its work if that is lower.
double loaded(double from, double force, double to, double limiting_pressure)
{
  constexpr int parts = 20000;
  const double step = (to - from) / parts;
  const auto slope = [&](double at, double now) {
    const double a = std::sqrt(radius * at);
    const double hertz = 4.0 / 3 * modulus * a * at;
    return std::min(2 * modulus * a * (5.0 / 6 + now / (6 * hertz)),
                    pi * limiting_pressure * radius);
  };
  for (int k = 0; k < parts; ++k) {
    const double at = from + k * step;
    const double middle = force + 0.5 * step * slope(at, force);
    force += step * slope(at + 0.5 * step, middle);
  }
  return force;
}

TEST(AdjustedThorntonNing, StoresTheLoadingThatIsTooShallowForAHigherPressure)
{
  constexpr double tolerance = 1e-7;  // of the steps, over the kink
  const double higher = 4 * pressure; // yields at 16 times the overlap
  const AdjustedThorntonNing law = law_of(higher);
  const ThorntonNing virgin(modulus, higher);
  for (double depth : {1.01, 3.0, 12.0, 24.0, 100.0}) {
    SCOPED_TRACE(depth);
    const double overlap = depth * yield_overlap(pressure);
    const Contact contact = pressed(law_of(pressure), overlap);
    const double force = contact.probe(law, overlap).force;
    const double lost = contact.energy(law, overlap).dissipated;
    // A dent has the slope of yielding at 1.44 times the overlap at the latest.
    const bool shallow = depth < 16;
    const double slope = pi * higher * radius;
    EXPECT_EQ(contact.slope(law, overlap) < 0.999 * slope, shallow);
    EXPECT_DOUBLE_EQ(
        contact.slope(law,
                      std::max(depth, 1.45 * 16) * yield_overlap(pressure)),
        slope);
    for (double share : {1.01, 1.1, 2.0, 5.0}) {
      const double to = share * overlap;
      const double wanted = loaded(overlap, force, to, higher);
      EXPECT_NEAR(contact.probe(law, to).force, wanted, tolerance * wanted);
      NormalMemory<double> memory = {0, 0};
      EXPECT_LE(wanted, virgin(to, pair, memory).force);
      const double taken = contact.energy(law, to).dissipated - lost;
      EXPECT_EQ(taken > 0, share * depth > 16 || !shallow) << share * depth;
    }
  }
}

TEST(AdjustedThorntonNing, UnloadsFromAYieldingThatWentOn)
{
  // R_p* from the force and the radius that were reached, as in the source.
  const double first = 4 * yield_overlap(pressure), lower = 0.4 * pressure;
  Contact contact = pressed(law_of(pressure), first);
  const auto there = contact.probe(law_of(pressure), first);
  const double peak = 3 * first;
  const auto [force, a, none] = contact.press(law_of(lower), peak);
  EXPECT_NEAR(a * a,
              there.contact_radius * there.contact_radius +
                  radius * (peak - first),
              round_off * a * a);
  const double curvature = 4 * modulus * a * a * a / (3 * force);
  const double permanent = peak - a * a / curvature;
  for (double share : {0.9, 0.5, 0.1}) {
    const double above = share * (peak - permanent);
    const double wanted =
        4.0 / 3 * modulus * std::sqrt(curvature) * std::pow(above, 1.5);
    EXPECT_NEAR(contact.probe(law_of(lower), permanent + above).force,
                wanted,
                1e-10 * force);
  }
  EXPECT_EQ(contact.probe(law_of(lower), 0.999 * permanent).force, 0);
}

TEST(AdjustedThorntonNing, OneIncrementIsWorthItsParts)
{
  const double start = 30 * yield_overlap(pressure);
  for (double factor : {0.2, 1.0, 4.0, 20.0})
    for (double depth : {0.5, 3.0}) {
      const AdjustedThorntonNing law = law_of(factor * pressure);
      const Contact contact = pressed(law_of(pressure), depth * start);
      const double goal = 4 * depth * start;
      Contact whole = contact, parts = contact;
      whole.press(law, goal);
      for (int k = 1; k <= 1000; ++k)
        parts.press(law, depth * start + (goal - depth * start) * k / 1000);
      ASSERT_EQ(whole.largest, parts.largest);
      for (int m = 0; m < AdjustedThorntonNing::more; ++m)
        EXPECT_NEAR(
            parts.more[m], whole.more[m], 1e-11 * whole.more[m]); // roundings
    }
}

TEST(AdjustedThorntonNing, TrialsAndEnergiesLeaveTheMemory)
{
  const AdjustedThorntonNing law = law_of(pressure);
  Contact contact = pressed(law, 10 * yield_overlap(pressure));
  const Contact before = contact;
  const double overlap = 0.5 * contact.largest;
  contact.energy(law, 2 * contact.largest);
  contact.slope(law, 2 * contact.largest);
  const auto once = contact.press(law, overlap);
  EXPECT_EQ(contact, before);
  EXPECT_EQ(contact.press(law, overlap).force, once.force);
}

/// A random path on which the pressure changes, by up to a factor of 30 to
/// either side, before each of its legs.
struct RandomPath {
  RandomNumbers &random;
  Contact contact;
  double overlap = 0, force = 0, work = 0, doubt = 0, lost = 0, shrunk = 0;
  double gap = 0; // most that work and ledger differ beyond the doubt [J]

  void go(double limiting_pressure, double to)
  {
    const AdjustedThorntonNing law = law_of(limiting_pressure);
    constexpr int parts = 40;
    const double from = overlap;
    for (int k = 1; k <= parts; ++k) {
      const double next = from + (to - from) * k / parts;
      const double now = contact.press(law, next).force;
      work += 0.5 * (force + now) * (next - overlap);
      doubt += 0.5 * std::abs((now - force) * (next - overlap));
      overlap = next;
      force = now;
    }
    const NormalEnergy energy = contact.energy(law, overlap);
    shrunk = std::max(shrunk, lost - energy.dissipated);
    lost = energy.dissipated;
    gap = std::max(gap,
                   std::abs(work - energy.elastic - energy.dissipated) - doubt);
  }
};

TEST(AdjustedThorntonNing, GivesNoEnergyAwayHoweverThePressureChanges)
{
  RandomNumbers random(5);
  for (int k = 0; k < 5000; ++k) {
    RandomPath path{random, {}};
    const double reach =
        yield_overlap(pressure) * std::pow(10.0, 4 * random.next() - 2);
    double scale = 0;
    for (int leg = 0; leg < 6; ++leg) {
      const double limit = pressure * std::pow(30.0, 2 * random.next() - 1);
      path.go(limit, leg < 5 ? reach * random.next() : 0);
      scale = std::max(scale, std::abs(path.work));
    }
    // Roundings of energies that cancel.
    ASSERT_LE(path.gap, 1e-11 * scale) << k;
    ASSERT_LE(path.shrunk, 1e-11 * scale) << k;
    ASSERT_GE(path.work, -path.doubt) << k;
  }
}

TEST(AdjustedThorntonNing, IsTheSameInPacksAndNearlyInFloat)
{
  RandomNumbers random(9);
  using Pack = LanePack<double>;
  for (int sample = 0; sample < 2000; ++sample) {
    // Far below yielding float has few digits of rho, as in ThorntonNing.
    const double reach =
        yield_overlap(pressure) * std::pow(10.0, 3 * random.next() - 1);
    const Contact contact = pressed(law_of(pressure), reach);
    const AdjustedThorntonNing law =
        law_of(pressure * std::pow(5.0, 2 * random.next() - 1));
    const double overlap = 2 * reach * random.next();
    Contact single = contact;
    const auto answer = single.press(law, overlap);
    const double scale = contact.probe(law, std::max(reach, overlap)).force;

    Pack more[] = {Pack(contact.more[0]), Pack(contact.more[1])};
    NormalMemory<Pack> packs{Pack(reach), Pack(0.0), more};
    const auto pack =
        law(Pack(overlap),
            {Pack(4 * radius), Pack(radius), Pack(0.0), Pack(0.0)},
            packs);
    // Compilers may contract a * b + c in one and not in the other.
    ASSERT_NEAR(pack.force.lane[3], answer.force, 1e-9 * scale);
    ASSERT_EQ(packs.largest_overlap.lane[1], single.largest);
    ASSERT_NEAR(more[0].lane[2], single.more[0], 1e-9 * single.more[0]);

    float rough_more[] = {
        float(contact.more[0]), float(contact.more[1]), float(contact.more[2])};
    NormalMemory<float> floats{float(reach), 0, rough_more};
    const auto rough = law(
        float(overlap), {float(4 * radius), float(radius), 0.f, 0.f}, floats);
    ASSERT_NEAR(rough.force, answer.force, 1e-4 * scale);
  }
  // A lane without a pair.
  double more[2] = {};
  NormalMemory<double> memory = {0, 0, more};
  const auto none = law_of(pressure)(-1e-3, test::equal_pair(0), memory);
  EXPECT_EQ(none.force, 0);
  EXPECT_EQ(none.contact_radius, 0);
}
} // namespace
} // namespace tamp::dem
