// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/mindlin_deresiewicz.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace tamp::dem
{
namespace
{
using Law = MindlinDeresiewicz;
using Vector = Triple<double>;

double length(const Vector &a)
{
  return std::sqrt(dot(a, a));
}

/// One contact of two elastic spheres that is pressed and slipped by hand.
struct Rubbing {
  Law law{3e9, 0.4};
  double modulus = 8e9, radius = 5e-5; // E*, R*
  Vector normal{1.0 / 3, 2.0 / 3, -2.0 / 3};
  Vector along{2.0 / 3, 1.0 / 3, 2.0 / 3}, aside{-2.0 / 3, 2.0 / 3, 1.0 / 3};

  Vector force{0, 0, 0};
  std::array<double, Law::more> memory{};
  double overlap = 0, heat = 0, work = 0;

  double contact_radius() const { return std::sqrt(radius * overlap); }
  double push() const { return 4.0 / 3 * modulus * contact_radius() * overlap; }
  double limit() const { return law.friction_coefficient * push(); }
  double stiffness() const { return law.stiffness(contact_radius()); }
  double depth() const { return 1.5 * limit() / stiffness(); }

  /// Changes the overlap and slips, as one increment. Answers with T, and
  /// writes the memory.
  Vector move(double new_overlap, const Vector &slip)
  {
    ContactMotion<double> now{};
    now.normal = normal;
    now.slip = slip;
    now.old_radius = contact_radius();
    overlap = new_overlap;
    now.push = {push(), contact_radius(), 0};
    std::array<double, Law::more> copy = memory;
    now.slip = {0, 0, 0}; // the normal force changes first
    const Vector pressed = law(force, now, copy.data()).force;
    now.slip = slip;
    const auto answer = law(force, now, memory.data());
    work += 0.5 * dot(pressed + answer.force, slip);
    force = answer.force;
    heat += answer.lost_work;
    return force;
  }
  double slip_to(double from, double to, int parts)
  {
    for (int k = 0; k < parts; ++k)
      move(overlap, ((to - from) / parts) * along);
    return dot(force, along);
  }
};

double rise(double x)
{
  return 1 - std::pow(1 - x, 1.5);
}

TEST(MindlinDeresiewicz, LoopLosesWhatJohnsonSaysForAnyIncrement)
{
  for (const int parts : {1, 1000}) {
    Rubbing pair;
    pair.move(1e-6, {0, 0, 0});
    const double d = 0.8 * pair.depth(), limit = pair.limit();
    // The closed form is exact for any increment: round-off only.
    const double tolerance = 1e-9 * limit;
    EXPECT_NEAR(pair.slip_to(0, d, parts), rise(0.8) * limit, tolerance);
    EXPECT_NEAR(pair.slip_to(0, d, 0), 0.91056 * limit, 1e-5 * limit);
    EXPECT_NEAR(pair.slip_to(d, -d, parts), -rise(0.8) * limit, tolerance);
    pair.heat = pair.work = 0;
    EXPECT_NEAR(pair.slip_to(-d, d, parts), rise(0.8) * limit, tolerance);
    EXPECT_NEAR(pair.slip_to(d, -d, parts), -rise(0.8) * limit, tolerance);
    const double t = rise(0.8), c = std::cbrt(1 - t);
    const double loss = 9 * limit * limit / (10 * pair.stiffness() / 8) *
                        (1 - std::pow(c, 5) - 5 * t / 6 * (1 + c * c));
    EXPECT_NEAR(pair.heat, loss, 1e-9 * loss); // closed form as well
    if (parts > 1) {
      EXPECT_NEAR(pair.work, loss, 1e-3 * loss); // trapezoids of 1000 parts
    }
  }
}

TEST(MindlinDeresiewicz, UnloadingFollowsClosedForm)
{
  Rubbing pair;
  pair.move(1e-6, {0, 0, 0});
  const double m = pair.depth(), limit = pair.limit();
  const double top = pair.slip_to(0, 0.7 * m, 1);
  for (const double at : {0.6, 0.2, -0.1, -0.6}) {
    Rubbing copy = pair;
    EXPECT_NEAR(copy.slip_to(0.7 * m, at * m, 3),
                top - 2 * limit * rise((0.7 - at) / 2),
                1e-12 * limit); // round-off
  }
  // Beyond the opposite turning point the first loading goes on.
  EXPECT_NEAR(
      pair.slip_to(0.7 * m, -0.9 * m, 1), -rise(0.9) * limit, 1e-12 * limit);
}

TEST(MindlinDeresiewicz, ReloadingReturnsToTurningPointAndGoesOn)
{
  for (const int parts : {1, 77}) {
    Rubbing pair;
    pair.move(1e-6, {0, 0, 0});
    const double m = pair.depth(), limit = pair.limit();
    const double top = pair.slip_to(0, 0.7 * m, parts);
    pair.slip_to(0.7 * m, 0.2 * m, parts);
    Rubbing copy = pair;
    EXPECT_NEAR(copy.slip_to(0.2 * m, 0.7 * m, parts), top, 1e-11 * limit);
    EXPECT_NEAR(pair.slip_to(0.2 * m, 0.9 * m, parts),
                rise(0.9) * limit,
                1e-11 * limit); // round-off of a closed form
  }
}

TEST(MindlinDeresiewicz, BeginsWithStiffnessOfMindlinInEveryDirection)
{
  Rubbing pair;
  pair.move(1e-6, {0, 0, 0});
  const double k = pair.stiffness(), step = 1e-6 * pair.depth();
  const double tolerance = 1e-5 * k * step; // the curve bends by step / depth
  Rubbing fresh = pair;
  EXPECT_NEAR(
      length(fresh.move(1e-6, step * pair.aside) - (k * step) * pair.aside),
      0,
      tolerance);
  pair.slip_to(0, 0.5 * pair.depth(), 1);
  const Vector old = pair.force;
  Rubbing turned = pair, crossed = pair, onward = pair;
  const auto gain = [&](Rubbing &p, const Vector &s) {
    return p.move(1e-6, s) - old;
  };
  EXPECT_NEAR(dot(gain(turned, (-step) * pair.along), pair.along),
              -k * step,
              tolerance);
  EXPECT_NEAR(
      dot(gain(crossed, step * pair.aside), pair.aside), k * step, tolerance);
  const double core = std::sqrt(0.5); // theta^2 = 1 - slip / depth
  EXPECT_NEAR(dot(gain(onward, step * pair.along), pair.along),
              core * k * step,
              tolerance);
}

TEST(MindlinDeresiewicz, ObliqueIncrementSlipsAlongForceAndSticksAcross)
{
  Rubbing pair;
  pair.move(1e-6, {0, 0, 0});
  const double k = pair.stiffness(), step = 1e-6 * pair.depth();
  pair.slip_to(0, 0.5 * pair.depth(), 1);
  const Vector old = pair.force;
  pair.move(1e-6, (0.6 * step) * pair.along + (0.8 * step) * pair.aside);
  const Vector gain = pair.force - old;
  const double tolerance = 1e-5 * k * step; // second order in the step
  EXPECT_NEAR(
      dot(gain, pair.along), std::sqrt(0.5) * 0.6 * k * step, tolerance);
  EXPECT_NEAR(dot(gain, pair.aside), 0.8 * k * step, tolerance);
}

TEST(MindlinDeresiewicz, ForceIsContinuousInTheIncrement)
{
  // Around a circle of slips the force moves no faster than k times the slip,
  // by twice at most where old and new curves add.
  Rubbing pair;
  pair.move(1e-6, {0, 0, 0});
  pair.slip_to(0, 0.6 * pair.depth(), 1);
  pair.slip_to(0.6 * pair.depth(), 0.3 * pair.depth(), 1);
  constexpr int parts = 20000;
  const double radius = 0.5 * pair.depth(), turn = 2 * std::numbers::pi / parts;
  const auto at = [&](int i) {
    Rubbing copy = pair;
    return copy.move(1.3e-6,
                     (radius * std::cos(i * turn)) * pair.along +
                         (radius * std::sin(i * turn)) * pair.aside);
  };
  Vector last = at(0);
  double fastest = 0;
  for (int i = 1; i <= parts; ++i) {
    const Vector here = at(i);
    fastest = std::max(fastest, length(here - last));
    last = here;
  }
  EXPECT_LT(fastest, 2.5 * pair.stiffness() * std::sqrt(1.3) * radius * turn);
}

TEST(MindlinDeresiewicz, TinyOldForceChangesNothing)
{
  Rubbing clean, stray;
  clean.move(1e-6, {0, 0, 0});
  stray.move(1e-6, {0, 0, 0});
  const double m = clean.depth(), limit = clean.limit();
  stray.move(1e-6, (1e-6 * m) * stray.along);
  const Vector slip = (0.8 * m) * clean.aside;
  const double d = length(clean.move(1.2e-6, slip) - stray.move(1.2e-6, slip));
  EXPECT_LT(d, 1e-5 * limit); // of the order of the stray slip
}

TEST(MindlinDeresiewicz, SticksWhileNormalForceOutgrowsTangential)
{
  Rubbing pair;
  pair.move(1e-6, {0, 0, 0});
  pair.slip_to(0, 0.6 * pair.depth(), 1);
  const double old = dot(pair.force, pair.along), push = pair.push();
  pair.move(1e-6 * (1 + 1e-5), {0, 0, 0});
  const double room = pair.law.friction_coefficient * (pair.push() - push);
  EXPECT_NEAR(dot(pair.force, pair.along), old, 1e-12 * old);
  const double slip = 0.9 * room / pair.stiffness();
  pair.move(pair.overlap, slip * pair.along);
  EXPECT_NEAR(dot(pair.force, pair.along) - old,
              0.9 * room,
              1e-4 * room); // to first order in the rise
}

TEST(MindlinDeresiewicz, SmallIncrementsAreThoseOfThorntonAndYin)
{
  // dT = 8 G* a theta ds +- mu (1 - theta) dN, in loading, unloading and
  // reloading, the normal force rising and falling.
  for (const double change : {2e-6, -2e-6})
    for (const int branch : {0, 1, 2}) {
      SCOPED_TRACE(testing::Message() << change << " " << branch);
      Rubbing pair;
      pair.move(1e-6, {0, 0, 0});
      const double m = pair.depth(), limit = pair.limit();
      pair.slip_to(0, 0.6 * m, 1);
      if (branch > 0)
        pair.slip_to(0.6 * m, -0.2 * m, 1);
      if (branch > 1)
        pair.slip_to(-0.2 * m, 0.3 * m, 1);
      const double sign = branch == 1 ? -1 : 1;
      const double x = std::array{0.6, 0.4, 0.25}[branch];
      const double theta = std::sqrt(1 - x), step = 1e-5 * m;
      const double old = dot(pair.force, pair.along), push = pair.push();
      pair.move(1e-6 * (1 + change), (sign * step) * pair.along);
      const double grown = pair.law.friction_coefficient * (pair.push() - push);
      const double wanted =
          pair.stiffness() * theta * sign * step + sign * (1 - theta) * grown;
      EXPECT_NEAR(dot(pair.force, pair.along) - old,
                  wanted,
                  1e-4 * pair.stiffness() * step) // second order
          << limit;
    }
}

TEST(MindlinDeresiewicz, FirstLoadingUnderFallingNormalForceIsExact)
{
  Rubbing once, often;
  for (Rubbing *pair : {&once, &often})
    pair->move(1e-6, {0, 0, 0});
  const double u = 0.3 * once.depth();
  once.slip_to(0, u, 1), often.slip_to(0, u, 1000);
  constexpr int parts = 500;
  once.move(0.6e-6, (0.5 * u) * once.along);
  for (int k = 1; k <= parts; ++k)
    often.move(1e-6 * (1 - 0.4 * k / parts), (0.5 * u / parts) * often.along);
  const double exact = once.limit() * rise(1.5 * u / once.depth());
  EXPECT_NEAR(dot(once.force, once.along), exact, 1e-12 * exact);
  EXPECT_NEAR(dot(often.force, often.along), exact, 1e-10 * exact);
  const double stored = often.memory[6];
  EXPECT_NEAR(often.heat + stored, often.work, 1e-4 * often.work); // parts
  EXPECT_GT(often.heat, 0);
}

TEST(MindlinDeresiewicz, LimitsOfFrictionCoefficient)
{
  Rubbing smooth, rough;
  smooth.law.friction_coefficient = 0;
  rough.law.friction_coefficient = 1e9;
  const double slip = 1e-8;
  EXPECT_EQ(length(smooth.move(1e-6, slip * smooth.along)), 0);
  EXPECT_EQ(smooth.heat, 0);
  rough.move(1e-6, slip * rough.along);
  const double wanted = rough.stiffness() * slip;
  EXPECT_NEAR(dot(rough.force, rough.along), wanted, 1e-8 * wanted);
}

TEST(MindlinDeresiewicz, RandomPathsStayBelowCoulombAndFinite)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> one(-1, 1);
  for (int path = 0; path < 2500; ++path) {
    Rubbing pair;
    for (int k = 0; k < 40; ++k) {
      const double size = std::pow(10, 4 * one(random) - 10);
      const double overlap =
          one(random) < -0.8 ? 0 : 1e-6 * (1.001 + one(random));
      pair.move(overlap,
                (size * one(random)) * pair.along +
                    (size * one(random)) * pair.aside);
      ASSERT_TRUE(std::isfinite(length(pair.force)) &&
                  std::isfinite(pair.heat));
      ASSERT_LE(length(pair.force), pair.limit() * (1 + 1e-12));
    }
  }
}

TEST(MindlinDeresiewicz, SinglePrecisionFollowsDouble)
{
  Rubbing pair;
  pair.move(1e-6, {0, 0, 0});
  const double a = pair.contact_radius(), m = pair.depth();
  std::array<double, Law::more> exact = pair.memory;
  std::array<float, Law::more> memory{};
  for (int i = 0; i < Law::more; ++i)
    memory[i] = static_cast<float>(exact[i]);
  Triple<float> force{0, 0, 0};
  const float radius = static_cast<float>(a);
  for (const double part : {0.7, -0.5, 0.4, -1.2}) {
    pair.move(1e-6, (part * m) * Vector{0, 0.6, 0.6});
    ContactMotion<float> now{};
    const auto single = [](double x) { return static_cast<float>(x); };
    now.normal = {single(1.0 / 3), single(2.0 / 3), single(-2.0 / 3)};
    now.slip = {0, single(0.6 * part * m), single(0.6 * part * m)};
    now.old_radius = radius;
    now.push = {single(pair.push()), radius, 0};
    force = pair.law(force, now, memory.data()).force;
    const Vector same{force.x, force.y, force.z};
    EXPECT_LT(length(same - pair.force), 1e-4 * pair.limit()); // float
  }
}

TEST(MindlinDeresiewicz, RepeatedRandomCyclesGiveNoMoreThanWasStored)
{
  // Cycles of slip and overlap, in a plane or along a line. The work, summed
  // by trapezoids, is what the memory says is stored plus the heat.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> one(-1, 1);
  for (int path = 0; path < 100; ++path) {
    SCOPED_TRACE(path);
    Rubbing pair;
    constexpr int corners = 5, parts = 200, turns = 3;
    std::array<Vector, corners> point{};
    std::array<double, corners> overlap{};
    const double size = std::pow(10, one(random)) * 0.5e-7;
    const double change = path % 2 ? 0.5 : 0;
    for (int c = 0; c < corners; ++c) {
      point[c] = (size * one(random)) * pair.along +
                 (path % 4 < 2 ? 0.0 : size * one(random)) * pair.aside;
      overlap[c] = 1e-6 * (1 + change * one(random));
    }
    pair.move(overlap[0], {0, 0, 0});
    double rubbed = 0; // the size of the work
    const auto travel = [&] {
      for (int c = 0; c < corners; ++c)
        for (int k = 1; k <= parts; ++k) {
          const int d = (c + 1) % corners;
          const double before = pair.heat, work = pair.work;
          pair.move(overlap[c] + (overlap[d] - overlap[c]) * k / parts,
                    (1.0 / parts) * (point[d] - point[c]));
          rubbed += std::abs(pair.work - work);
          EXPECT_GE(pair.heat - before, 0);
        }
    };
    travel();
    const double stored = pair.memory[6];
    pair.work = pair.heat = rubbed = 0;
    for (int turn = 0; turn < turns; ++turn)
      travel();
    constexpr double trapezoids = 5e-3; // of 200 parts
    const double tolerance = trapezoids * rubbed;
    EXPECT_GE(pair.work, -stored - tolerance);
    EXPECT_NEAR(pair.work, pair.heat + pair.memory[6] - stored, tolerance);
    EXPECT_GE(pair.memory[6] * (1 + 1e-12) + 1e-30,
              dot(pair.force, pair.force) / (2 * pair.stiffness()));
  }
}
} // namespace
} // namespace tamp::dem
