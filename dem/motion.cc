// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/hill_mandel.h>
#include <dem/kernel/kernel.h>
#include <dem/measures.h>
#include <dem/motion.h>
#include <dem/stretch.h>
#include <dem/sweep_layout.h>
#include <dem/time_step.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace tamp::dem
{
namespace
{
// Time steps between two looks at the stress: far below the time in which
// grains swing.
constexpr std::size_t steps_between_looks = 4;

/// The first three numbers of a part of a row.
template <class T>
Vector3 head(const T *part)
{
  return {double(part[0]), double(part[1]), double(part[2])};
}

/// Motion with sweeps in the precision of T.
template <class T>
class MotionIn final : public Motion
{
public:
  MotionIn(UnitCell &cell,
           const Dynamics &settings,
           const Arithmetic &arithmetic);

  bool advance(const Matrix3 &log_stretch,
               std::size_t steps,
               double time_step) override;
  void write_cell() override;
  double time_step() const override;
  Matrix3 stress() const override { return -moment_ / cell_.box.volume(); }
  double unbalance() const override;
  double hill_mandel() const override;
  std::size_t steps() const override { return steps_; }

private:
  void list_pairs();
  void read_velocities();
  void write_velocities();
  void half_kick(bool first);
  TimeStepSums first_drift();
  void renew_pairs(double approach);
  void book_work(const Matrix3 &log_stretch);

  UnitCell &cell_;
  double fraction_, rayleigh_;
  const GrainLoops<T> &loops_;
  SweepLayout<T> layout_;
  std::vector<MovingGrain> grains_;
  SweepTotals totals_;
  Matrix3 moment_ = Matrix3::Zero(); // when it was last looked at [N m]
  std::vector<double> mass_;         // [kg]
  std::vector<Vector3> listed_;      // places when the pairs were listed
  double damping_ = 0;               // beta_g [kg/s]
  double spin_damping_ = 0;          // [kg m2/s]
  double contact_damping_ = 0;       // beta of the contacts [-]
  double plastic_loss_ = 0; // of the listed contacts, booked already [J]
  TimeStep step_{};
  Matrix3 step_back_ = Matrix3::Identity();
  AffineMotion affine_;
  double approached_ = 0; // of unlisted pairs, since the pairs were listed [m]
  std::size_t steps_listed_ = 0; // since the pairs were listed
  std::size_t steps_ = 0;
};

template <class T>
MotionIn<T>::MotionIn(UnitCell &cell,
                      const Dynamics &settings,
                      const Arithmetic &arithmetic)
    : cell_(cell), fraction_(settings.time_step_fraction),
      rayleigh_(std::numeric_limits<double>::infinity()),
      loops_(kernel_of(arithmetic.instruction_set).loops<T>().grains),
      layout_(cell, arithmetic.instruction_set), grains_(cell.size())
{
  cell_.velocity.resize(cell_.size(), Vector3::Zero());
  cell_.spin.resize(cell_.size(), Vector3::Zero());
  cell_.last = {};
  double total = 0;
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    mass_.push_back(settings.density_scaling * cell_.mass(i));
    total += mass_.back();
    // Dashpots of contacts are those of the scaled masses.
    layout_.rows()[i].motion[7] = T(1 / mass_.back());
    rayleigh_ = std::min(rayleigh_,
                         rayleigh_time_step(cell_.material_of(i),
                                            cell_.radius[i],
                                            settings.density_scaling));
  }
  damping_ =
      2 * settings.global_damping * total / double(cell_.size()) / rayleigh_;
  step_.local_damping = settings.local_damping;
  // Rotation is damped at the same rate as translation for a mean grain.
  const double radius = cell_.mean_radius();
  spin_damping_ = 0.4 * damping_ * radius * radius;
  const CellLaws laws(cell);
  for (std::size_t kind = 0; kind < laws.kinds(); ++kind)
    if (const auto &viscous = laws.of_kind(kind).viscous)
      contact_damping_ = std::max(contact_damping_, viscous->damping());
  list_pairs();
  totals_ = layout_.sweep(affine_, {Memory::frozen, true});
  moment_ = totals_.moment;
}

/// The frequency is that of the stiffness around a grain: of its translation
/// and of its rotation, of which 5/2 k_t / m is the measure.
template <class T>
double MotionIn<T>::time_step() const
{
  const auto stiffness = layout_.stiffness();
  double step = rayleigh_;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double frequency2 = std::max(2 * stiffness.both[i] / mass_[i],
                                       5 * stiffness.tangential[i] / mass_[i]);
    const double ratio = contact_damping_ * std::sqrt(stiffness.contacts[i]);
    // The global damping is centred and does not count.
    step = std::min(step, stable_time_step(std::sqrt(frequency2), ratio));
  }
  return fraction_ * step;
}

