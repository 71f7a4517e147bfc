// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_law_paths_h
#define tests_dem_laws_law_paths_h

#include <dem/laws/pair_law.h>
#include <dem/random_numbers.h>

#include <cmath>
#include <gtest/gtest.h>

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

/// What a law says of its losses: none ever shrinks, or that a path from no
/// contact to no contact loses in all.
enum class Losses { grow, on_closed_paths };

/// Walks a random path and counts what is wrong: numbers that are not finite,
/// work that is not in the ledger, losses that shrink, grains that do not part,
/// work that a closed path gives away.
/// @param losses  what of it holds
template <class Law>
int count_broken(const Law &law,
                 double radius,
                 Losses losses,
                 RandomNumbers &random)
{
  constexpr int parts = 12;
  const double reach = radius * std::pow(10.0, -5 + 4 * random.next());
  Walk<Law> walk{law, pair_of(radius)};
  const auto lost = [&] {
    return walk.lost +
           law.energy(walk.overlap, walk.pair, walk.memory).dissipated;
  };
  int broken = 0;
  double gone = 0;
  for (int leg = 0; leg < 4; ++leg) {
    walk.go(reach * (1.5 * random.next() - 0.5), parts);
    // Rounding of energies that cancel, and the doubt of the rule.
    const double rounding = 1e-12 * walk.largest_force * radius;
    broken += !(std::abs(walk.work - walk.ledger()) <= walk.doubt + rounding);
    broken += losses == Losses::grow && !(lost() >= gone - rounding);
    broken += !(walk.now.force >= -(1 + 1e-9) * walk.now.pull_off);
    broken += !std::isfinite(walk.now.contact_radius);
    gone = lost();
  }
  walk.step(-1e3 * radius); // no adhesion of these paths reaches that far
  broken += walk.now.contact_radius > 0 || walk.now.force != 0;
  broken +=
      losses == Losses::grow && !(lost() >= gone * (1 - 1e-12)); // rounding
  broken += !(lost() >= 0);
  broken += law.energy(walk.overlap, walk.pair, walk.memory).elastic != 0;
  return broken;
}

/// Nothing is wrong on 1e5 random paths.
template <class MakeLaw>
void expect_no_gain_on_random_paths(const MakeLaw &make_law)
{
  RandomNumbers random(7);
  int broken = 0;
  for (int path = 0; path < 100000; ++path) {
    const auto law = make_law(random);
    const double radius = std::pow(10.0, -6 + 6 * random.next());
    broken += count_broken(law, radius, Losses::grow, random);
  }
  EXPECT_EQ(broken, 0);
}
} // namespace tamp::dem

#endif
