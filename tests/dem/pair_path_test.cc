// SPDX-License-Identifier: BSD-3-Clause
#include <dem/pair_body.h>
#include <dem/pair_path.h>
#include <tests/dem/moving_cell.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;
constexpr GrainMaterial granite{70e9, 0.3, 2650, 0.5e9};
constexpr double radius = 1e-4;

PairContact contact_of(const ContactModel &model,
                       const GrainMaterial &wall = granite)
{
  const Body grain = Body::grain(radius, granite);
  return {pair_laws(model, granite, wall),
          shape_of(grain, &wall == &granite ? grain : Body::wall())};
}

ContactModel with(NormalLaw normal,
                  TangentialLaw tangential = TangentialLaw::mindlin)
{
  ContactModel model;
  model.normal_law = normal;
  model.tangential_law = tangential;
  return model;
}

TEST(PairContact, OfElasticGrainsFollowsHertz)
{
  PairContact contact = contact_of(with(NormalLaw::hertz));
  const double modulus = 70e9 / (2 * (1 - 0.09)), reduced = radius / 2;
  for (const double overlap : {1e-8, 1e-6, 3e-7, 0.0}) {
    const PairForces forces = contact.advance({overlap});
    const double wanted =
        4.0 / 3 * modulus * std::sqrt(reduced) * std::pow(overlap, 1.5);
    EXPECT_NEAR(forces.push.force, wanted, 1e-13 * wanted); // rounding
    EXPECT_NEAR(contact.elastic_energy(), 0.4 * wanted * overlap, 1e-20);
  }
  EXPECT_EQ(contact.losses().total(), 0);
  EXPECT_FALSE(contact.touches());
}

TEST(PairContact, WithWallHasItsModuli)
{
  // Rigid: E* = E / (1 - nu^2), G* = G / (2 - nu); R* = R, m* = m.
  const double grain = 70e9 / (1 - 0.09), shear = 70e9 / 2.6 / 1.7;
  const PairMaterial rigid = pair_material(granite, rigid_wall());
  EXPECT_NEAR(rigid.effective_modulus, grain, 1e-13 * grain); // rounding
  EXPECT_NEAR(rigid.effective_shear_modulus, shear, 1e-13 * shear);
  EXPECT_EQ(rigid.limiting_pressure, granite.limiting_pressure);
  const double steel = 210e9 / (1 - 0.09);
  const PairMaterial soft = pair_material(granite, elastic_wall(210e9, 0.3));
  EXPECT_NEAR(
      soft.effective_modulus, grain * steel / (grain + steel), 1e-13 * grain);
  const PairShape<double> shape =
      shape_of(Body::grain(radius, granite), Body::wall());
  EXPECT_EQ(shape.reduced_radius, radius);
  const double mass = 4.0 / 3 * pi * 2650 * radius * radius * radius;
  EXPECT_NEAR(shape.inverse_mass * mass, 1, 1e-14);

  PairContact contact = contact_of(with(NormalLaw::hertz), rigid_wall());
  const double wanted = 4.0 / 3 * grain * std::sqrt(radius) * 1e-9;
  EXPECT_NEAR(contact.advance({1e-6}).push.force, wanted, 1e-13 * wanted);
}

TEST(PairContact, OfAdheringGrainsHasJkrsNumbers)
{
  constexpr double tolerance = 1e-4; // of the steps between which it tears
  constexpr double adhesion = 0.2, reduced = radius / 2;
  ContactModel model = with(NormalLaw::jkr);
  model.work_of_adhesion = adhesion;
  PairContact contact = contact_of(model);
  const double modulus = contact.laws().effective_modulus;
  const double pull_off = 1.5 * pi * adhesion * reduced;
  const double tear = -0.75 * std::cbrt(pi * pi * adhesion * adhesion *
                                        reduced / (modulus * modulus));
  EXPECT_EQ(contact.advance({-1e-12}).push.force, 0); // not before they touch
  contact.advance({2e-8});
  EXPECT_NEAR(contact.advance({0}).push.force / pull_off, -.888889, tolerance);
  double least = 0, last = 0, torn = 0;
  constexpr int parts = 1000000; // the force falls steeply towards the tear
  for (int k = 1; torn == 0 && k < 2 * parts; ++k) {
    const double overlap = tear * k / parts;
    const double force = contact.advance({overlap}).push.force;
    least = std::min(least, force);
    if (contact.touches())
      last = force;
    else
      torn = overlap;
  }
  EXPECT_NEAR(least / pull_off, -1, tolerance);
  EXPECT_NEAR(last / pull_off, -.555556, 1e-3); // slope without bound there
  EXPECT_NEAR(torn / tear, 1, tolerance);
  const double unit = std::cbrt(std::pow(adhesion, 5) * std::pow(reduced, 4) /
                                (modulus * modulus));
  EXPECT_NEAR(contact.losses().adhesion / unit, 7.092, 7.092 * tolerance);
  EXPECT_NEAR(2 * contact.losses().adhesion / unit, 14.184, 14.184 * tolerance);
}

