// SPDX-License-Identifier: BSD-3-Clause
#include <tests/dem/laws/any_contact.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

// What holds for every contact law, as cells use it. What a law says of itself
// is in its own test:
//   virgin curve, unloading    hertz, thornton_ning, storakers, jkr,
//                              adhesive_thornton_ning,
//                              adjusted_thornton_ning, mdr, sphere_on_flat
//   slopes, energy             the same
//   energy on random paths     storakers, jkr, adhesive_thornton_ning (1e5
//                              each), adjusted_thornton_ning (whose pressure
//                              changes), mdr (LossNeverFallsOnRandomPaths)
//   packs and float            storakers, jkr, adhesive_thornton_ning,
//                              adjusted_thornton_ning, mdr,
//                              mindlin_deresiewicz; the sweep of every law in
//                              instruction_sets_test.cc
//   slip, cap, heat            mindlin, adhesive_mindlin, mindlin_deresiewicz
//   damping                    viscous
// Here are continuity and limits of all pairs of laws, with resistance to
// rolling and twisting; random paths are in every_law_paths_test.cc.
namespace tamp::dem::test
{
namespace
{
/// The largest change of the normal force in a step within which the grains
/// neither begin to touch nor part [N].
double largest_jump(NormalLaw normal, int parts)
{
  AnyContact contact(model_of(normal));
  double result = 0;
  for (double overlap : load_unload_reload(parts)) {
    const NormalAnswer<double> before = contact.now().push;
    contact.step({overlap});
    if ((before.contact_radius > 0) == contact.touches())
      result =
          std::max(result, std::abs(contact.now().push.force - before.force));
  }
  return result;
}

TEST(EveryLaw, NormalForceIsContinuousAlongLoadUnloadReload)
{
  // A hundredth of the step: at most a tenth of the jump, even where a law
  // ends in a root, as an adhesive contact does when it tears; a jump of the
  // law itself would stay.
  for (NormalLaw normal : normal_laws) {
    const double coarse = largest_jump(normal, 100);
    EXPECT_GT(coarse, 0);
    EXPECT_LT(largest_jump(normal, 10000), 0.11 * coarse) << int(normal);
  }
}

/// How fast the tangential force and the moment of a contact may change: by the
/// stiffness, with the limit, and with the contact radius.
class Pace
{
public:
  explicit Pace(const AnyContact &contact) : before_(contact) {}

  /// What the force changed in a step, over what it may [-].
  double of_force(const AnyContact &after, const Step &step) const
  {
    const double change = size_of(after.now().rub - before_.now().rub);
    const double stiffness = std::max(after.stiffness(), before_.stiffness());
    return change / (stiffness * size_of(step.slip) +
                     std::abs(after.cap() - before_.cap()) +
                     shrunk(after) * size_of(before_.now().rub) + tiny);
  }
  double of_moment(const AnyContact &after, const Step &step) const
  {
    const Rolling &law = after.rolling();
    const double change = size_of(after.now().moment - before_.now().moment);
    const double a = std::max(after.radius(), before_.radius());
    const NormalAnswer<double> &now = after.now().push,
                               &old = before_.now().push;
    const double caps = std::abs(law.rolling_cap(pair_shape, now) -
                                 law.rolling_cap(pair_shape, old)) +
                        std::abs(law.twisting_cap(now) - law.twisting_cap(old));
    const double stiffness =
        law.rolling_stiffness(pair_shape, a) + law.twisting_stiffness(a);
    // The twisting stiffness goes with the third power of the radius.
    return change / (stiffness * size_of(step.rotation) + caps +
                     3 * shrunk(after) * size_of(before_.now().moment) + tiny);
  }

private:
  double shrunk(const AnyContact &after) const
  {
    return std::abs(1 - after.radius() / before_.radius());
  }

  AnyContact before_;
};

TEST(EveryLaw, TangentialForceAndMomentNeverJump)
{
  // All three ways to change add up at most; 2 %: of second order in the step.
  constexpr double most = 1.02;
  for (NormalLaw normal : normal_laws)
    for (TangentialLaw tangential : tangential_laws) {
      SCOPED_TRACE(int(normal) * 10 + int(tangential));
      AnyContact contact(model_of(normal, tangential));
      double force = 0, moment = 0;
      for (const Step &step : rubbed_path(3000)) {
        const Pace pace(contact);
        const bool touched = contact.touches();
        contact.step(step);
        if (!touched || !contact.touches())
          continue;
        force = std::max(force, pace.of_force(contact, step));
        moment = std::max(moment, pace.of_moment(contact, step));
      }
      EXPECT_EQ(force > 0.5, tangential != TangentialLaw::none);
      EXPECT_GT(moment, 0.2); // there is something to bound
      EXPECT_LE(force, most);
      EXPECT_LE(moment, most);
    }
}

/// Two contacts on the same path, with slip and rotation.
struct Twins {
  AnyContact one, other;