/// Lists the pairs where the grains are. A pair that leaves the list takes its
/// loss, which is booked already, with it.
template <class T>
void MotionIn<T>::list_pairs()
{
  layout_.list_pairs(cell_, cell_.box, cell_.place, affine_.stretch);
  layout_.read_memories(cell_);
  plastic_loss_ = survey_contacts(cell_).plastic_loss;
  listed_ = cell_.place;
  for (MovingGrain &grain : grains_)
    std::ranges::fill(grain.moved, 0.0);
  approached_ = 0;
  steps_listed_ = 0;
}

template <class T>
void MotionIn<T>::write_cell()
{
  const Matrix3 inverse = cell_.box.h.inverse();
  for (std::size_t i = 0; i < grains_.size(); ++i)
    cell_.place[i] = listed_[i] + inverse * head(grains_[i].moved);
  layout_.read_memories(cell_);
  const double loss = survey_contacts(cell_).plastic_loss;
  cell_.energy.plastic_dissipation += loss - plastic_loss_;
  plastic_loss_ = loss;
}

/// Lays out velocities, and what a step does to them, in rows.
template <class T>
void MotionIn<T>::read_velocities()
{
  const auto lay_out = [&](MovingGrain &grain,
                           int part,
                           const Vector3 &velocity,
                           double inertia,
                           double damping) {
    std::copy_n(velocity.data(), 3, grain.velocity + 4 * part);
    grain.velocity[4 * part + 3] = 0;
    grain.damping[part] = damping;
    grain.gain[part] = step_.length / (inertia + 0.5 * step_.length * damping);
  };
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const double r = cell_.radius[i];
    lay_out(grains_[i], 0, cell_.velocity[i], mass_[i], damping_);
    // Of radius x spin: its inertia is I / r^2.
    lay_out(grains_[i],
            1,
            r * cell_.spin[i],
            0.4 * mass_[i],
            spin_damping_ / (r * r));
  }
}

template <class T>
void MotionIn<T>::write_velocities()
{
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    cell_.velocity[i] = head(grains_[i].velocity);
    cell_.spin[i] = head(grains_[i].velocity + 4) / cell_.radius[i];
  }
}

/// Half a step of eqs (1) and (2). The first half is implicit in the velocity,
/// the second explicit: together with the half before it, it is the step with
/// centred damping.
template <class T>
void MotionIn<T>::half_kick(bool first)
{
  const double half = 0.5 * step_.length;
  double heat = 0;
  for (std::size_t i = 0; i < grains_.size(); ++i)
    for (int k : {0, 1, 2, 4, 5, 6}) {
      const bool turning = k >= 4;
      const double r = cell_.radius[i];
      const double inertia = turning ? 0.4 * mass_[i] : mass_[i];
      const double damping = turning ? spin_damping_ / (r * r) : damping_;
      double &velocity = grains_[i].velocity[k];
      const double before = velocity, a = half * damping / inertia;
      const double force = layout_.rows()[i].force[k];
      const double drag = step_.local_damping * std::copysign(force, before);
      const double push = half / inertia * (force - drag);
      velocity =
          first ? (velocity + push) / (1 + a) : (1 - a) * velocity + push;
      heat += 0.5 * (damping * (first ? velocity : before) + drag) *
              (velocity + before);
    }
  cell_.energy.damping_dissipation += heat * half;
}

/// The drift after the first half kick: a step that leaves the velocities.
template <class T>
TimeStepSums MotionIn<T>::first_drift()
{
  std::vector<MovingGrain> drifting = grains_;
  for (MovingGrain &grain : drifting)
    for (int part : {0, 1})
      grain.gain[part] = grain.damping[part] = 0;
  const TimeStepSums sums = loops_.advance(
      step_, layout_.rows().data(), drifting.data(), drifting.size());
  for (std::size_t i = 0; i < grains_.size(); ++i)
    std::copy_n(drifting[i].moved, 8, grains_[i].moved);
  return sums;
}

