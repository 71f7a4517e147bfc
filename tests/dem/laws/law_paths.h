// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_law_paths_h
#define tests_dem_laws_law_paths_h

#include <dem/laws/pair_law.h>
#include <dem/random_numbers.h>

#include <cmath>
#include <gtest/gtest.h>

#include "lane_pack.h"

namespace tamp::dem
{
/// A pair of which normal laws look at R* only.
template <class V = double>
PairShape<V> pair_of(double reduced_radius)
{
  return {V(4 * reduced_radius), V(reduced_radius), V(0.0), V(1.0)};
}

/// A contact under way: every step is committed.
template <class Law>
struct Walk {
  const Law &law;
  PairShape<double> pair;
  NormalMemory<double> memory{0, 0};
  NormalAnswer<double> now{0, 0, 0};
  double overlap = 0, work = 0, lost = 0; // [J]; lost as they touch and tear
  double doubt = 0; // about the work: force between its values at both ends of
                    // a step, give or take the pull-off [J]
  double largest_force = 0; // of either sign [N]

  void step(double to)
  {
    const NormalMemory<double> old = memory;
    now = law(to, pair, memory);
    if (old.contact_radius == 0 && now.contact_radius > 0)
      lost += law.lost_at_touch(pair, old);
    if (old.contact_radius > 0 && now.contact_radius == 0)
      lost += law.lost_at_tear(pair, old);
    memory.contact_radius = now.contact_radius;
    overlap = to;
    largest_force = std::max(largest_force, std::abs(now.force));
  }
  /// In equal parts, with the work by the trapezoidal rule.
  void go(double to, int parts)
  {
    const double from = overlap;
    for (int k = 1; k <= parts; ++k) {
      const double before = now.force, pull = now.pull_off;
      const double length = (to - from) / parts;
      step(from + k * length);
      work += 0.5 * (before + now.force) * length;
      const double jump = 2 * std::max(pull, now.pull_off);
      doubt += 0.5 * std::abs(length) * (std::abs(now.force - before) + jump);
    }
  }
  double ledger() const
  {
    const NormalEnergy energy = law.energy(overlap, pair, memory);
    return energy.elastic + energy.dissipated + lost;
  }
};

/// Work is what is stored and lost, all along loads, tears and new loads.
/// @param reach  the largest overlap [m]
template <class Law>
void expect_work_in_ledger(const Law &law, double radius, double reach)
{
  Walk<Law> walk{law, pair_of(radius)};
  constexpr int parts = 20000;
  // A jump of the force inside a step costs half the step's share of it.
  constexpr double tolerance = 1e-4;
  for (const double to : {0.4, 0.15, 0.6, -0.5, 0.3, 1.0, -0.5, 0.9}) {
    walk.go(to * reach, parts);
    const double scale = walk.largest_force * reach;
    ASSERT_NEAR(walk.work, walk.ledger(), tolerance * scale) << to;
    ASSERT_GE(walk.lost, 0);
  }
}

/// loading_slope is the derivative of the force along a walk.
template <class Law>
void expect_slope(const Walk<Law> &at, double overlap, bool loading)
{
  const double step = 1e-6 * std::max(at.memory.largest_overlap, overlap);
  const auto force = [&](double there) {
    NormalMemory<double> memory = at.memory;
    return at.law(there, at.pair, memory).force;
  };
  const double back = loading ? 0 : step;
  const double found =
      (force(overlap + step) - force(overlap - back)) / (step + back);
  const double slope = at.law.loading_slope(overlap, at.pair, at.memory);
  // One-sided differences err by half a step of the curvature.
  EXPECT_NEAR(slope, found, (loading ? 1e-4 : 1e-7) * std::abs(slope))
      << overlap;
}

/// On 1e5 random paths all numbers are finite, the work is what the ledger
/// says, what is lost only grows, and grains part in the end: no closed path
/// gives work away.
template <class MakeLaw>
void expect_no_gain_on_random_paths(const MakeLaw &make_law)
{
  RandomNumbers random(7);
  constexpr int paths = 100000, parts = 12;
  int broken = 0;
  for (int path = 0; path < paths; ++path) {
    const auto law = make_law(random);
    const double radius = std::pow(10.0, -6 + 6 * random.next());
    const double reach = radius * std::pow(10.0, -5 + 4 * random.next());
    Walk walk{law, pair_of(radius)};
    double gone = 0;
    const auto lost = [&] {
      return walk.lost +
             law.energy(walk.overlap, walk.pair, walk.memory).dissipated;
    };
    for (int leg = 0; leg < 4; ++leg) {
      walk.go(reach * (1.5 * random.next() - 0.5), parts);
      // Rounding of energies that cancel, and the doubt of the rule.
      const double rounding = 1e-12 * walk.largest_force * radius;
      broken += !(std::abs(walk.work - walk.ledger()) <= walk.doubt + rounding);
      broken += !(lost() >= gone - rounding);
      broken += !(walk.now.force >= -(1 + 1e-9) * walk.now.pull_off);
      broken += !std::isfinite(walk.now.contact_radius);
      gone = lost();
    }
    walk.step(-10 * radius); // no adhesion of these paths reaches that far
    broken += walk.now.contact_radius > 0 || walk.now.force != 0;
    broken += !(lost() >= gone * (1 - 1e-12)); // rounding
    broken += law.energy(walk.overlap, walk.pair, walk.memory).elastic != 0;
  }
  EXPECT_EQ(broken, 0);
}

/// Packs give bit by bit what numbers give, and float what double gives within
/// 1e-4 of the force at the largest overlap.
template <class MakeLaw>
void expect_same_in_packs_and_float(const MakeLaw &make_law)
{
  RandomNumbers random(11);
  int parted = 0;
  constexpr int samples = 20000;
  for (int sample = 0; sample < samples; ++sample) {
    const auto law = make_law(random);
    const double radius = std::pow(10.0, -6 + 6 * random.next());
    const double reach = radius * std::pow(10.0, -5 + 4 * random.next());
    const double overlap = reach * (1.2 * random.next() - 0.1);
    const double touched = random.next() > 0.5 ? radius : 0;
    NormalMemory<double> memory{reach, touched};
    const auto answer = law(overlap, pair_of(radius), memory);

    using Pack = LanePack<double>;
    NormalMemory<Pack> packs{Pack(reach), Pack(touched)};
    const auto pack = law(Pack(overlap), pair_of<Pack>(radius), packs);
    ASSERT_EQ(pack.force.lane[3], answer.force);
    ASSERT_EQ(pack.contact_radius.lane[1], answer.contact_radius);
    ASSERT_EQ(pack.pull_off.lane[2], answer.pull_off);
    ASSERT_EQ(packs.largest_overlap.lane[0], memory.largest_overlap);

    NormalMemory<float> floats{float(reach), float(touched)};
    const auto rough = law(float(overlap), pair_of<float>(radius), floats);
    if ((rough.contact_radius > 0) != (answer.contact_radius > 0)) {
      ++parted;
      continue;
    }
    NormalMemory<double> at_peak{reach, radius};
    const auto peak = law(reach, pair_of(radius), at_peak);
    const double scale = std::abs(peak.force) + peak.pull_off;
    ASSERT_NEAR(rough.force, answer.force, 1e-4 * scale);
    ASSERT_NEAR(rough.contact_radius,
                answer.contact_radius,
                2e-3 * peak.contact_radius); // a root of the force's error
    ASSERT_NEAR(rough.pull_off, answer.pull_off, 1e-4 * scale);
  }
  // Float may see a touch or tear a little early or late.
  EXPECT_LT(parted, samples / 1000);
}
} // namespace tamp::dem

#endif