  /// Both answer the same, to a tolerance of the largest force so far.
  void expect_same(double tolerance)
  {
    double force = 0;
    for (const Step &step : rubbed_path(300)) {
      one.step(step);
      other.step(step);
      const PairForces &a = one.now(), &b = other.now();
      force = std::max(force, std::abs(b.push.force));
      ASSERT_NEAR(a.push.force, b.push.force, tolerance * force);
      ASSERT_LE(size_of(a.rub - b.rub), tolerance * force);
      // Moments are of the order of a thousandth of R* N.
      ASSERT_LE(size_of(a.moment - b.moment),
                tolerance * 1e-3 * reduced_radius * force);
    }
    EXPECT_GT(force, 0);
  }
};

TEST(EveryLaw, VanishingAdhesionFallsBack)
{
  // Forces of adhesion go with sqrt(Gamma): 1e-7 of 0.5 J/m2 is far below; the
  // twist goes with a^3.
  constexpr double tolerance = 1e-5;
  for (auto [sticky, dry] :
       {std::pair(NormalLaw::jkr, NormalLaw::hertz),
        std::pair(NormalLaw::thornton_ning_jkr, NormalLaw::thornton_ning)})
    for (TangentialLaw tangential : tangential_laws)
      for (double adhesion : {1e-14, 0.0}) {
        ContactModel model = model_of(sticky, tangential);
        model.work_of_adhesion = adhesion;
        Twins{AnyContact(model), AnyContact(model_of(dry, tangential))}
            .expect_same(tolerance);
      }
}

TEST(EveryLaw, UnreachedYieldingFallsBack)
{
  GrainMaterial hard = hard_grain;
  hard.limiting_pressure = 5e10;     // Hertz has 3.5e9 Pa at most
  constexpr double round_off = 1e-7; // of an overlap in that of yielding
  for (auto [yielding, elastic] :
       {std::pair(NormalLaw::thornton_ning, NormalLaw::hertz),
        std::pair(NormalLaw::thornton_ning_jkr, NormalLaw::jkr),
        std::pair(NormalLaw::mdr, NormalLaw::hertz),
        std::pair(NormalLaw::thornton_ning_adjusted, NormalLaw::hertz)})
    for (TangentialLaw tangential : tangential_laws)
      Twins{AnyContact(model_of(yielding, tangential), hard),
            AnyContact(model_of(elastic, tangential))}
          .expect_same(round_off);
}

TEST(EveryLaw, UnreachedFrictionSticks)
{
  // However the partial slip is told, a rough contact sticks with 8 G* a.
  // Adhesion peels nothing here: Mindlin is the plain one.
  constexpr double tolerance = 1e-5; // a core of 1 - 1e-5
  for (NormalLaw normal : normal_laws) {
    ContactModel stuck = model_of(normal, TangentialLaw::mindlin);
    ContactModel partly = model_of(normal, TangentialLaw::mindlin_deresiewicz);
    stuck.work_of_adhesion = partly.work_of_adhesion = 0;
    stuck.friction_coefficient = partly.friction_coefficient = 1e6;
    AnyContact one(stuck), other(partly);
    double force = 0;
    for (const Step &step : rubbed_path(300)) {
      if (one.touches() && step.overlap < one.overlap())
        break; // from here on both forget in ways of their own
      one.step(step);
      other.step(step);
      force = std::max(force, size_of(one.now().rub));
      ASSERT_LE(size_of(one.now().rub - other.now().rub), tolerance * force);
    }
    EXPECT_GT(force, 0);
  }
}

TEST(EveryLaw, VanishingFrictionLeavesNoTangentialForceAndNoTwist)
{
  for (NormalLaw normal : normal_laws)
    for (TangentialLaw tangential : tangential_laws)
      for (double friction : {1e-12, 0.0}) {
        ContactModel model = model_of(normal, tangential);
        model.friction_coefficient = friction;
        AnyContact contact(model);
        double largest = 0;
        for (const Step &step : rubbed_path(300)) {
          contact.step(step);
          const PairForces &now = contact.now();
          largest =
              std::max(largest, std::abs(now.push.force) + now.push.pull_off);
          ASSERT_LE(size_of(now.rub), 3 * friction * largest);
          ASSERT_LE(std::abs(now.moment.x),
                    friction * now.push.contact_radius * largest);
        }
        EXPECT_GT(largest, 0);
      }
}

TEST(EveryLaw, VanishingRollingFrictionLeavesNoRollingMoment)
{
  for (NormalLaw normal : normal_laws)
    for (double friction : {1e-12, 0.0}) {
      ContactModel model = model_of(normal);
      model.rolling_friction_coefficient = friction;
      AnyContact contact(model);
      double largest = 0;
      for (const Step &step : rubbed_path(300)) {
        contact.step(step);
        const Triple<double> &m = contact.now().moment;
        largest = std::max(largest, std::abs(contact.now().push.force));
        ASSERT_LE(size_of({0, m.y, m.z}), friction * reduced_radius * largest);
      }
      EXPECT_GT(largest, 0);
    }
}

TEST(EveryLaw, VanishingDampingFallsBack)
{
  // beta = (1 - e) / pi to first order.
  constexpr double tolerance = 1e-6;
  for (NormalLaw normal : normal_laws)
    for (TangentialLaw tangential : tangential_laws) {
      ContactModel model = model_of(normal, tangential);
      AnyContact plain(model);
      model.restitution_coefficient = 1 - 1e-12;
      AnyContact damped(model);
      double force = 0;
      for (const Step &step : rubbed_path(300)) {
        plain.step(step);
        damped.step(step, 1e-9);
        const PairForces &a = plain.now(), &b = damped.now();
        force = std::max(force, std::abs(a.push.force));
        ASSERT_NEAR(a.push.force, b.push.force, tolerance * force);
        ASSERT_LE(size_of(a.rub - b.rub), tolerance * force);
      }
      EXPECT_GT(force, 0);
      EXPECT_GE(damped.losses().damping, 0);
      EXPECT_EQ(plain.losses().damping, 0);
    }
}
} // namespace
} // namespace tamp::dem::test
