// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/hertz.h>
#include <dem/laws/mindlin.h>
#include <dem/laws/viscous.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;

struct Solid {
  double modulus, poisson, density;
};
constexpr Solid alumina{380e9, .23, 4000}, iron{100e9, .25, 7000},
    aluminium{70e9, .33, 2700}, copper{120e9, .35, 8900},
    steel{208e9, .3, 7850}, polyethylene{1e9, .4, 1400}, nylon{2.5e9, .4, 1000};

/// A sphere that hits a plane, in the plane of its motion; or, by `share`,
/// two spheres seen from their middle.
struct Throw {
  Solid solid;
  double radius, restitution, friction;
  double normal, tangential = 0, spin = 0; // velocities, positive inwards
  double plane = 0; // modulus of the plane over that of the sphere; 0 rigid
};
struct Rebound {
  double normal, tangential, spin;
  double patch(double radius) const { return tangential + radius * spin; }
};

/// Velocity Verlet with a step of a 4000th of Hertz's contact time.
Rebound collide(const Throw &c)
{
  const Solid &s = c.solid;
  const double soft = c.plane > 0 ? 1 / (1 + 1 / c.plane) : 1;
  const double modulus = soft * s.modulus / (1 - s.poisson * s.poisson);
  const double shear =
      soft * s.modulus / (2 * (1 + s.poisson)) / (2 - s.poisson);
  const double mass = 4.0 / 3 * pi * std::pow(c.radius, 3) * s.density;
  const double inertia = 0.4 * mass * c.radius * c.radius;
  const Hertz hertz{modulus};
  const Mindlin mindlin{shear, c.friction};
  const Viscous viscous(modulus, c.restitution);
  const PairShape<double> pair{2 * c.radius, c.radius, 0, 1 / mass};
  const double deepest = std::pow(15 * mass * c.normal * c.normal /
                                      (16 * modulus * std::sqrt(c.radius)),
                                  0.4);
  const double step = 2.9433 * deepest / c.normal / 4000;
  // The sphere is the first grain, the plane lies along +x. With the spin
  // positive about -z, its contact patch moves along y with v_t + R spin.
  double overlap = 0, vn = c.normal, vt = c.tangential, spin = c.spin;
  double fn = 0, ft = 0, old_radius = 0;
  Triple<double> tangential{0, 0, 0};
  for (int k = 0; k < 100000; ++k) {
    vn += 0.5 * step * fn / mass, vt += 0.5 * step * ft / mass;
    spin += 0.5 * step * ft * c.radius / inertia;
    overlap += step * vn;
    NormalMemory<double> memory{0, old_radius};
    const auto push = hertz(overlap, pair, memory);
    const Triple<double> surface{-vn, -(vt + c.radius * spin), 0};
    NormalAnswer<double> whole = push;
    whole.force += viscous.normal_force(pair, push, vn);
    const ContactMotion<double> motion{
        pair, {1, 0, 0}, step * surface, 0, old_radius, whole};
    tangential =
        mindlin(tangential, motion, static_cast<double *>(nullptr)).force;
    const auto extra =
        viscous(ViscousMotion<double>{pair,
                                      {1, 0, 0},
                                      surface,
                                      push,
                                      tangential,
                                      mindlin.cap(whole),
                                      mindlin.stiffness(push.contact_radius)});
    old_radius = push.contact_radius;
    fn = -push.force + extra.force.x, ft = tangential.y + extra.force.y;
    tangential = extra.kept;
    if (vn < 0 && fn >= 0)
      break;
    vn += 0.5 * step * fn / mass, vt += 0.5 * step * ft / mass;
    spin += 0.5 * step * ft * c.radius / inertia;
  }
  return {-vn, vt, spin};
}