TEST(PairContact, LosesAreaOfThorntonNingsLoop)
{
  PairContact contact = contact_of(with(NormalLaw::thornton_ning));
  constexpr int parts = 20000;
  constexpr double deep = 1e-6;
  double work = 0, force = 0;
  for (int k = 1; k <= 2 * parts; ++k) {
    const double overlap = deep * (k <= parts ? k : 2 * parts - k) / parts;
    const double before = force;
    force = contact.advance({overlap}).push.force;
    work += 0.5 * (before + force) * (k <= parts ? deep : -deep) / parts;
    if (k == parts) {
      EXPECT_TRUE(contact.plastic());
    }
  }
  // The grains have parted and forgotten; what was lost stays booked.
  EXPECT_FALSE(contact.plastic());
  EXPECT_EQ(contact.largest_overlap(), 0);
  EXPECT_NEAR(contact.losses().plastic, work, 1e-6 * work); // trapezoidal rule
}

TEST(PairContact, SlidesAtCoulombsCap)
{
  PairContact contact = contact_of(with(NormalLaw::hertz));
  const double push = contact.advance({1e-6}).push.force;
  const double stiffness =
      8 * pair_material(granite, granite).effective_shear_modulus *
      contact.contact_radius();
  const double limit = 0.3 * push;
  const PairForces sticks =
      contact.advance({1e-6, {0.5 * limit / stiffness, 0, 0}});
  EXPECT_NEAR(sticks.rub.x, 0.5 * limit, 1e-12 * limit); // rounding
  EXPECT_FALSE(contact.slides());
  const PairForces slides = contact.advance({1e-6, {0, -1e-6, 0}});
  EXPECT_NEAR(std::hypot(slides.rub.x, slides.rub.y), limit, 1e-12 * limit);
  EXPECT_TRUE(contact.slides());
  EXPECT_GT(contact.losses().friction, 0);
}

TEST(PairContact, ACycleOfItsNormalForceTakesAThirdOfThatTimesTheFriction)
{
  // T is taken down with the contact radius, N^(1/3) in elastic unloading, and
  // not brought back: of T = f mu N, f mu / 3 of what N goes to and fro.
  for (const NormalLaw law : {NormalLaw::hertz, NormalLaw::thornton_ning})
    for (const double step : {-2e-10, 2e-10}) {
      PairContact contact = contact_of(with(law));
      contact.advance({1e-6});
      const double rest = 0.98e-6, push = contact.advance({rest}).push.force;
      const double stiffness =
          8 * pair_material(granite, granite).effective_shear_modulus *
          contact.contact_radius();
      const double force = 0.5 * 0.3 * push;
      contact.advance({rest, {force / stiffness, 0, 0}});
      const double away = contact.advance({rest + step}).push.force;
      const double left = contact.advance({rest}).rub.x;
      const double ratio = std::min(away, push) / std::max(away, push);
      EXPECT_NEAR(left, force * std::cbrt(ratio), 1e-12 * force); // rounding
      const double to_and_fro = std::abs(away - push);
      EXPECT_GT(to_and_fro, 1e-4 * push);
      EXPECT_NEAR((force - left) / to_and_fro, 0.5 * 0.3 / 3, 1e-3);
      EXPECT_FALSE(contact.slides());
    }
}

/// Two grains of a cell on a wild ride, and what the sweep makes of it.
struct Ride {
  test::LaidOut<double> cell;
  PairContact contact;
  test::SmallMotion motion = test::no_motion(2);

