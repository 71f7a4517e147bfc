// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_growth.h>
#include <dem/laws/thornton_ning.h>
#include <tests/dem/growing_sphere.h>

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
constexpr double never = 0; // onset of bulk response that no grain reaches

/// One grain of a periodic array. It touches its own images across `axes`, so
/// that each of its flats is halfway to one of them.
struct Array {
  explicit Array(int axes, const Mdr &contact_law = soft)
      : law(contact_law), more(axes * Mdr::more, 0.0), largest(axes, 0.0)
  {
  }
  Mdr law;
  std::vector<double> more, largest;
  double R = R_o, free_surface = 1, onset = 0.5;
  bool pairwise = false;

  /// Presses the flats to distances h from the centre; the forces then.
  std::vector<double> press(const std::vector<double> &h)
  {
    const PairShape<double> pair = {2 * R, R / 2, 0, 0};
    std::vector<double> force;
    std::vector<GrownContact> contacts;
    for (std::size_t k = 0; k < h.size(); ++k) {
      NormalMemory<double> memory = {
          largest[k], 0, more.data() + k * Mdr::more};
      const double overlap = 2 * (R - h[k]);
      force.push_back(law(overlap, pair, memory).force);
      largest[k] = memory.largest_overlap;
      contacts.push_back(
          {{{0, 0}, 2 * h[k] * Vector3::Unit(k % 3)}, largest[k]});
    }
    if (pairwise)
      return force;
    const std::vector<double> apparent = {R}, initial = {R_o};
    const GrainGrowth growth =
        grow_grains(law, {apparent, initial}, contacts, more, onset);
    R = growth.radius[0];
    more = growth.more;
    free_surface = growth.free_surface[0];
    return force;
  }
};

/// Distance of the flats in a simple cubic array of a relative density.
double cubic_distance(double density)
{
  return 0.5 * std::cbrt(ball(R_o) / density);
}

/// R at which the volume balance holds for n yielded flats, without increments:
/// caps since yield, and the elastic change of volume, in closed form.
double balanced(double h, int n)
{
  const double yield = soft.flat().yield_ratio() * R_o, h_Y = R_o - yield;
  const auto push = [&](double R, double distance) {
    return soft.flat().peak(R - distance, R).force * distance;
  };
  const double start = soft.flat().peak(yield, R_o).force * h_Y;
  double low = R_o, high = 1.3 * R_o;
  for (int i = 0; i < 100; ++i) {
    const double R = 0.5 * (low + high);
    const double excess = ball(R) - ball(R_o) -
                          n * (cap(R, h) - cap(R_o, h_Y)) +
                          n * (push(R, h) - start) / (3 * soft.bulk_modulus());
    (excess < 0 ? low : high) = R;
  }
  return low;
}

double compressed_radius(int axes, double h_end, int increments)
{
  Array array(axes);
  array.onset = never;
  for (int i = 1; i <= increments; ++i)
    array.press(
        std::vector<double>(axes, R_o + (h_end - R_o) * i / increments));
  return array.R;
}

/// Flats of a simple cubic array, pressed alike or along the last axis only.
std::vector<double> flats(double density, bool uniaxial)
{
  if (uniaxial)
    return {R_o, R_o, R_o * pi / 6 / density};
  return std::vector<double>(3, cubic_distance(density));
}

/// Takes an array from one density to another, by parts of at most `part`.
template <class Grain>
std::vector<double>
drive(Grain &grain, double from, double to, double part, bool uniaxial)
{
  const int parts = static_cast<int>(std::ceil(std::abs(to - from) / part));
  std::vector<double> force;
  for (int i = 1; i <= parts; ++i)
    force = grain.press(flats(from + (to - from) * i / parts, uniaxial));
  return force;
}

constexpr double loose = pi / 6; // density of a simple cubic array

TEST(GrainGrowth, FollowsTheVolumeBalance)
{
  // The explicit coupling is of first order: up to 0.8 % of the growth with the
  // finer parts, about an eighth of what the coarser ones miss.
  constexpr double tolerance = 1e-2, order = 5;
  for (int axes : {3, 4, 6}) {
    SCOPED_TRACE(axes);
    const double h = axes == 6 ? 0.465 : 0.44;
    const double exact = balanced(h, 2 * axes) / R_o - 1;
    const double coarse = compressed_radius(axes, h, 50) / R_o - 1;
    const double fine = compressed_radius(axes, h, 400) / R_o - 1;
    EXPECT_GT(exact, 1e-3);
    EXPECT_NEAR(fine / exact, 1, tolerance);
    EXPECT_LT(std::abs(fine - exact), std::abs(coarse - exact) / order);
  }
}

TEST(GrainGrowth, VolumeBalanceIsTheIntegralOfThePublishedRate)
{
  constexpr double tolerance = 2e-4; // of the growth; steps of the integration
  for (double h : {.46, .45, .44, .43})
    EXPECT_NEAR((integrated_rate(h, 6) / R_o - 1) / (balanced(h, 6) / R_o - 1),
                1,
                tolerance);
}

