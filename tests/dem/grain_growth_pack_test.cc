// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_growth.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>
#include <vector>

namespace tamp::dem
{
namespace
{
/// A periodic pack of unequal grains without friction, disturbed from a
/// face-centred cubic one, in a cube. The smallest code that can press it.
class Pack
{
public:
  Pack(const Mdr &law, double onset) : law_(law), onset_(onset)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1, 1);
    const double site[4][3] = {
        {0, 0, 0}, {0, .5, .5}, {.5, 0, .5}, {.5, .5, 0}};
    for (int cell = 0; cell < 8; ++cell)
      for (const auto &s : site) {
        initial_.push_back(1 + 0.15 * share(random));
        place_.push_back(
            0.5 *
                Vector3(s[0] + cell % 2, s[1] + cell / 2 % 2, s[2] + cell / 4) +
            0.02 * Vector3(share(random), share(random), share(random)));
        solid_ += 4.0 / 3 * std::numbers::pi * std::pow(initial_.back(), 3);
      }
    radius_ = initial_;
  }

  /// One increment to a relative density; the pressure after it.
  double press(double density)
  {
    edge_ = std::cbrt(solid_ / density);
    settle();
    std::vector<GrownContact> contacts;
    std::vector<double> more;
    std::map<Pair, Memory> touching;
    visit([&](Pair pair, const Vector3 &way) {
      Memory memory = remembered(pair);
      push(pair, way, memory);
      contacts.push_back({{pair, way}, memory.largest});
      more.insert(more.end(), memory.more.begin(), memory.more.end());
      touching[pair] = memory;
    });
    const GrainGrowth growth =
        grow_grains(law_, {radius_, initial_}, contacts, more, onset_);
    radius_ = growth.radius;
    memory_.clear();
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      Memory memory = touching[contacts[c].branch.pair];
      std::copy_n(
          growth.more.begin() + c * Mdr::more, Mdr::more, memory.more.begin());
      memory_[contacts[c].branch.pair] = memory;
    }
    return pressure_;
  }

  bool is_settled() const { return settled_; }

private:
  struct Memory {
    double largest = 0;
    std::array<double, Mdr::more> more = {};
  };

  Memory remembered(Pair pair) const
  {
    const auto found = memory_.find(pair);
    return found == memory_.end() ? Memory() : found->second;
  }

  template <class Visitor>
  void visit(Visitor &&visitor) const
  {
    for (std::uint32_t i = 0; i < place_.size(); ++i)
      for (std::uint32_t j = i + 1; j < place_.size(); ++j) {
        Vector3 way = place_[j] - place_[i];
        way = edge_ * (way - way.array().round().matrix());
        if (way.norm() < radius_[i] + radius_[j])
          visitor(Pair{i, j}, way);
      }
  }

  double push(Pair pair, const Vector3 &way, Memory &memory) const
  {
    const double one = radius_[pair.first], two = radius_[pair.second];
    NormalMemory<double> normal = {memory.largest, 0, memory.more.data()};
    const double force =
        law_(one + two - way.norm(),
             {one + two, one * two / (one + two), two - one, 0},
             normal)
            .force;
    memory.largest = normal.largest_overlap;
    return force;
  }

  /// Forces on the grains [N]; takes the pressure, and the mean force.
  std::vector<Vector3> forces(double &mean)
  {
    std::vector<Vector3> force(place_.size(), Vector3::Zero());
    int count = 0;
    pressure_ = mean = 0;
    visit([&](Pair pair, const Vector3 &way) {
      Memory trial = remembered(pair);
      const double normal = push(pair, way, trial);
      const Vector3 vector = normal / way.norm() * way;
      force[pair.first] -= vector;
      force[pair.second] += vector;
      pressure_ += vector.dot(way) / (3 * std::pow(edge_, 3));
      mean += normal;
      ++count;
    });
    mean /= std::max(count, 1);
    return force;
  }

  /// Moves the grains to equilibrium, by inertia that is stopped uphill.
  void settle()
  {
    constexpr double balance = 1e-3; // of the mean contact force
    std::vector<Vector3> velocity(place_.size(), Vector3::Zero());
    const double first = 0.1 / std::sqrt(law_.flat().modulus());
    double step = first;
    for (int sweep = 0; sweep < 2000; ++sweep) {
      double mean, power = 0, square = 0;
      const std::vector<Vector3> force = forces(mean);
      for (std::size_t g = 0; g < force.size(); ++g) {
        power += force[g].dot(velocity[g]);
        square += force[g].squaredNorm();
      }
      settled_ = std::sqrt(square / force.size()) <= balance * mean;
      if (settled_)
        return;
      step = power < 0 ? 0.5 * step : std::min(1.05 * step, 6 * first);
      for (std::size_t g = 0; g < force.size(); ++g) {
        if (power < 0)
          velocity[g].setZero();
        velocity[g] = 0.95 * velocity[g] + step * force[g];
        place_[g] += step / edge_ * velocity[g];
      }
    }
  }

  Mdr law_;
  double onset_, edge_ = 0, solid_ = 0, pressure_ = 0;
  bool settled_ = false;
  std::vector<double> initial_, radius_;
  std::vector<Vector3> place_;
  std::map<Pair, Memory> memory_;
};

/// Pressures [Pa] at a few relative densities, by equal parts, and whether all
/// increments past the first rearrangements settled.
std::vector<double>
pressures(const Mdr &law, double onset, double part, bool &settled)
{
  Pack pack(law, onset);
  std::vector<double> result;
  settled = true;
  double density = 0.70;
  for (double next : {.80, .90, .95, 1.0}) {
    const int parts = static_cast<int>(std::lround((next - density) / part));
    double pressure = 0;
    for (int i = 1; i <= parts; ++i) {
      pressure = pack.press(density + (next - density) * i / parts);
      settled = settled && (pack.is_settled() || next < 0.85);
    }
    density = next;
    result.push_back(pressure);
  }
  return result;
}

TEST(GrainGrowthPack, DoesNotDependOnTheIncrements)
{
  // Explicit coupling of first order; a ratchet of grains that overshoot would
  // show as a fall of the pressure that grows with the number of increments.
  constexpr double tolerance = 0.03;
  const Mdr soft(1e9, 0.3, 50e6);
  bool fine_settled, coarse_settled;
  const auto fine = pressures(soft, 0.6, 1.25e-3, fine_settled);
  const auto coarse = pressures(soft, 0.6, 5e-3, coarse_settled);
  EXPECT_TRUE(fine_settled);
  EXPECT_TRUE(coarse_settled);
  for (std::size_t k = 0; k < fine.size(); ++k) {
    EXPECT_NEAR(coarse[k] / fine[k], 1, tolerance) << k;
  }
}

TEST(GrainGrowthPack, SettlesWithHardGrainsThroughTheLockUp)
{
  // A coupling that is too soft within the increment blows up here.
  const Mdr hard(70e9, 0.3, 100e6);
  bool settled;
  const auto pressure = pressures(hard, 0.2, 5e-3, settled);
  EXPECT_TRUE(settled);
  for (std::size_t k = 1; k < pressure.size(); ++k)
    EXPECT_GT(pressure[k], pressure[k - 1]);
}
} // namespace
} // namespace tamp::dem
