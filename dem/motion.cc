// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/hill_mandel.h>
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
#include <vector>

namespace tamp::dem
{
namespace
{
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
  Matrix3 stress() const override
  {
    return -totals_.moment / cell_.box.volume();
  }
  double unbalance() const override;
  double hill_mandel() const override;
  std::size_t steps() const override { return steps_; }

private:
  void list_pairs();
  void half_kick(bool first);
  void drift(const Matrix3 &box);
  void renew_pairs(double affine_approach);

  UnitCell &cell_;
  double fraction_, rayleigh_;
  SweepLayout<T> layout_;
  SweepTotals totals_;
  std::vector<double> mass_;    // [kg]
  std::vector<Vector3> listed_; // places when the pairs were listed
  std::vector<Vector3> moved_;  // since then, less the motion of the box [m]
  double damping_ = 0;          // beta_g [kg/s]
  double spin_damping_ = 0;     // [kg m2/s]
  double contact_damping_ = 0;  // beta of the contacts [-]
  double plastic_loss_ = 0;     // of the listed contacts, booked already [J]
  double step_ = 0;             // [s]
  Matrix3 step_stretch_ = Matrix3::Identity();
  Matrix3 step_back_ = Matrix3::Identity();
  Matrix3 listed_back_; // inverse of the box when the pairs were listed
  AffineMotion affine_;
  double approached_ = 0; // of unlisted pairs, since the pairs were listed [m]
  std::size_t steps_ = 0;
};

template <class T>
MotionIn<T>::MotionIn(UnitCell &cell,
                      const Dynamics &settings,
                      const Arithmetic &arithmetic)
    : cell_(cell), fraction_(settings.time_step_fraction),
      rayleigh_(std::numeric_limits<double>::infinity()),
      layout_(cell, arithmetic.instruction_set), listed_(cell.place),
      moved_(cell.size(), Vector3::Zero()), affine_{Matrix3::Identity(),
                                                    Matrix3::Zero()}
{
  cell_.velocity.resize(cell_.size(), Vector3::Zero());
  cell_.spin.resize(cell_.size(), Vector3::Zero());
  cell_.last = {};
  double total = 0;
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    mass_.push_back(settings.density_scaling * cell_.mass(i));
    total += mass_.back();
    // Dashpots of contacts are those of the scaled masses.
    layout_.rows()[i].inverse_mass = T(1 / mass_.back());
    rayleigh_ = std::min(rayleigh_,
                         rayleigh_time_step(cell_.material_of(i),
                                            cell_.radius[i],
                                            settings.density_scaling));
  }
  damping_ =
      2 * settings.global_damping * total / double(cell_.size()) / rayleigh_;
  // Rotation is damped at the same rate as translation for a mean grain.
  const double radius = cell_.mean_radius();
  spin_damping_ = 0.4 * damping_ * radius * radius;
  const CellLaws laws(cell);
  for (std::size_t kind = 0; kind < laws.kinds(); ++kind)
    if (const auto &viscous = laws.of_kind(kind).viscous)
      contact_damping_ = std::max(contact_damping_, viscous->damping());
  list_pairs();
  totals_ = layout_.sweep(affine_, {Memory::frozen, true});
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
  layout_.list_pairs(cell_, cell_.box, cell_.place);
  layout_.read_memories(cell_);
  plastic_loss_ = plastic_loss(cell_);
  listed_ = cell_.place;
  listed_back_ = cell_.box.h.inverse();
  affine_.stretch = Matrix3::Identity();
  std::ranges::fill(moved_, Vector3::Zero());
  approached_ = 0;
}

template <class T>
void MotionIn<T>::write_cell()
{
  const Matrix3 inverse = cell_.box.h.inverse();
  for (std::size_t i = 0; i < moved_.size(); ++i)
    cell_.place[i] = listed_[i] + inverse * moved_[i];
  layout_.read_memories(cell_);
  const double loss = plastic_loss(cell_);
  cell_.energy.plastic_dissipation += loss - plastic_loss_;
  plastic_loss_ = loss;
}

/// Half a step of eqs (1) and (2). The first half is implicit in the velocity,
/// the second explicit: together with the half before it, it is the step with
/// centred damping.
template <class T>
void MotionIn<T>::half_kick(bool first)
{
  const std::span<const GrainRow<T>> rows = layout_.rows();
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
    kick(cell_.velocity[i], head(rows[i].force), mass_[i], damping_);
    kick(cell_.spin[i],
         r * head(rows[i].force + 4),
         0.4 * mass_[i] * r * r,
         spin_damping_);
  }
  cell_.energy.damping_dissipation += heat * half;
}

/// Motions after a step; the box moves exactly.
template <class T>
void MotionIn<T>::drift(const Matrix3 &box)
{
  cell_.box.h = box;
  affine_.stretch = box * listed_back_;
  const std::span<GrainRow<T>> rows = layout_.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector3 went = step_ * cell_.velocity[i];
    const Vector3 turned = step_ * cell_.spin[i];
    moved_[i] = step_stretch_ * moved_[i] + went;
    const Vector3 relative = step_back_ * went;
    for (int k = 0; k < 3; ++k) {
      rows[i].moved[k] = T(moved_[i][k]);
      rows[i].motion[k] = T(relative[k]);
      rows[i].rotation[k] = T(turned[k]);
      rows[i].motion[4 + k] = T(cell_.radius[i] * turned[k]);
    }
  }
}

/// A pair outside the list approaches by at most two drifts and the stretch of
/// one reach.
template <class T>
void MotionIn<T>::renew_pairs(double affine_approach)
{
  double fastest2 = 0;
  for (const Vector3 &v : cell_.velocity)
    fastest2 = std::max(fastest2, v.squaredNorm());
  approached_ += 2 * step_ * std::sqrt(fastest2) + affine_approach;
  if (approached_ <= layout_.gap())
    return;
  write_cell();
  list_pairs();
}

template <class T>
bool MotionIn<T>::advance(const Matrix3 &log_stretch,
                          std::size_t steps,
                          double time_step)
{
  step_ = time_step;
  const Matrix3 first_box = cell_.box.h;
  const Matrix3 part = log_stretch / double(steps);
  step_stretch_ = exponential(part);
  step_back_ = exponential(-part);
  affine_.gradient = Matrix3::Identity() - step_back_;
  affine_.time = time_step;
  const double reach = 2 * cell_.largest_radius() + layout_.gap();
  const double affine_approach = 1.01 * largest_principal(part) * reach;
  for (std::size_t step = 1; step <= steps; ++step) {
    half_kick(true);
    drift(exponential(log_stretch * (double(step) / double(steps))) *
          first_box);
    renew_pairs(affine_approach);
    const Matrix3 before = totals_.moment;
    totals_ = layout_.sweep(affine_, {Memory::written, true});
    cell_.energy.friction_dissipation += totals_.lost_work;
    cell_.energy.damping_dissipation += totals_.damped_work;
    cell_.energy.work -=
        0.5 * ((before + totals_.moment).array() * part.array()).sum();
    half_kick(false);
    ++steps_;
    if (!std::isfinite(totals_.normal_force) || totals_.too_deep)
      return false;
  }
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
    const Vector3 moved = step_stretch_ * head(row.motion);
    motion.insert(motion.end(), moved.begin(), moved.end());
    motion.insert(motion.end(), row.motion + 4, row.motion + 7);
  }
  return hill_mandel_residual(cell_, step_back_, motion);
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
