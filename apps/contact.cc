// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/output/curve_writer.h>
#include <apps/output/plots.h>
#include <apps/run/interrupt.h>
#include <apps/run/run_material.h>
#include <dem/pair_impact.h>
#include <dem/remarks.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
using Three = dem::Triple<double>;

// Columns of every contact.
const std::vector<std::string> contact_columns{"step",
                                               "overlap[m]",
                                               "slip_x[m]",
                                               "slip_y[m]",
                                               "normal_force[N]",
                                               "tangential_force_x[N]",
                                               "tangential_force_y[N]",
                                               "contact_radius[m]",
                                               "maximum_overlap[m]",
                                               "plastic[-]",
                                               "sliding[-]"};
const std::vector<std::string> path_columns{"stage",
                                            "spin[rad]",
                                            "rotation_x[rad]",
                                            "rotation_y[rad]",
                                            "rotation_z[rad]"};
const std::vector<std::string> impact_columns{"time[s]",
                                              "velocity_x[m/s]",
                                              "velocity_y[m/s]",
                                              "velocity_z[m/s]",
                                              "spin_x[rad/s]",
                                              "spin_y[rad/s]",
                                              "spin_z[rad/s]",
                                              "kinetic_energy[J]"};
const std::vector<std::string> work_columns{"moment_x[N m]",
                                            "moment_y[N m]",
                                            "moment_z[N m]",
                                            "elastic_energy[J]",
                                            "plastic_dissipation[J]",
                                            "friction_dissipation[J]",
                                            "damping_dissipation[J]",
                                            "adhesion_dissipation[J]"};

std::vector<std::string> header(bool impact)
{
  std::vector<std::string> names = contact_columns;
  for (const auto &more :
       {impact ? impact_columns : path_columns, work_columns})
    names.insert(names.end(), more.begin(), more.end());
  return names;
}

std::vector<std::string> remarks(const PairInput &pair)
{
  std::vector<std::string> lines{
      "z is the normal, from the first body to the second; slip is that of the "
      "surfaces, second less first; forces and moments are those on the first; "
      "normal force is positive in compression; elastic energy is that of the "
      "normal contact"};
  if (pair.impact)
    lines.emplace_back("velocity and spin are those of the first body");
  for (std::size_t i = 0; !pair.impact && i < pair.stages.size(); ++i)
    lines.push_back(fmt::format("stage {}: {}", i + 1, pair.stages[i].text));
  return lines;
}

class ContactRun
{
public:
  explicit ContactRun(RunSession &session)
      : session_(session), pair_(session.input().pair),
        curve_(session.folder().path() / "curve.csv",
               header(pair_.impact),
               remarks(pair_))
  {
  }

  RunEnd work()
  {
    const dem::ContactModel &model = session_.input().material.packing.contact;
    warn_of_contact_model(session_);
    if (!pair_.impact && model.restitution_coefficient < 1)
      session_.warn("a path knows no time: Contact/Restitution coefficient is "
                    "not felt");
    for (const dem::Remark &remark : dem::judge_contacts(
             model,
             pair_material(pair_.material, pair_.partner),
             dem::shape_of(pair_.first, pair_.second).reduced_radius,
             "the contact"))
      session_.warn(remark.text);
    const dem::PairContact contact{
        dem::pair_laws(model, pair_.material, pair_.partner),
        dem::shape_of(pair_.first, pair_.second)};
    const RunEnd end = pair_.impact ? collide(contact) : follow(contact);
    session_.result("largest_normal_force[N]", largest_force_);
    session_.result("largest_tangential_force[N]", largest_rub_);
    session_.result("largest_overlap[m]", largest_overlap_);
    give(losses_);
    session_.draw(contact_plots(pair_.impact));
    return end;
  }

private:
  RunEnd follow(dem::PairContact contact)
  {
    PairPlace place{};
    unsigned step = 0;
    std::size_t stage = 0;
    write(step, contact, place, {1, 0, 0, 0, 0});
    for (const PairStage &part : pair_.stages) {
      ++stage;
      const PairPlace begin = place;
      for (unsigned k = 1; k <= part.steps; ++k) {
        const PairPlace before = place;
        for (std::size_t c = 0; c < place.size(); ++c)
          place[c] = k == part.steps
                         ? part.end[c]
                         : begin[c] + k * (part.end[c] - begin[c]) / part.steps;
        contact.advance(between(before, place));
        write(++step,
              contact,
              place,
              {static_cast<double>(stage),
               place[coordinate::spin],
               place[coordinate::rotation_x],
               place[coordinate::rotation_y],
               place[coordinate::rotation_z]});
        if (caught_signal())
          return RunSession::interrupted(caught_signal());
      }
    }
    session_.result("steps[-]", step);
    return {};
  }

