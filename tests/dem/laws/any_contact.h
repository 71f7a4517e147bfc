// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_any_contact_h
#define tests_dem_laws_any_contact_h

#include <dem/pair_path.h>

#include <array>
#include <cmath>
#include <vector>

namespace tamp::dem::test
{
constexpr double reduced_radius = 5e-5; // [m]
constexpr PairShape<double> pair_shape = {
    4 * reduced_radius, reduced_radius, 0, 1e9};
constexpr GrainMaterial hard_grain = {70e9, 0.3, 2650, 2e9};
constexpr double reach = 1e-6; // largest overlap; it yields at 3.3e-7 [m]

constexpr std::array normal_laws = {NormalLaw::hertz,
                                    NormalLaw::thornton_ning,
                                    NormalLaw::jkr,
                                    NormalLaw::thornton_ning_jkr,
                                    NormalLaw::storakers,
                                    NormalLaw::mdr,
                                    NormalLaw::thornton_ning_adjusted};
constexpr std::array tangential_laws = {TangentialLaw::none,
                                        TangentialLaw::mindlin,
                                        TangentialLaw::mindlin_deresiewicz};

/// With resistance to rolling and twisting.
inline ContactModel model_of(NormalLaw normal,
                             TangentialLaw tangential = TangentialLaw::mindlin)
{
  return {.normal_law = normal,
          .tangential_law = tangential,
          .rolling_law = RollingLaw::epsd,
          .friction_coefficient = 0.4,
          .work_of_adhesion = 0.5,
          .rolling_friction_coefficient = 0.1};
}

inline double size_of(const Triple<double> &v)
{
  return std::sqrt(dot(v, v));
}

/// How the grains of a contact move in a step; the normal is x.
struct Step {
  double overlap; // afterwards [m]
  Triple<double> slip{0, 0, 0}, rotation{0, 0, 0};
};

/// What a contact that is led along a path has come to.
struct Account {
  double work = 0;  // done on the contact [J]
  double doubt = 0; // of the trapezoidal rule [J]
  double moved = 0; // sum of the sizes of all parts of the work [J]
};

/// A contact of any laws with its memory, led along a path as cells lead
/// theirs: the overlap first, then slip and rotation.
class AnyContact
{
public:
  explicit AnyContact(const ContactModel &model,
                      const GrainMaterial &solid = hard_grain)
      : contact_(pair_laws(model, solid, solid), pair_shape)
  {
  }

  void step(const Step &to, double time = 0)
  {
    const PairForces old = now();
    PairMotion motion{to.overlap, to.slip};
    motion.slip.x = contact_.overlap() - to.overlap;
    motion.rotation = to.rotation;
    motion.normal = {1, 0, 0};
    motion.time = time;
    contact_.advance(motion);
    const double deeper = -motion.slip.x;
    const double jump =
        2 * std::max(old.push.pull_off, now().push.pull_off); // touch, tear
    book(0.5 * (old.push.force + now().push.force) * deeper,
         (std::abs(now().push.force - old.push.force) + jump) * deeper);
    book(0.5 * dot(old.rub + now().rub, to.slip),
         size_of(now().rub - old.rub) * size_of(to.slip));
    book(-0.5 * dot(old.moment + now().moment, to.rotation),
         size_of(now().moment - old.moment) * size_of(to.rotation));
  }

  const PairForces &now() const { return contact_.forces(); }
  bool touches() const { return contact_.touches(); }
  double overlap() const { return contact_.overlap(); }
  double radius() const { return now().push.contact_radius; }
  PairLosses losses() const { return contact_.losses(); }
  const Account &account() const { return account_; }
  /// What the contact holds and has lost [J].
  double ledger() const
  {
    return contact_.elastic_energy() + contact_.spring_energy() +
           losses().total();
  }
  /// Of the tangential law.
  double cap() const
  {
    return std::visit([&](const auto &law) { return law.cap(now().push); },
                      contact_.laws().tangential);
  }
  double stiffness() const
  {
    return std::visit([&](const auto &law) { return law.stiffness(radius()); },
                      contact_.laws().tangential);
  }
  const Rolling &rolling() const { return *contact_.laws().rolling; }

private:
  void book(double work, double doubt)
  {
    account_.work += work;
    account_.moved += std::abs(work);
    account_.doubt += 0.5 * std::abs(doubt);
  }

  PairContact contact_;
  Account account_;
};

/// Overlaps of a load, an unload, a reload beyond, and a parting.
inline std::vector<double> load_unload_reload(int parts)
{
  std::vector<double> path;
  double from = -0.1 * reach;
  for (double to : {0.6 * reach, 0.1 * reach, reach, -0.1 * reach}) {
    for (int k = 1; k <= parts; ++k)
      path.push_back(from + (to - from) * k / parts);
    from = to;
  }
  return path;
}

/// The same with a slip to and fro whose direction turns slowly, and a rotation
/// that rolls and twists.
inline std::vector<Step> rubbed_path(int parts)
{
  std::vector<Step> path;
  double phase = 0;
  for (double overlap : load_unload_reload(parts)) {
    phase += 10.0 / parts;
    const double slip = 3 * reach / parts * std::sin(phase);
    const double turn = 0.2 / parts;
    path.push_back(
        {overlap,
         {0, slip * std::cos(0.1 * phase), slip * std::sin(0.1 * phase)},
         {turn * std::sin(0.7 * phase),
          turn * std::cos(phase),
          turn * std::sin(0.3 * phase)}});
  }
  return path;
}
} // namespace tamp::dem::test

#endif