  explicit Ride(const ContactModel &model)
      : cell(two_grains(model), InstructionSet::scalar),
        contact(pair_laws(model, granite, granite), cell.cell.shape({0, 1}))
  {
  }
  static UnitCell two_grains(const ContactModel &model)
  {
    UnitCell cell;
    cell.materials[0] = granite;
    cell.contact = model;
    cell.box.h = 2e-3 * Matrix3::Identity();
    cell.radius = {1e-4, 1.5e-4};
    cell.place = {{0.4, 0.5, 0.5}, {0.4 + 2.5e-4 / 2e-3, 0.5, 0.5}};
    return cell;
  }
  Vector3 branch = {2.5e-4, 0, 0};
  static Triple<double> triple(const Vector3 &v)
  {
    return {v.x(), v.y(), v.z()};
  }
  static Vector3 vector(const Triple<double> &t) { return {t.x, t.y, t.z}; }

  /// The largest difference of forces and torques over the force.
  double step(RandomNumbers &random, double approach, double time)
  {
    constexpr double size = 2e-8; // of a step, a fiftieth of the overlap
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k) {
        motion.relative[i][k] = size * (random.next() - 0.5);
        motion.rolled[i][k] = size * (random.next() - 0.5);
      }
    motion.relative[0] += Vector3(approach, 0, 0);
    const Vector3 change = motion.relative[1] - motion.relative[0];
    const Vector3 middle = branch + 0.5 * change;
    branch += change;
    motion.affine.time = time;
    const test::Forces found = cell.sweep(motion, Memory::written);

    const std::vector<double> &r = cell.cell.radius;
    const Vector3 n = branch.normalized();
    const double arm = branch.norm() / (r[0] + r[1]);
    const Vector3 first = motion.rolled[0] / r[0];
    const Vector3 second = motion.rolled[1] / r[1];
    const Vector3 slip =
        change -
        (motion.rolled[0] + motion.rolled[1]).cross(middle) / (r[0] + r[1]);
    const PairForces forces = contact.advance(
        {r[0] + r[1] - branch.norm(),
         triple(slip),
         (motion.rolled[0] + motion.rolled[1]).dot(n) / (r[0] + r[1]),
         triple(first - second),
         triple(n),
         time});
    const Vector3 rub = vector(forces.rub), moment = vector(forces.moment);
    const double wrong_force =
        (found.force[0] - (rub - forces.push.force * n)).norm() +
        (found.force[0] + found.force[1]).norm();
    const double wrong_torque =
        (found.torque[0] - (arm * n.cross(rub) + moment / r[0])).norm() +
        (found.torque[1] - (arm * n.cross(rub) - moment / r[1])).norm();
    return wrong_force + wrong_torque;
  }
};

TEST(PairContact, DoesWhatTheSweepDoesToTwoGrains)
{
  constexpr double round_off = 1e-8; // of an overlap of 1e-8 of the place
  using enum NormalLaw;
  for (const NormalLaw normal :
       {hertz, thornton_ning, jkr, thornton_ning_jkr, storakers})
    for (const TangentialLaw tangential : {TangentialLaw::none,
                                           TangentialLaw::mindlin,
                                           TangentialLaw::mindlin_deresiewicz})
      for (const bool damped : {false, true}) {
        ContactModel model = with(normal, tangential);
        model.rolling_law = damped ? RollingLaw::epsd : RollingLaw::none;
        model.restitution_coefficient = damped ? 0.6 : 1;
        model.work_of_adhesion = 5;
        Ride ride(model);
        RandomNumbers random(3);
        double largest = 0, wrong = 0;
        for (int k = 0; k < 400; ++k) { // in, out, and in again
          const double approach = k < 100 || k >= 250 ? 1e-8 : -1e-8;
          wrong =
              std::max(wrong, ride.step(random, approach, damped ? 1e-9 : 0));
          largest = std::max(largest, ride.contact.forces().push.force);
        }
        EXPECT_GT(largest, 0);
        EXPECT_LT(wrong, round_off * largest)
            << int(normal) << int(tangential) << damped;
      }
}
} // namespace
} // namespace tamp::dem