TEST(GrainGrowth, KeepsTheVolumeInIncrementsOfAnySize)
{
  constexpr double tolerance = 1e-12; // of the grain; rounding
  for (int increments : {7, 40, 300}) {
    Array array(3);
    array.onset = never;
    const double yield = soft.flat().yield_ratio() * R_o, h_Y = R_o - yield;
    const double start = ball(R_o) - 6 * cap(R_o, h_Y) +
                         6 * soft.flat().peak(yield, R_o).force * h_Y /
                             (3 * soft.bulk_modulus());
    double grown = 0;
    for (int i = 1; i <= increments; ++i) {
      const double h = R_o - 0.07 * i / increments, before = array.R;
      const double force = array.press({h, h, h})[0];
      if (array.R > before) {
        const double now = ball(array.R) - 6 * cap(array.R, h) +
                           6 * force * h / (3 * soft.bulk_modulus());
        EXPECT_NEAR(now / start, 1, tolerance);
        ++grown;
      }
    }
    EXPECT_GT(grown, 0);
  }
}

TEST(GrainGrowth, LocksUpNearFullDensity)
{
  Array grown(3), pairwise(3);
  pairwise.pairwise = true;
  const ThorntonNing simple(soft.flat().modulus() / 2, 2.8 * 50e6);
  const double D = 0.98, h = cubic_distance(D);
  const double with = drive(grown, loose, D, 1e-3, false)[0];
  const double without = drive(pairwise, loose, D, 1e-3, false)[0];
  NormalMemory<double> memory = {0, 0, nullptr};
  const double plain =
      simple(2 * (R_o - h), {2 * R_o, R_o / 2, 0, 0}, memory).force;
  EXPECT_GT(with, 1.6 * without);
  EXPECT_GT(with, 1.6 * plain);

  // dp / d ln D next to full density: kappa if contacts covered the faces of
  // the cell; they cover 0.6 of them, and the slope goes with the square.
  const auto slope = [](Array &array) {
    const double low = 0.98, high = 1.0;
    const auto pressure = [](double force, double density) {
      return force / std::pow(2 * cubic_distance(density), 2);
    };
    const double before =
        pressure(drive(array, 0.979, low, 1e-3, false)[0], low);
    const double after =
        pressure(drive(array, low, high, 1e-3, false)[0], high);
    return (after - before) / std::log(high / low);
  };
  const double locked = slope(grown) / soft.bulk_modulus();
  EXPECT_GT(locked, 0.25);
  EXPECT_LT(locked, 1);
  EXPECT_LT(slope(pairwise) / soft.bulk_modulus(), 0.1);
}

TEST(GrainGrowth, BulkForceIsKappaTimesTheVolumeThatFlatsTake)
{
  constexpr double tolerance = 1e-2; // explicit, of first order in the parts
  Array array(3);
  double D = loose, at_onset = 0;
  while (array.free_surface > array.onset) {
    D += 1e-3;
    at_onset = array.press(flats(D, false))[0];
  }
  const double h_0 = cubic_distance(D);
  double before = 0;
  for (double next : {.92, .96, 1.0, 1.1}) {
    const double force = drive(array, D, next, 1e-3, false)[0];
    D = next;
    const double h = cubic_distance(D), R = array.R;
    const double share = soft.flat().yield_ratio();
    const double area = pi * (R * R - h * h - share * (1 - share) * R * R);
    const double volume = std::min(ball(R_o), ball(R) - 6 * cap(R, h));
    const double bulk =
        soft.bulk_modulus() * 6 * area / volume * (h_0 - h) * area;
    EXPECT_NEAR(force / (at_onset + bulk), 1, tolerance) << D;
    EXPECT_GT(bulk, before);
    before = bulk;
  }
}

TEST(GrainGrowth, GivesTheBulkPartBackInUnloading)
{
  for (bool uniaxial : {false, true}) {
    Array array(3);
    drive(array, loose, 1.0, 1e-3, uniaxial);
    const double R = array.R;
    const auto bulk = [&](int axis) {
      return MdrMemory<double>::read(array.more.data() + axis * Mdr::more)
          .bulk_overlap;
    };
    EXPECT_GT(bulk(2), 0.01 * R_o);
    const auto force = drive(array, 1.0, 0.75, 1e-3, uniaxial);
    EXPECT_EQ(force[2], 0);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(bulk(axis), 0);
    EXPECT_EQ(array.R, R); // and a grain never shrinks
  }
}

