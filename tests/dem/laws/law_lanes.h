// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_law_lanes_h
#define tests_dem_laws_law_lanes_h

#include <tests/dem/laws/lane_pack.h>
#include <tests/dem/laws/law_paths.h>

namespace tamp::dem
{
/// Packs give what numbers give, and float what double gives within
/// 1e-4 of the force at the largest overlap. A lane without a pair, R* = 0,
/// gives nothing.
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

    NormalMemory<double> at_peak{reach, radius};
    const auto peak = law(reach, pair_of(radius), at_peak);
    const double scale = std::abs(peak.force) + peak.pull_off;

    using Pack = LanePack<double>;
    NormalMemory<Pack> packs{Pack(reach), Pack(touched)};
    const auto pack = law(Pack(overlap), pair_of<Pack>(radius), packs);
    // Compilers may contract a * b + c in one and not in the other.
    ASSERT_NEAR(pack.force.lane[3], answer.force, 1e-9 * scale);
    ASSERT_NEAR(pack.contact_radius.lane[1],
                answer.contact_radius,
                1e-6 * peak.contact_radius); // a root of the force's error
    ASSERT_NEAR(pack.pull_off.lane[2], answer.pull_off, 1e-9 * scale);
    ASSERT_EQ(packs.largest_overlap.lane[0], memory.largest_overlap);

    NormalMemory<float> floats{float(reach), float(touched)};
    const auto rough = law(float(overlap), pair_of<float>(radius), floats);
    if ((rough.contact_radius > 0) != (answer.contact_radius > 0)) {
      ++parted;
      continue;
    }
    ASSERT_NEAR(rough.force, answer.force, 1e-4 * scale);
    ASSERT_NEAR(rough.contact_radius,
                answer.contact_radius,
                2e-3 * peak.contact_radius); // a root of the force's error
    ASSERT_NEAR(rough.pull_off, answer.pull_off, 1e-4 * scale);
  }
  for (const double touched : {0.0, 1e-6}) {
    NormalMemory<double> memory{0, touched};
    const auto none = make_law(random)(-1e-3, pair_of(0), memory);
    EXPECT_EQ(none.force, 0);
    EXPECT_EQ(none.contact_radius, 0);
    EXPECT_EQ(none.pull_off, 0);
  }
  // Float may see a touch or tear a little early or late.
  EXPECT_LT(parted, samples / 1000);
}
} // namespace tamp::dem

#endif
