// SPDX-License-Identifier: BSD-3-Clause
#include <dem/hill_mandel.h>
#include <dem/measures.h>
#include <dem/motion.h>
#include <dem/stretch.h>
#include <dem/time_step.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tamp::dem
{
double
grain_mass(const UnitCell &cell, std::size_t grain, double density_scaling)
{
  const double r = cell.radius[grain];
  return 4.0 / 3 * std::numbers::pi * r * r * r * cell.material.density *
         density_scaling;
}

Motion::Motion(UnitCell &cell, const Dynamics &settings)
    : cell_(cell), time_step_fraction_(settings.time_step_fraction),
      rayleigh_(rayleigh_time_step(
          cell.material, cell.smallest_radius(), settings.density_scaling)),
      layout_(cell), affine_{cell.box.h, Matrix3::Zero()}
{
  cell_.velocity.resize(cell_.size(), Vector3::Zero());
  cell_.spin.resize(cell_.size(), Vector3::Zero());
  cell_.last = {};
  double total = 0;
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    mass_.push_back(grain_mass(cell_, i, settings.density_scaling));
    total += mass_.back();
  }
  damping_ =
      2 * settings.global_damping * total / double(cell_.size()) / rayleigh_;
  // Rotation is damped at the same rate as translation for a mean grain.
  const double radius = cell_.mean_radius();
  spin_damping_ = 0.4 * damping_ * radius * radius;
  list_pairs();
  sweep(Memory::frozen);
}

/// The frequency is that of the stiffness around a grain: of its translation
/// and of its rotation, of which 5/2 k_t / m is the measure.
double Motion::time_step() const
{
  const SweepLayout::Stiffness stiffness = layout_.stiffness(cell_.box);
  double frequency2 = 0;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    frequency2 = std::max({frequency2,
                           2 * stiffness.both[i] / mass_[i],
                           5 * stiffness.tangential[i] / mass_[i]});
  // The global damping is centred and does not count.
  return time_step_fraction_ *
         std::min(rayleigh_, stable_time_step(std::sqrt(frequency2), 0));
}

void Motion::list_pairs()
{
  layout_.list_pairs(cell_.neighbours, cell_.box, cell_.place, cell_.contacts);
  approached_ = 0;
}

/// Half a step of eqs (1) and (2). The first half is implicit in the velocity,
/// the second explicit: together with the half before it, it is the step with
/// centred damping.
void Motion::half_kick(bool first)
{
  const std::span<const GrainRow> rows = layout_.rows();
  const double half = 0.5 * step_;
  double heat = 0;
  const auto kick = [&](Vector3 &velocity,
                        const Vector3 &force,
                        double inertia,
                        double damping) {
    const Vector3 before = velocity;
    const double a = half * damping / inertia;
    if (first)
      velocity = (velocity + half / inertia * force) / (1 + a);
    else
      velocity = (1 - a) * velocity + half / inertia * force;
    heat += 0.5 * damping * (first ? velocity : before).dot(velocity + before);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double r = cell_.radius[i];
    const Vector3 force(rows[i].force), torque(rows[i].force + 4);
    kick(cell_.velocity[i], force, mass_[i], damping_);
    kick(cell_.spin[i], r * torque, 0.4 * mass_[i] * r * r, spin_damping_);
  }
  cell_.energy.damping_dissipation += heat * half;
}

/// Places after a step; the box moves exactly.
void Motion::drift(const Matrix3 &box)
{
  cell_.box.h = box;
  affine_.h = box;
  const Matrix3 inverse = box.inverse();
  const std::span<GrainRow> rows = layout_.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector3 moved = step_ * cell_.velocity[i];
    cell_.place[i] += inverse * moved;
    const Vector3 relative = step_back_ * moved;
    const Vector3 rolled = step_ * cell_.radius[i] * cell_.spin[i];
    for (int k = 0; k < 3; ++k) {
      rows[i].place[k] = cell_.place[i][k];
      rows[i].motion[k] = relative[k];
      rows[i].motion[4 + k] = rolled[k];
    }
  }
}

/// A pair outside the list approaches by at most two drifts and the stretch of
/// one reach.
void Motion::renew_pairs(double affine_approach)
{
  double fastest2 = 0;
  for (const Vector3 &v : cell_.velocity)
    fastest2 = std::max(fastest2, v.squaredNorm());
  approached_ += 2 * step_ * std::sqrt(fastest2) + affine_approach;
  if (approached_ <= layout_.gap())
    return;
  cell_.contacts = layout_.contacts().memories();
  list_pairs();
}

void Motion::sweep(Memory memory)
{
  totals_ = layout_.sweep(affine_, memory);
  if (memory == Memory::written) {
    cell_.energy.friction_dissipation += totals_.slid_work;
    cell_.energy.plastic_dissipation += totals_.yielded_work;
    cell_.contacts = layout_.contacts().memories();
  }
  stress_volume_ = cell_.box.volume() * love_weber_stress(cell_);
}

bool Motion::advance(const Matrix3 &log_stretch,
                     std::size_t steps,
                     double time_step)
{
  step_ = time_step;
  const Matrix3 first_box = cell_.box.h;
  const Matrix3 part = log_stretch / double(steps);
  step_back_ = exponential(-part);
  affine_.gradient = Matrix3::Identity() - step_back_;
  const double reach = 2 * cell_.largest_radius() + layout_.gap();
  const double affine_approach = 1.01 * largest_principal(part) * reach;
  for (std::size_t step = 1; step <= steps; ++step) {
    half_kick(true);
    drift(exponential(log_stretch * (double(step) / double(steps))) *
          first_box);
    renew_pairs(affine_approach);
    const Matrix3 before = stress_volume_;
    sweep(Memory::written);
    cell_.energy.work +=
        0.5 * ((before + stress_volume_).array() * part.array()).sum();
    half_kick(false);
    ++steps_;
    if (!std::isfinite(totals_.normal_force) || totals_.largest_overlap > 2)
      return false;
  }
  return true;
}

Matrix3 Motion::stress() const
{
  return stress_volume_ / cell_.box.volume();
}

double Motion::unbalance() const
{
  double sum = 0;
  for (const GrainRow &row : layout_.rows())
    sum += Vector3(row.force).norm();
  return totals_.normal_force > 0
             ? sum / double(cell_.size()) /
                   (totals_.normal_force / double(totals_.contacts))
             : 0.0;
}

double Motion::hill_mandel() const
{
  // What each grain did in the last step, with the velocity of its middle.
  std::vector<double> motion;
  const Matrix3 forth = step_back_.inverse();
  for (const GrainRow &row : layout_.rows()) {
    const Vector3 moved = forth * Vector3(row.motion);
    motion.insert(motion.end(), moved.begin(), moved.end());
    motion.insert(motion.end(), row.motion + 4, row.motion + 7);
  }
  return hill_mandel_residual(cell_, step_back_, motion);
}
} // namespace tamp::dem
