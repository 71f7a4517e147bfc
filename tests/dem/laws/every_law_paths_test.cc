// SPDX-License-Identifier: BSD-3-Clause
#include <dem/random_numbers.h>
#include <tests/dem/laws/any_contact.h>

#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <tuple>

// Random and closed paths of every normal law with every tangential law, with
// resistance to rolling and twisting.
namespace tamp::dem::test
{
namespace
{
using Laws = std::tuple<NormalLaw, TangentialLaw>;

class EveryLawOnPaths : public testing::TestWithParam<Laws>
{
protected:
  ContactModel model() const { return std::apply(model_of, GetParam()); }
};

/// What must hold after every step.
/// @param heat  of friction in the step [J]
void expect_sound(const AnyContact &contact, double heat)
{
  const PairForces &now = contact.now();
  ASSERT_TRUE(std::isfinite(now.push.force));
  ASSERT_TRUE(std::isfinite(contact.radius()));
  ASSERT_TRUE(std::isfinite(size_of(now.rub)));
  ASSERT_TRUE(std::isfinite(size_of(now.moment)));
  ASSERT_TRUE(std::isfinite(heat));
  ASSERT_LE(size_of(now.rub), contact.cap() * (1 + 1e-12));
  ASSERT_EQ(now.rub.x, 0); // along the normal
  const Rolling &law = contact.rolling();
  ASSERT_LE(std::abs(now.moment.x), law.twisting_cap(now.push) * (1 + 1e-12));
  ASSERT_LE(size_of({0, now.moment.y, now.moment.z}),
            law.rolling_cap(pair_shape, now.push) * (1 + 1e-12));
  // Round-off of energies that cancel.
  ASSERT_GE(heat, -1e-12 * contact.account().moved);
}

/// 1e5 random steps, cut into paths that begin and end apart.
void expect_passive(const ContactModel &model, std::uint64_t seed)
{
  RandomNumbers random(seed);
  constexpr int paths = 100, legs = 10, parts = 100;
  const auto any = [&] { return 2 * random.next() - 1; };
  const auto vector = [&](double size) -> Triple<double> {
    const double x = any(), y = any(), z = any();
    return {size * x, size * y, size * z};
  };
  double doubt = 0, moved = 0, heat = 0;
  int touched = 0;
  for (int path = 0; path < paths; ++path) {
    AnyContact contact(model);
    double lost = 0;
    contact.step({-0.2 * reach});
    for (int leg = 0; leg < legs; ++leg) {
      const double from = contact.overlap();
      const double to =
          leg + 1 < legs ? reach * (1.2 * random.next() - 0.2) : -0.2 * reach;
      Step step{0, vector(reach / parts * random.next()), vector(0.1 / parts)};
      step.slip.x = 0;
      for (int k = 1; k <= parts; ++k) {
        step.overlap = from + (to - from) * k / parts;
        contact.step(step);
        const double now = contact.losses().friction;
        expect_sound(contact, now - lost);
        lost = now;
        if (testing::Test::HasFatalFailure())
          return;
        touched += contact.touches();
      }
    }
    const Account &account = contact.account();
    ASSERT_FALSE(contact.touches());
    EXPECT_GE(account.work, -account.doubt) << path;
    EXPECT_NEAR(account.work, contact.ledger(), account.doubt) << path;
    doubt += account.doubt;
    moved += account.moved;
    heat += contact.losses().friction;
  }
  EXPECT_GT(touched, paths * legs * parts / 2); // there is something to test
  EXPECT_LT(doubt, 0.1 * moved);
  EXPECT_GT(heat, 0);
}

TEST_P(EveryLawOnPaths, RandomOnesStayFiniteAndGiveNoEnergyAway)
{
  expect_passive(model(), 21);
}

TEST_P(EveryLawOnPaths, WorkIsStoredOrLostInFineSteps)
{
  // Each way of a contact to take up energy closes its account, in a path of
  // load, unload, reload and parting: to first order in 2e-4 of a leg, in the
  // force of which contacts part or tear, or change their radius.
  constexpr int parts = 5000;
  constexpr double tolerance = 2e-3;
  AnyContact contact(model());
  double worst = 0;
  for (const Step &step : rubbed_path(parts)) {
    contact.step(step);
    worst =
        std::max(worst, std::abs(contact.account().work - contact.ledger()));
  }
  EXPECT_LT(worst, tolerance * contact.account().moved);
  EXPECT_GT(contact.account().work, 0);
  EXPECT_GT(contact.losses().friction, 0);
}

TEST_P(EveryLawOnPaths, ClosedCyclesOfPlaceGainNothing)
{
  // Overlap, slip and rotation return to where they were, again and again; the
  // contact opens in each cycle or never. Whatever the first did, a later one
  // takes no energy out of the contact but what it gave in.
  constexpr int parts = 2000, cycles = 4;
  for (double lowest : {0.3, -0.2}) {
    AnyContact contact(model());
    contact.step({lowest * reach});
    double least = 0, work = 0;
    for (int cycle = 0; cycle < cycles; ++cycle) {
      for (int k = 1; k <= parts; ++k) {
        const double angle = 2 * std::numbers::pi * k / parts;
        const double swing = reach / parts * std::cos(3 * angle);
        const double turn = 0.3 / parts * std::cos(2 * angle);
        const double height = 0.5 * (1 - std::cos(angle));
        contact.step({(lowest + (1 - lowest) * height) * reach,
                      {0, 4 * swing, 2 * swing},
                      {turn, -turn, turn}});
      }
      if (cycle > 0) // the contact has come to its cycle
        least = std::min(least, contact.account().work - work);
      work = contact.account().work;
    }
    // Trapezoids of 2000 parts.
    EXPECT_GE(least, -1e-3 * contact.account().moved / cycles);
  }
}

TEST_P(EveryLawOnPaths, DampedForcesStayFiniteAndBelowLimits)
{
  ContactModel damped = model();
  damped.restitution_coefficient = 0.5;
  RandomNumbers random(5);
  AnyContact contact(damped);
  double largest = 0; // [N]
  for (int leg = 0; leg < 1000; ++leg) {
    const double from = contact.overlap();
    const double to = reach * (1.2 * random.next() - 0.2);
    const double slip = 0.02 * reach * (2 * random.next() - 1);
    for (int k = 1; k <= 100; ++k) {
      contact.step({from + (to - from) * k / 100, {0, slip, 0}}, 1e-9);
      const PairForces &now = contact.now();
      largest = std::max(largest, now.push.force);
      const double round_off = 1e-12 * largest;
      ASSERT_TRUE(std::isfinite(now.push.force + size_of(now.rub)));
      ASSERT_LE(size_of(now.rub), contact.cap() + round_off);
      ASSERT_GE(now.push.force, -now.push.pull_off - round_off);
    }
    ASSERT_TRUE(std::isfinite(contact.losses().total()));
  }
  EXPECT_GT(contact.losses().damping, 0);
}

std::string name_of(const testing::TestParamInfo<Laws> &laws)
{
  constexpr std::array names = {"Hertz",
                                "ThorntonNing",
                                "Jkr",
                                "AdhesiveThorntonNing",
                                "Storakers",
                                "Mdr",
                                "AdjustedThorntonNing"};
  constexpr std::array rubs = {"Smooth", "Mindlin", "MindlinDeresiewicz"};
  const auto [normal, tangential] = laws.param;
  return std::string(names.at(std::size_t(normal))) +
         rubs.at(std::size_t(tangential));
}

INSTANTIATE_TEST_SUITE_P(Laws,
                         EveryLawOnPaths,
                         testing::Combine(testing::ValuesIn(normal_laws),
                                          testing::ValuesIn(tangential_laws)),
                         name_of);
} // namespace
} // namespace tamp::dem::test