/// @param approach  of two grains in a step, at most [m]
template <class T>
void MotionIn<T>::renew_pairs(double approach)
{
  approached_ += approach;
  ++steps_listed_;
  // Branches that are carried on in single precision lose what is small
  // against them.
  constexpr std::size_t most_steps = 512;
  const bool worn = std::is_same_v<T, float> && steps_listed_ == most_steps;
  if (approached_ <= layout_.gap() && !worn)
    return;
  write_cell();
  list_pairs();
}

/// Books the work of the stress since it was last looked at.
template <class T>
void MotionIn<T>::book_work(const Matrix3 &log_stretch)
{
  cell_.energy.work -=
      0.5 * ((moment_ + totals_.moment).array() * log_stretch.array()).sum();
  moment_ = totals_.moment;
}

template <class T>
bool MotionIn<T>::advance(const Matrix3 &log_stretch,
                          std::size_t steps,
                          double time_step)
{
  const Matrix3 first_box = cell_.box.h;
  const Matrix3 part = log_stretch / double(steps);
  affine_.stretch = exponential(part);
  step_back_ = exponential(-part);
  step_.length = time_step;
  for (int k = 0; k < 9; ++k)
    step_.stretch[k] = affine_.stretch(k / 3, k % 3);
  affine_.time = time_step;
  read_velocities();
  half_kick(true);
  // A pair outside the list approaches by two drifts and the stretch of one
  // reach.
  const double reach = 2 * cell_.largest_radius() + layout_.gap();
  const double affine_approach = 1.01 * largest_principal(part) * reach;
  constexpr std::size_t exact_boxes = 64; // else the product of steps
  for (std::size_t step = 1; step <= steps; ++step) {
    const TimeStepSums sums =
        step == 1
            ? first_drift()
            : loops_.advance(
                  step_, layout_.rows().data(), grains_.data(), grains_.size());
    if (step > 1)
      cell_.energy.damping_dissipation += sums.heat;
    cell_.box.h =
        step % exact_boxes == 0 || step == steps
            ? exponential(log_stretch * (double(step) / double(steps))) *
                  first_box
            : affine_.stretch * cell_.box.h;
    renew_pairs(2 * time_step * std::sqrt(sums.fastest2) + affine_approach);
    const bool look = step % steps_between_looks == 0 || step == steps;
    totals_ = layout_.sweep(affine_, {Memory::written, look, true});
    cell_.energy.friction_dissipation += totals_.lost_work;
    cell_.energy.damping_dissipation += totals_.damped_work;
    cell_.energy.adhesion_dissipation += totals_.adhesion_loss;
    cell_.energy.plastic_dissipation += totals_.forgotten_loss;
    if (look)
      book_work(part * double((step - 1) % steps_between_looks + 1));
    ++steps_;
    if (!std::isfinite(totals_.normal_force) || totals_.too_deep)
      return false;
  }
  half_kick(false);
  write_velocities();
  return true;
}

template <class T>
double MotionIn<T>::unbalance() const
{
  double sum = 0;
  for (const GrainRow<T> &row : layout_.rows())
    sum += head(row.force).norm();
  return totals_.normal_force > 0
             ? sum / double(cell_.size()) /
                   (totals_.normal_force / double(totals_.contacts))
             : 0.0;
}

template <class T>
double MotionIn<T>::hill_mandel() const
{
  // What each grain did in the last step, with the velocity of its middle.
  std::vector<double> motion;
  for (const GrainRow<T> &row : layout_.rows()) {
    const Vector3 moved = head(row.motion);
    motion.insert(motion.end(), moved.begin(), moved.end());
    motion.insert(motion.end(), row.motion + 4, row.motion + 7);
  }
  return hill_mandel_residual(cell_, contact_forces(cell_), step_back_, motion);
}
} // namespace

std::unique_ptr<Motion> start_motion(UnitCell &cell,
                                     const Dynamics &settings,
                                     const Arithmetic &arithmetic)
{
  if (arithmetic.precision == Precision::mixed)
    return std::make_unique<MotionIn<float>>(cell, settings, arithmetic);
  return std::make_unique<MotionIn<double>>(cell, settings, arithmetic);
}

CellAnswer end_motion(Motion &motion, Outcome outcome)
{
  CellAnswer answer;
  answer.outcome = outcome;
  answer.evaluations = motion.steps();
  if (outcome == Outcome::diverged)
    return answer;
  motion.write_cell();
  answer.stress = motion.stress();
  answer.unbalance = motion.unbalance();
  answer.hill_mandel = motion.hill_mandel();
  return answer;
}
} // namespace tamp::dem
