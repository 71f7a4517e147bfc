// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/random_numbers.h>
#include <dem/time_step.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tamp::dem
{
namespace
{
/// Largest |x| among the last steps of an oscillator of unit mass that starts
/// at 1, over 2000 steps of the leapfrog.
double late_amplitude(double frequency, double ratio, double step, bool centred)
{
  double x = 1, v = 0, largest = 0;
  for (int n = 0; n < 2000; ++n) {
    const double push = -frequency * frequency * x, c = 2 * ratio * frequency;
    v = centred
            ? ((1 - 0.5 * c * step) * v + step * push) / (1 + 0.5 * c * step)
            : v + step * (push - c * v);
    x += step * v;
    if (n >= 1900)
      largest = std::max(largest, std::abs(x));
  }
  return largest;
}

TEST(StableTimeStep, IsWhereALateDashpotStartsToSwing)
{
  for (double ratio : {0.02, 0.3, 1.0, 3.0}) {
    const double bound = stable_time_step(100, ratio);
    // One per cent about the bound, growth over 2000 steps.
    EXPECT_LT(late_amplitude(100, ratio, 0.99 * bound, false), 1) << ratio;
    EXPECT_GT(late_amplitude(100, ratio, 1.01 * bound, false), 3) << ratio;
  }
}

TEST(StableTimeStep, CentredDampingLeavesTheBoundOfNoDamping)
{
  const double bound = stable_time_step(100, 0);
  EXPECT_DOUBLE_EQ(bound, 2.0 / 100);
  for (double ratio : {0.02, 0.3, 1.0, 3.0}) {
    EXPECT_LT(late_amplitude(100, ratio, 0.99 * bound, true), 1) << ratio;
    EXPECT_GT(late_amplitude(100, ratio, 1.01 * bound, true), 3) << ratio;
  }
}

TEST(StableTimeStep, NothingToSwingHasNoBound)
{
  EXPECT_EQ(stable_time_step(0, 0.5), std::numeric_limits<double>::infinity());
}

/// The contacts of a packing as linear springs with late dashpots of damping
/// ratio `beta`, between grains that vibrate about their places.
class Network
{
public:
  Network(const UnitCell &cell, double beta) : beta_(beta)
  {
    for (double r : cell.radius)
      mass_.push_back(r * r * r);
    number_.assign(mass_.size(), 0);
    for (const ContactForce &contact : contact_forces(cell)) {
      links_.push_back(contact.pair);
      ++number_[contact.pair.first];
      ++number_[contact.pair.second];
    }
  }
  double stiffness() const { return 1; }

  /// The smallest bound of a grain, its damping ratio being beta sqrt(Z) or
  /// left out.
  double bound(bool damped) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mass_.size(); ++i)
      smallest = std::min(
          smallest,
          stable_time_step(std::sqrt(2 * number_[i] * stiffness() / mass_[i]),
                           damped ? beta_ * std::sqrt(number_[i]) : 0));
    return smallest;
  }

  /// Kinetic energy after many steps over that of the random start.
  double energy_left(double step) const
  {
    RandomNumbers random(3);
    std::vector<Vector3> u(mass_.size(), Vector3::Zero()), v(u), f(u);
    for (Vector3 &velocity : v)
      for (double &component : velocity)
        component = random.next() - 0.5;
    for (std::size_t i = 0; i < v.size(); ++i)
      v[i] *= number_[i] > 0; // nothing stops a rattler
    const double before = energy(v);
    for (int n = 0; n < 400; ++n) {
      std::ranges::fill(f, Vector3::Zero());
      for (const auto &[i, j] : links_) {
        const double reduced = mass_[i] * mass_[j] / (mass_[i] + mass_[j]);
        const double dashpot = 2 * beta_ * std::sqrt(reduced * stiffness());
        const Vector3 force =
            stiffness() * (u[j] - u[i]) + dashpot * (v[j] - v[i]);
        f[i] += force;
        f[j] -= force;
      }
      for (std::size_t i = 0; i < u.size(); ++i) {
        v[i] += step / mass_[i] * f[i];
        u[i] += step * v[i];
      }
    }
    return energy(v) / before;
  }

private:
  double energy(const std::vector<Vector3> &v) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      sum += mass_[i] * v[i].squaredNorm();
    return sum;
  }

  double beta_;
  std::vector<double> mass_, number_; // number of links of a grain
  std::vector<Pair> links_;
};

TEST(StableTimeStep, KeepsAPackingWithHeavyContactDampingAtRest)
{
  // Restitution of about 0.2, with which 0.2 Rayleigh steps go wrong in
  // published codes.
  const Network network(test::alumina_cell(), 0.45);
  // Without the damping in the bound the packing blows up.
  EXPECT_LT(network.energy_left(0.9 * network.bound(true)), 1e-2);
  EXPECT_GT(network.energy_left(0.9 * network.bound(false)), 1e3);
}
} // namespace
} // namespace tamp::dem