TEST(Viscous, DampingAgreesWithTable)
{
  for (const auto &[e, beta] : std::array<std::array<double, 2>, 4>{
           {{.2, .66747}, {.5, .23303}, {.8, .06788}, {.98, .00589}}})
    EXPECT_NEAR(Viscous::damping_ratio(e), beta, 1e-4 * beta + 5e-6); // digits
  EXPECT_NEAR(Viscous::damping_ratio(1), 0, 1e-15); // bisection
}

TEST(Viscous, RefusesWhatIsNoRestitution)
{
  for (const double e : {-0.1, 0.0, 1.0001, std::nan("")})
    EXPECT_THROW(Viscous(1e9, e), std::invalid_argument);
  EXPECT_THROW(Viscous(-1, 0.5), std::invalid_argument);
}

TEST(ViscousImpact, GivesRestitutionAtAnySpeed)
{
  constexpr double tolerance = 1e-3; // of the 4000 steps
  for (const Solid &solid : {alumina, iron})
    for (const double e : {.05, .2, .4, .6, .8, 1.})
      for (const double speed : {3.9, 0.1}) {
        SCOPED_TRACE(e);
        const Rebound found = collide({solid, 2.5e-3, e, 0, speed});
        EXPECT_NEAR(found.normal / speed, e, tolerance);
      }
}

TEST(ViscousImpact, NeverPulls)
{
  const Viscous law(1e9, 0.3);
  ViscousMotion<double> now{};
  now.pair = {2, 1, 0, 1};
  now.normal = {1, 0, 0};
  now.push = {1e-3, 1e-6, 0};
  now.velocity = {1e3, 0, 0};        // parting fast
  EXPECT_EQ(law(now).force.x, 1e-3); // takes all of the push, no more
  now.push.pull_off = 2e-3;
  EXPECT_EQ(law(now).force.x, 3e-3); // adhesion holds as much as it can
  now.push.contact_radius = 0;
  EXPECT_EQ(law(now).force.x, 0);
}

TEST(ViscousImpact, SpringAndDashpotStayBelowCapTogether)
{
  const Viscous law(1e9, 0.3);
  ViscousMotion<double> now{};
  now.pair = {2, 1, 0, 1};
  now.normal = {1, 0, 0};
  now.push = {1e-3, 1e-6, 0};
  now.cap = 4e-4, now.stiffness = 1e3;
  now.force = {0, 1e-4, 0};
  now.velocity = {0, 1e-7, 0};
  const auto slow = law(now);
  const double rate = 2 * law.damping() * std::sqrt(1e3);
  EXPECT_NEAR(slow.force.y, rate * 1e-7, 1e-12 * rate); // closed form
  EXPECT_EQ(slow.kept.y, 1e-4);
  now.velocity = {0, 1, 0};
  const auto fast = law(now);
  EXPECT_NEAR(now.force.y + fast.force.y, now.cap, 1e-12 * now.cap);
  EXPECT_NEAR(fast.kept.y, now.cap, 1e-12 * now.cap); // slides
}

struct Oblique {
  Solid solid;
  double angle, tangential, spin; // [deg], v_t' / v_t, omega' [rad/s]
};

TEST(ViscousImpact, ObliqueImpactsAgreeWithChungAndOoiTestFour)
{
  // Reference values have four digits; micro-slip scatters most below 15
  // degrees.
  for (const Oblique &c :
       std::array<Oblique, 13>{{{alumina, 5, .8576, -48.4},
                                {alumina, 10, .7075, -198.1},
                                {alumina, 15, .6340, -369.5},
                                {alumina, 20, .6225, -503.5},
                                {alumina, 25, .6393, -594.5},
                                {alumina, 30, .6847, -614.8},
                                {alumina, 40, .7829, -544.3},
                                {alumina, 60, .8948, -355.2},
                                {alumina, 80, .9679, -123.4},
                                {aluminium, 5, .8160, -62.5},
                                {aluminium, 10, .6836, -214.3},
                                {aluminium, 15, .6199, -383.7},
                                {aluminium, 20, .6143, -514.5}}}) {
    SCOPED_TRACE(c.angle);
    const double tolerance = c.angle < 15 ? 0.02 : 0.01;
    const double angle = c.angle * pi / 180, sideways = 3.9 * std::sin(angle);
    const Rebound found =
        collide({c.solid, 2.5e-3, .98, .092, 3.9 * std::cos(angle), sideways});
    EXPECT_NEAR(found.tangential / sideways, c.tangential, tolerance);
    EXPECT_NEAR(found.spin, c.spin, tolerance * std::abs(c.spin));
  }
}

