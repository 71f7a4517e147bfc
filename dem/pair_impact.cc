// SPDX-License-Identifier: BSD-3-Clause
#include <dem/pair_impact.h>
#include <dem/value_check.h>

#include <cmath>

namespace tamp::dem
{
namespace
{
/// Time of a Hertz contact over sqrt(m* / stiffness at the largest overlap):
/// 2.9433 sqrt(15/8).
constexpr double contact_time = 4.0303;
/// An impact that takes this many times longer than an elastic one does not
/// end.
constexpr double patience = 1000;

/// Largest overlap of an elastic impact: (15 m* v^2 / (16 E* sqrt(R*)))^(2/5).
/// Source: Johnson (1985), section 11.4.
double elastic_overlap(const PairContact &contact, double speed)
{
  const PairShape<double> &pair = contact.shape();
  return std::pow(
      15 * speed * speed /
          (16 * pair.inverse_mass * contact.laws().effective_modulus *
           std::sqrt(pair.reduced_radius)),
      0.4);
}
} // namespace

Impact::Impact(const PairContact &contact,
               const std::array<Body, 2> &bodies,
               double steps)
    : contact_(contact), bodies_(bodies)
{
  const double reach =
      bodies[0].radius + (bodies[1].is_wall() ? 0 : bodies[1].radius);
  bodies_[0].place = bodies[1].place - Triple<double>{0, 0, reach};
  const double speed = closing_speed();
  Positive{}(speed, "speed of approach");
  Positive{}(steps, "time steps in a contact");
  const double elastic =
      contact_time * contact_.time_scale(elastic_overlap(contact_, speed));
  step_ = elastic / steps;
  longest_ = patience * elastic;
  rebound_.kinetic_before = kinetic_energy();
}

Impact::Geometry Impact::geometry() const
{
  const auto &[first, second] = bodies_;
  const Triple<double> branch = second.place - first.place;
  if (second.is_wall())
    return {{0, 0, 1}, first.radius - branch.z, {first.radius, 0}};
  const double distance = sqrt(dot(branch, branch));
  const double sum = first.radius + second.radius;
  return {(1 / distance) * branch,
          sum - distance,
          {first.radius * distance / sum, second.radius * distance / sum}};
}

Triple<double> Impact::surface_velocity(const Geometry &now) const
{
  const auto &[first, second] = bodies_;
  return second.velocity - first.velocity -
         cross(now.arm[0] * first.spin + now.arm[1] * second.spin, now.normal);
}

double Impact::closing_speed() const
{
  return dot(bodies_[0].velocity - bodies_[1].velocity, geometry().normal);
}

double Impact::kinetic_energy() const
{
  return bodies_[0].kinetic_energy() + bodies_[1].kinetic_energy();
}

/// Half a step of the velocities.
void Impact::kick(const Geometry &now)
{
  const PairForces &forces = contact_.forces();
  const Triple<double> force = forces.rub - forces.push.force * now.normal;
  const Triple<double> twist = cross(now.normal, forces.rub);
  for (int k = 0; k < 2; ++k) {
    Body &body = bodies_[k];
    if (body.is_wall())
      continue;
    const double sign = k == 0 ? 1 : -1;
    const double inertia = 0.4 * body.mass * body.radius * body.radius;
    body.velocity = body.velocity + (sign * 0.5 * step_ / body.mass) * force;
    body.spin = body.spin + (0.5 * step_ / inertia) *
                                (now.arm[k] * twist + sign * forces.moment);
  }
}

bool Impact::step()
{
  if (rebound_.end != Rebound::End::going_on)
    return false;
  kick(geometry());
  for (Body &body : bodies_)
    body.place = body.place + step_ * body.velocity;
  const Geometry now = geometry();
  const auto &[first, second] = bodies_;
  PairMotion motion{now.overlap};
  motion.slip = step_ * surface_velocity(now);
  // The mean by radius; that of a wall has no end.
  const double share =
      second.is_wall() ? 0 : first.radius / (first.radius + second.radius);
  motion.spin =
      step_ * dot(share * first.spin + (1 - share) * second.spin, now.normal);
  motion.rotation = step_ * (first.spin - second.spin);
  motion.normal = now.normal;
  motion.time = step_;
  contact_.advance(motion);
  kick(now);
  time_ += step_;
  note();
  return true;
}

/// What the last step has brought.
void Impact::note()
{
  const double force = contact_.forces().push.force;
  rebound_.largest_force = max(rebound_.largest_force, force);
  rebound_.largest_overlap = max(rebound_.largest_overlap, contact_.overlap());
  if (force != 0)
    rebound_.duration = time_;
  const bool touches = contact_.touches();
  const double closing = closing_speed();
  touched_ = touched_ || touches;
  if (touched_ && !touches && closing < 0)
    rebound_.end = Rebound::End::parted;
  else if ((turned_ && closing > 0) || time_ > longest_)
    rebound_.end = Rebound::End::stuck;
  turned_ = turned_ || closing < 0;
}

Rebound Impact::rebound() const
{
  Rebound now = rebound_;
  const Geometry at = geometry();
  const Triple<double> velocity = bodies_[0].velocity - bodies_[1].velocity;
  now.normal_velocity = dot(velocity, at.normal);
  now.tangential_velocity = across(velocity, at.normal);
  now.patch_velocity = -1.0 * across(surface_velocity(at), at.normal);
  now.kinetic_after = kinetic_energy();
  return now;
}
} // namespace tamp::dem