/// Work of an array on its flats around a cycle of densities, and the sum of
/// its magnitudes, by the trapezoidal rule.
std::array<double, 2> cycle_work(double part, bool uniaxial)
{
  Array array(3);
  const double low = 0.94, high = 1.0;
  drive(array, loose, high, part, uniaxial);
  auto before = drive(array, high, low, part, uniaxial);
  auto place = flats(low, uniaxial);
  double work = 0, gross = 0;
  const int parts = static_cast<int>(std::lround((high - low) / part));
  for (int i = 1; i <= 2 * parts; ++i) {
    const double share = 1 - std::abs(1 - static_cast<double>(i) / parts);
    const auto next = flats(low + (high - low) * share, uniaxial);
    const auto force = array.press(next);
    for (int axis = 0; axis < 3; ++axis) {
      const double done =
          0.5 * (force[axis] + before[axis]) * (place[axis] - next[axis]);
      work += done;
      gross += std::abs(done);
    }
    before = force;
    place = next;
  }
  return {work, gross};
}

TEST(GrainGrowth, CyclesGainNoEnergyAndLoseLessInSmallerParts)
{
  // The explicit coupling loses below a per cent of the work with parts of 1e-3
  // in density, of first order in the parts.
  constexpr double tolerance = 1e-2, order = 3;
  for (bool uniaxial : {false, true}) {
    const auto coarse = cycle_work(1e-3, uniaxial);
    const auto fine = cycle_work(2.5e-4, uniaxial);
    EXPECT_GE(coarse[0], 0);
    EXPECT_GE(fine[0], 0);
    EXPECT_LT(coarse[0], tolerance * coarse[1]);
    EXPECT_LT(fine[0] / fine[1], coarse[0] / coarse[1] / order);
  }
}

TEST(GrainGrowth, ElasticContactsDoNotGrow)
{
  Array array(3);
  const double h = R_o * (1 - 0.9 * soft.flat().yield_ratio());
  for (int i = 1; i <= 20; ++i) {
    const double now = R_o + (h - R_o) * i / 20;
    EXPECT_GT(array.press({now, now, now})[0], 0);
  }
  EXPECT_EQ(array.R, R_o);
}

TEST(GrainGrowth, StopsAtItsLimits)
{
  // One flat pair, which leaves most of the surface free, in absurd increments.
  Array array(1);
  array.onset = never;
  for (double h : {.4, .3, .2, .1, .05, .02}) {
    const double before = array.R;
    array.press({h});
    EXPECT_GE(array.R, before);
    EXPECT_LE(array.R, 1.5 * R_o);
    EXPECT_TRUE(std::isfinite(array.R));
  }
}

TEST(GrainGrowth, KnowsWhichGrainIsWhich)
{
  // A chain of unequal grains; the contacts in any order, the same answer.
  constexpr double tolerance = 1e-14; // sums in another order
  const std::vector<double> radius = {.5, .2, .4};
  const double distance[3] = {.61, .88, .48}; // 0 to 1, 0 to 2, 1 to 2
  const double x = (.61 * .61 - .48 * .48 + .88 * .88) / (2 * .88);
  const Vector3 one(x, std::sqrt(.61 * .61 - x * x), 0), two(.88, 0, 0);
  std::vector<GrownContact> contacts = {
      {{{0, 1}, one}, .09}, {{{0, 2}, two}, .02}, {{{1, 2}, two - one}, .15}};
  std::vector<double> more;
  for (int k = 0; k < 3; ++k) {
    const Pair pair = contacts[k].branch.pair;
    const double first = radius[pair.first], second = radius[pair.second];
    std::array<double, Mdr::more> own = {};
    NormalMemory<double> memory = {0, 0, own.data()};
    for (double overlap :
         {contacts[k].largest_overlap, first + second - distance[k]})
      soft(overlap,
           {first + second,
            first * second / (first + second),
            second - first,
            0},
           memory);
    more.insert(more.end(), own.begin(), own.end());
  }
  const GrainGrowth growth =
      grow_grains(soft, {radius, radius}, contacts, more);
  EXPECT_GT(growth.radius[1], radius[1]); // pressed by 0, and small
  EXPECT_EQ(growth.radius[2], radius[2]); // elastic there, unloaded here
  // Grain 1 lies between the others.
  EXPECT_LT(growth.more[1 * Mdr::more - 1], 0.1);
  EXPECT_GT(growth.more[2 * Mdr::more - 1], 0.9);
  for (double psi : growth.free_surface) {
    EXPECT_GT(psi, 0.5);
    EXPECT_LT(psi, 1);
  }
  std::reverse(contacts.begin(), contacts.end());
  std::vector<double> reversed;
  for (int c = 2; c >= 0; --c)
    reversed.insert(reversed.end(),
                    more.begin() + c * Mdr::more,
                    more.begin() + (c + 1) * Mdr::more);
  const GrainGrowth other =
      grow_grains(soft, {radius, radius}, contacts, reversed);
  for (int g = 0; g < 3; ++g)
    EXPECT_NEAR(other.radius[g], growth.radius[g], tolerance);
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < Mdr::more; ++k)
      EXPECT_NEAR(other.more[(2 - c) * Mdr::more + k],
                  growth.more[c * Mdr::more + k],
                  tolerance * std::abs(growth.more[c * Mdr::more + k]));
}
} // namespace
} // namespace tamp::dem