TEST(ViscousImpact, ElasticObliqueImpactsAgreeWithTestFive)
{
  struct Row {
    Solid solid;
    double ratio, patch, spin;
  };
  for (const Row &c :
       std::array<Row, 10>{{{steel, 1 / 3., .1703, -.1165},
                            {steel, 2 / 3., .3213, -.2467},
                            {steel, 10 / 3., -1.169, -3.216},
                            {steel, 20 / 3., -.3333, -5},
                            {steel, 10, 3, -5},
                            {steel, 20, 13, -5},
                            {polyethylene, 1 / 3., .1185, -.1535},
                            {polyethylene, 2 / 3., .2045, -.3301},
                            {polyethylene, 10 / 3., -1.3275, -3.3292},
                            {polyethylene, 20 / 3., -.3333, -5}}}) {
    SCOPED_TRACE(c.ratio);
    constexpr double radius = 1e-5, unit = 0.3 * 5;
    const Rebound found = collide({c.solid, radius, 1, 0.3, 5, c.ratio * unit});
    EXPECT_NEAR(found.patch(radius) / unit,
                c.patch,
                0.01 * std::max(0.3, std::abs(c.patch))); // 1 %
    EXPECT_NEAR(radius * found.spin / unit, c.spin, 0.01 * std::abs(c.spin));
  }
}

struct Spinning {
  Solid solid;
  double spin, tangential, left;
  double plane = 0;
};

TEST(ViscousImpact, SpinningSpheresAgreeWithTestsSixToEight)
{
  constexpr double tolerance = 0.02; // micro-slip, values of four digits
  for (const Spinning &c :
       std::array<Spinning, 13>{{{aluminium, .5, -.01419, .1453},
                                 {aluminium, 1, -.02707, .3233},
                                 {aluminium, 2, -.06422, .3946},
                                 {aluminium, 4, -.11893, 1.0267},
                                 {aluminium, 6, -.12, 3},
                                 {aluminium, 10, -.12, 7},
                                 {copper, .5, -.01425, .1439},
                                 {copper, 1, -.02722, .3195},
                                 {copper, 2, -.06456, .3860},
                                 {nylon, .5, -.01441, .1397},
                                 {nylon, 2, -.06550, .3625},
                                 {nylon, 6, -.12, 3},
                                 {aluminium, .5, -.01419, .1453, 1}}}) {
    SCOPED_TRACE(c.spin);
    const Rebound found =
        collide({c.solid, 0.1, .5, .4, .2, 0, c.spin, c.plane});
    EXPECT_NEAR(
        found.tangential, c.tangential, tolerance * std::abs(c.tangential));
    // The spin left is the small difference of two large ones.
    EXPECT_NEAR(
        found.spin, c.left, tolerance * std::max(c.left, c.spin - c.left));
  }
}

TEST(ViscousImpact, PlaneOfAnyModulusGivesTheSameRebound)
{
  // Only G*/E* matters: a plane 1000 times stiffer, or as soft as the sphere.
  const Throw base{aluminium, 0.1, .5, .4, .2, 0, 1};
  Throw stiff = base, same = base;
  stiff.plane = 1000, same.plane = 1;
  const Rebound a = collide(stiff), b = collide(same);
  EXPECT_NEAR(a.tangential, b.tangential, 1e-6 * std::abs(b.tangential));
  EXPECT_NEAR(a.spin, b.spin, 1e-6 * b.spin); // same numbers in other units
}
} // namespace
} // namespace tamp::dem
