// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_return.h>

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace tamp::fem
{
namespace
{
using Surface = DruckerPragerCap::Surface;

/// Looks at the returns of trial states around surfaces of loose to dense
/// powder, up to ten times their size.
template <class Look>
void return_many(Look look)
{
  for (const double transition : {0., 0.02, 0.05})
    for (const double density : {0.31, 0.45, 0.6, 0.75, 0.9, 0.98}) {
      DruckerPragerCapParameters parameters;
      parameters.transition = transition;
      CapTables tables(parameters);
      const double compaction = std::log(density / 0.3);
      const auto start = tables.surface(compaction);
      const auto moduli = tables.moduli(compaction);
      const double size = start.centre.val() + start.strength.val();
      for (int i = -50; i <= 100; ++i)
        for (int j = 0; j <= 100; j += 2) {
          const double far = i % 2 == 0 ? 0.02 : 0.1; // near ones and far ones
          const CapTrial<double> trial{i * far * size,
                                       j * far * size,
                                       moduli.bulk.val(),
                                       moduli.shear.val(),
                                       compaction};
          look(trial, return_to_surface(tables, start, trial));
        }
    }
}

TEST(CapReturn, EveryTrialReturns)
{
  std::map<Surface, unsigned> count;
  return_many([&](const CapTrial<double> &trial, const CapReturn &found) {
    ASSERT_TRUE(found.converged)
        << "p " << trial.p << " q " << trial.q << " eps " << trial.compaction;
    ++count[found.surface];
  });
  for (const Surface surface : {Surface::none,
                                Surface::shear,
                                Surface::transition,
                                Surface::cap,
                                Surface::apex})
    EXPECT_GT(count[surface], 50u) << static_cast<int>(surface);
}

TEST(CapReturn, EndsOnTheSurfaceAlongItsFlow)
{
  return_many([](const CapTrial<double> &trial, const CapReturn &found) {
    if (found.surface == Surface::none || found.surface == Surface::apex)
      return;
    const auto s = values_of(found.at);
    const double x = found.compaction_change, p = trial.p - trial.bulk * x;
    const double q = found.surface == Surface::cap
                         ? s.top() * std::sin(found.position)
                         : found.position;
    const double size = s.radius() + s.top();
    // The return stops at 1e-14 of the size of the surface, at worst at 1e-10.
    ASSERT_NEAR(s.yield(p, q), 0, 1e-9 * size);
    // Never back: compaction on the cap, dilation on shear, shear as the trial.
    ASSERT_GE((found.surface == Surface::cap ? 1 : -1) * x, -1e-12);
    ASSERT_LE(q, trial.q * (1 + 1e-12) + 1e-9 * size);
    const double shear = (trial.q - q) / (3 * trial.shear);
    const auto flow = s.flow(p, q);
    ASSERT_NEAR(shear * flow.compaction,
                x * flow.shear,
                1e-8 * std::hypot(shear, x) *
                        std::hypot(flow.compaction, flow.shear) +
                    1e-9 * size / trial.shear * flow.shear)
        << "p " << trial.p << " q " << trial.q << " eps " << trial.compaction;
  });
}

TEST(CapReturn, SurfaceOfTheEndIsThatOfTheTables)
{
  DruckerPragerCapParameters parameters;
  CapTables tables(parameters);
  const DruckerPragerCap law(parameters);
  // Back and forth over many rows: lines that were kept must be given up.
  for (const double compaction : {0.1, 1.2, 0.11, -0.2, 0.5, 1.3, 0.7}) {
    const auto kept = tables.surface(compaction);
    const auto fresh = law.surface(compaction);
    EXPECT_EQ(kept.centre.val(), fresh.centre) << compaction;
    const double h = 1e-7;
    const double slope = (law.surface(compaction + h).centre -
                          law.surface(compaction - h).centre) /
                         (2 * h);
    // Differences of lines: round-off over h.
    EXPECT_NEAR(kept.centre.dx(0), slope, 1e-6 * std::abs(slope)) << compaction;
  }
}
} // namespace
} // namespace tamp::fem
