// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/ended_contact.h>
#include <dem/pair_path.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
PairContact::PairContact(const PairLaws &laws, const PairShape<double> &shape)
    : laws_(laws), shape_(shape), more_(laws.more(), 0)
{
  check_size(laws, shape.reduced_radius);
}

const PairForces &PairContact::advance(const PairMotion &motion)
{
  const bool damped = laws_.viscous && motion.time > 0;
  push(motion.overlap);
  elastic_push_ = forces_.push;
  const double damping = damped ? damp_push(motion) : 0;
  rub(motion);
  if (damped)
    damp_rub(motion, damping);
  roll(motion);
  return forces_;
}

NormalMemory<double> PairContact::memory(std::vector<double> &more) const
{
  return {largest_overlap_, contact_radius_, more.data()};
}

NormalEnergy PairContact::normal_energy() const
{
  std::vector<double> more = more_;
  return std::visit(
      [&](const auto &law) {
        return law.energy(overlap_, shape_, memory(more));
      },
      laws_.normal);
}

void PairContact::push(double overlap)
{
  std::vector<double> before = more_;
  const NormalMemory<double> old = memory(before);
  NormalMemory<double> now = memory(more_);
  forces_.push = std::visit(
      [&](const auto &law) { return law(overlap, shape_, now); }, laws_.normal);
  const EndedContact ended =
      end_of(laws_.normal, shape_, old, overlap, forces_.push.contact_radius);
  losses_.adhesion += ended.adhesion;
  losses_.plastic += ended.forgotten;
  old_radius_ = contact_radius_;
  overlap_ = overlap;
  contact_radius_ = forces_.push.contact_radius;
  largest_overlap_ = now.largest_overlap;
  // A contact is remembered while the grains overlap or stick.
  if (contact_radius_ > 0 || overlap > 0)
    return;
  largest_overlap_ = 0;
  std::fill_n(more_.begin(), laws_.normal_more(), 0);
}

/// Answers with the force of damping [N].
double PairContact::damp_push(const PairMotion &motion)
{
  const double closing = -dot(motion.slip, motion.normal) / motion.time;
  const double force =
      laws_.viscous->normal_force(shape_, forces_.push, closing);
  forces_.push.force += force;
  losses_.damping += force * closing * motion.time;
  return force;
}

void PairContact::rub(const PairMotion &motion)
{
  const ContactMotion<double> now{shape_,
                                  motion.normal,
                                  motion.slip,
                                  motion.spin,
                                  old_radius_,
                                  forces_.push};
  double *const own = more_.data() + laws_.normal_more();
  const TangentialAnswer<double> answer =
      std::visit([&](const auto &law) { return law(tangential_, now, own); },
                 laws_.tangential);
  losses_.friction += answer.lost_work;
  tangential_ = touches() ? answer.force : Triple<double>{0, 0, 0};
  forces_.rub = tangential_;
  if (!touches())
    std::fill_n(own, laws_.tangential_more(), 0);
}

/// @param damping  what it adds to the normal force [N]
void PairContact::damp_rub(const PairMotion &motion, double damping)
{
  ViscousMotion<double> now;
  now.pair = shape_;
  now.normal = motion.normal;
  now.velocity = (1 / motion.time) * motion.slip;
  now.push = forces_.push;
  now.force = tangential_;
  std::visit(
      [&](const auto &law) {
        now.cap = law.cap(now.push);
        now.stiffness = law.stiffness(now.push.contact_radius);
      },
      laws_.tangential);
  // The whole force is known; damping wants the elastic part.
  now.push.force -= damping;
  const ViscousAnswer<double> answer = (*laws_.viscous)(now);
  forces_.rub = now.force + answer.force + damping * motion.normal;
  losses_.damping += dot(forces_.rub - now.force, motion.slip);
  // Where a contact starts to slide, the spring takes over the force of the
  // dashpot, and with it energy.
  if (laws_.tangential_more() == 0 && now.stiffness > 0)
    losses_.damping -=
        (dot(answer.kept, answer.kept) - dot(now.force, now.force)) /
        (2 * now.stiffness);
  tangential_ = answer.kept;
}

void PairContact::roll(const PairMotion &motion)
{
  if (!laws_.rolling)
    return;
  double *const own =
      more_.data() + laws_.normal_more() + laws_.tangential_more();
  const RollingMotion<double> now{shape_,
                                  motion.normal,
                                  motion.rotation,
                                  motion.spin,
                                  old_radius_,
                                  forces_.push};
  const RollingAnswer<double> answer =
      (*laws_.rolling)({own[0], own[1], own[2]}, now, own + 3);
  const bool held = touches();
  forces_.moment = held ? answer.moment : Triple<double>{0, 0, 0};
  own[0] = forces_.moment.x;
  own[1] = forces_.moment.y;
  own[2] = forces_.moment.z;
  losses_.friction += answer.lost_work;
  if (!held)
    std::fill_n(own, laws_.rolling_more(), 0);
}

bool PairContact::plastic() const
{
  std::vector<double> more = more_;
  return std::visit(
      [&](const auto &law) { return law.is_plastic(shape_, memory(more)); },
      laws_.normal);
}

bool PairContact::slides() const
{
  // Laws leave a sliding contact on the cap up to round-off.
  constexpr double round_off = 1e-6;
  const double cap = std::visit(
      [&](const auto &law) { return law.cap(forces_.push); }, laws_.tangential);
  const double size = sqrt(dot(forces_.rub, forces_.rub));
  return cap > 0 && size >= (1 - round_off) * cap;
}

double PairContact::elastic_energy() const
{
  return normal_energy().elastic;
}

double PairContact::spring_energy() const
{
  return dem::spring_energy(laws_,
                            shape_,
                            elastic_push_,
                            tangential_,
                            more_.data() + laws_.normal_more());
}

PairLosses PairContact::losses() const
{
  PairLosses all = losses_;
  if (contact_radius_ > 0 || overlap_ > 0)
    all.plastic += normal_energy().dissipated;
  return all;
}

double PairContact::time_scale(double overlap) const
{
  std::vector<double> more = more_;
  NormalMemory<double> deep = memory(more);
  deep.largest_overlap = std::max(largest_overlap_, overlap);
  const double slope = std::visit(
      [&](const auto &law) { return law.steepest_slope(shape_, deep); },
      laws_.normal);
  return 1 / std::sqrt(slope * shape_.inverse_mass);
}
} // namespace tamp::dem