  static dem::PairMotion between(const PairPlace &before, const PairPlace &now)
  {
    const auto change = [&](std::size_t c) { return now[c] - before[c]; };
    using namespace coordinate;
    dem::PairMotion motion{now[overlap]};
    motion.slip = {change(slip_x), change(slip_y), -change(overlap)};
    motion.spin = change(coordinate::spin);
    motion.rotation = {
        change(rotation_x), change(rotation_y), change(rotation_z)};
    return motion;
  }

  RunEnd collide(const dem::PairContact &contact)
  {
    dem::Impact impact(contact, {pair_.first, pair_.second}, pair_.time_steps);
    PairPlace place{};
    unsigned step = 0;
    Three patch = impact.rebound().patch_velocity;
    write(step, contact, place, state_of(impact));
    while (impact.step()) {
      const Three now = impact.rebound().patch_velocity;
      const double half = 0.5 * impact.time_step();
      place[coordinate::overlap] = impact.contact().overlap();
      place[coordinate::slip_x] -= half * (patch.x + now.x);
      place[coordinate::slip_y] -= half * (patch.y + now.y);
      patch = now;
      note(impact.contact());
      const bool over = impact.rebound().end != dem::Rebound::End::going_on;
      if (++step % pair_.record_interval == 0 || over)
        write(step, impact.contact(), place, state_of(impact));
      if (caught_signal())
        return RunSession::interrupted(caught_signal());
    }
    session_.result("steps[-]", step);
    give(impact);
    return {};
  }

  static std::vector<double> state_of(const dem::Impact &impact)
  {
    const dem::Body &first = impact.bodies()[0];
    return {impact.time(),
            first.velocity.x,
            first.velocity.y,
            first.velocity.z,
            first.spin.x,
            first.spin.y,
            first.spin.z,
            impact.rebound().kinetic_after};
  }

  void note(const dem::PairContact &contact)
  {
    const dem::PairForces &forces = contact.forces();
    largest_force_ = std::max(largest_force_, forces.push.force);
    largest_rub_ =
        std::max(largest_rub_, std::sqrt(dot(forces.rub, forces.rub)));
    largest_overlap_ = std::max(largest_overlap_, contact.overlap());
    losses_ = contact.losses();
  }

  void write(unsigned step,
             const dem::PairContact &contact,
             const PairPlace &place,
             const std::vector<double> &more)
  {
    note(contact);
    const dem::PairForces &forces = contact.forces();
    std::vector<double> values{static_cast<double>(step),
                               place[coordinate::overlap],
                               place[coordinate::slip_x],
                               place[coordinate::slip_y],
                               forces.push.force,
                               forces.rub.x,
                               forces.rub.y,
                               contact.contact_radius(),
                               contact.largest_overlap(),
                               static_cast<double>(contact.plastic()),
                               static_cast<double>(contact.slides())};
    values.insert(values.end(), more.begin(), more.end());
    for (const double value : {forces.moment.x,
                               forces.moment.y,
                               forces.moment.z,
                               contact.elastic_energy(),
                               losses_.plastic,
                               losses_.friction,
                               losses_.damping,
                               losses_.adhesion})
      values.push_back(value);
    curve_.write(values);
  }

  void give(const dem::Impact &impact)
  {
    const dem::Rebound end = impact.rebound();
    const bool stuck = end.end == dem::Rebound::End::stuck;
    const Three before = pair_.first.velocity;
    session_.result("contact_time[s]", end.duration);
    session_.result("sticks[-]", stuck);
    if (stuck)
      session_.warn("the bodies do not part: adhesion holds them");
    else
      session_.result("restitution_normal[-]", -end.normal_velocity / before.z);
    if (before.x != 0)
      session_.result("restitution_tangential[-]",
                      end.tangential_velocity.x / before.x);
    session_.result("rebound_spin[rad/s]", impact.bodies()[0].spin.y + 0.0);
    if (!stuck)
      session_.result("rebound_angle_of_patch[rad]",
                      std::atan2(end.patch_velocity.x, -end.normal_velocity));
    session_.result("kinetic_energy_before[J]", end.kinetic_before);
    session_.result("kinetic_energy_after[J]", end.kinetic_after);
    session_.result("energy_lost[-]",
                    1 - end.kinetic_after / end.kinetic_before);
  }

  void give(const dem::PairLosses &losses)
  {
    session_.result("plastic_dissipation[J]", losses.plastic);
    session_.result("friction_dissipation[J]", losses.friction);
    session_.result("damping_dissipation[J]", losses.damping);
    session_.result("adhesion_dissipation[J]", losses.adhesion);
  }

  RunSession &session_;
  const PairInput &pair_;
  CurveWriter curve_;
  double largest_force_ = 0, largest_rub_ = 0, largest_overlap_ = 0; // [N], [m]
  dem::PairLosses losses_;
};
} // namespace

int run_contact(const RunOptions &options)
{
  RunSession session("contact", options, Need::contact);
  watch_signals();
  return session.run([&] { return ContactRun(session).work(); });
}
} // namespace tamp::apps
