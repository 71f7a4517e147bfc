// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/hill_mandel.h>
#include <dem/measures.h>
#include <dem/stretch.h>
#include <dem/sweep_layout.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tamp::dem
{
namespace
{
// Grains under a larger mean force, over the contact force, are not near static
// equilibrium.
constexpr double largest_unbalance = 1e-2;

/// The first three numbers of a part of a row.
template <class T>
Vector3 head(const T *part)
{
  return {double(part[0]), double(part[1]), double(part[2])};
}

/// Motion of all grains along one stretch, with sweeps in the precision of T.
template <class T>
class Motion
{
public:
  Motion(UnitCell &cell,
         const Stretch &stretch,
         const Dynamics &settings,
         const Arithmetic &arithmetic);
  CellAnswer run();

private:
  double time_step() const;
  Matrix3 stretch_after(std::size_t steps) const;
  void list_pairs();
  void place_grains();
  void kick();
  void drift(std::size_t step);
  double unbalance(const SweepTotals &totals) const;
  std::vector<double> last_motion() const;

  UnitCell &cell_;
  SweepLayout<T> layout_;
  Matrix3 log_stretch_, first_box_, step_stretch_, step_back_;
  Matrix3 listed_back_; // inverse of the box when the pairs were listed
  AffineMotion affine_;
  std::vector<Vector3> moved_; // since the pairs were listed [m]
  std::vector<double> mass_;
  double step_ = 0, damping_ = 0, mean_radius_;
  std::size_t steps_ = 1;
};

template <class T>
Motion<T>::Motion(UnitCell &cell,
                  const Stretch &stretch,
                  const Dynamics &settings,
                  const Arithmetic &arithmetic)
    : cell_(cell), layout_(cell, arithmetic.instruction_set),
      log_stretch_(logarithm(stretch)),
      first_box_(cell.box.h), affine_{Matrix3::Identity(), Matrix3::Zero()},
      moved_(cell.size(), Vector3::Zero()), mean_radius_(cell.mean_radius())
{
  cell_.velocity.resize(cell_.size(), Vector3::Zero());
  cell_.spin.resize(cell_.size(), Vector3::Zero());
  double total = 0;
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    mass_.push_back(settings.density_scaling * cell_.mass(i));
    total += mass_.back();
  }
  const double rayleigh = rayleigh_time_step(
      cell_.materials[0], cell_.smallest_radius(), settings.density_scaling);
  damping_ =
      2 * settings.global_damping * total / double(cell_.size()) / rayleigh;
  list_pairs();
  step_ = settings.time_step_fraction * std::min(rayleigh, time_step());
  steps_ = std::max<std::size_t>(
      1,
      std::size_t(std::ceil(largest_principal(log_stretch_) /
                                (settings.strain_rate * step_) -
                            1e-9)));
  step_stretch_ = stretch_after(1);
  step_back_ = step_stretch_.inverse();
  affine_.gradient = Matrix3::Identity() - step_back_;
}

template <class T>
Matrix3 Motion<T>::stretch_after(std::size_t steps) const
{
  return exponential(log_stretch_ * (double(steps) / double(steps_)));
}

/// 2 / (largest frequency), from the stiffness around each grain: that of its
/// translation and that of its rotation, of which 5/2 k_t / m is the measure.
template <class T>
double Motion<T>::time_step() const
{
  const auto stiffness = layout_.stiffness();
  double frequency2 = 0;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    frequency2 = std::max({frequency2,
                           2 * stiffness.both[i] / mass_[i],
                           5 * stiffness.tangential[i] / mass_[i]});
  return frequency2 > 0 ? 2 / std::sqrt(frequency2)
                        : std::numeric_limits<double>::infinity();
}

template <class T>
void Motion<T>::list_pairs()
{
  place_grains();
  layout_.list_pairs(cell_, cell_.box, cell_.place);
  listed_back_ = cell_.box.h.inverse();
  affine_.stretch = Matrix3::Identity();
}

/// Places of all grains from what they have moved, which starts anew.
template <class T>
void Motion<T>::place_grains()
{
  const Matrix3 inverse = cell_.box.h.inverse();
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    cell_.place[i] += inverse * moved_[i];
    moved_[i].setZero();
  }
}

/// Half-step velocities from the forces of the whole step, eqs (1) and (2).
template <class T>
void Motion<T>::kick()
{
  const std::span<const GrainRow<T>> rows = layout_.rows();
  double heat = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double r = cell_.radius[i];
    const Vector3 force = head(rows[i].force);
    const Vector3 torque = head(rows[i].force + 4);
    const double a = 0.5 * damping_ * step_ / mass_[i];
    cell_.velocity[i] =
        ((1 - a) * cell_.velocity[i] + step_ / mass_[i] * force) / (1 + a);
    const double inertia = 0.4 * mass_[i] * r * r;
    // Rotation is damped at the same rate as translation for a mean grain.
    const double spin_damping = 0.4 * damping_ * mean_radius_ * mean_radius_;
    const double b = 0.5 * spin_damping * step_ / inertia;
    cell_.spin[i] =
        ((1 - b) * cell_.spin[i] + step_ / inertia * r * torque) / (1 + b);
    heat += damping_ * cell_.velocity[i].squaredNorm() +
            spin_damping * cell_.spin[i].squaredNorm();
  }
  cell_.energy.damping_dissipation += heat * step_;
}

/// Motions after the step; the box moves exactly.
template <class T>
void Motion<T>::drift(std::size_t step)
{
  cell_.box.h = stretch_after(step) * first_box_;
  affine_.stretch = cell_.box.h * listed_back_;
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

/// What each grain did in the last step: displacement, radius x rotation [m].
template <class T>
std::vector<double> Motion<T>::last_motion() const
{
  std::vector<double> motion;
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    const Vector3 moved = step_ * cell_.velocity[i];
    const Vector3 rolled = step_ * cell_.radius[i] * cell_.spin[i];
    motion.insert(motion.end(), moved.begin(), moved.end());
    motion.insert(motion.end(), rolled.begin(), rolled.end());
  }
  return motion;
}

template <class T>
double Motion<T>::unbalance(const SweepTotals &totals) const
{
  double sum = 0;
  for (const GrainRow<T> &row : layout_.rows())
    sum += head(row.force).norm();
  return totals.normal_force > 0
             ? sum / double(cell_.size()) /
                   (totals.normal_force / double(totals.contacts))
             : 0.0;
}

template <class T>
CellAnswer Motion<T>::run()
{
  CellAnswer answer;
  const Matrix3 old_stress = love_weber_stress(cell_);
  const double old_loss = plastic_loss(cell_);
  const double old_volume = cell_.box.volume();
  SweepTotals totals = layout_.sweep(affine_, {Memory::frozen});
  // A pair outside the list approaches by at most two drifts and the stretch of
  // one reach.
  const double reach = 2 * cell_.largest_radius() + layout_.gap();
  const double stretch_rate = largest_principal(log_stretch_) / double(steps_);
  double drifted = 0;
  for (std::size_t step = 1; step <= steps_; ++step) {
    kick();
    drift(step);
    double fastest2 = 0;
    for (const Vector3 &v : cell_.velocity)
      fastest2 = std::max(fastest2, v.squaredNorm());
    drifted += 2 * step_ * std::sqrt(fastest2) + 1.01 * stretch_rate * reach;
    if (drifted > layout_.gap()) {
      layout_.read_memories(cell_);
      list_pairs();
      drifted = 0;
    }
    totals = layout_.sweep(affine_, {Memory::written});
    cell_.energy.friction_dissipation += totals.lost_work;
    if (!std::isfinite(totals.normal_force) || totals.too_deep) {
      answer.outcome = Outcome::diverged;
      return answer;
    }
  }
  layout_.read_memories(cell_);
  place_grains();
  cell_.last = {};
  cell_.energy.plastic_dissipation += plastic_loss(cell_) - old_loss;
  answer.evaluations = steps_;
  answer.stress = love_weber_stress(cell_);
  answer.unbalance = unbalance(totals);
  if (answer.unbalance > largest_unbalance)
    answer.outcome = Outcome::unsettled;
  answer.hill_mandel = hill_mandel_residual(cell_, step_back_, last_motion());
  cell_.energy.work +=
      0.25 * (old_volume + cell_.box.volume()) *
      ((old_stress + answer.stress).array() * log_stretch_.array()).sum();
  return answer;
}
} // namespace

CellAnswer deform_by_dynamics(UnitCell &cell,
                              const Stretch &stretch,
                              const Dynamics &settings,
                              const Arithmetic &arithmetic)
{
  if (arithmetic.precision == Precision::mixed)
    return Motion<float>(cell, stretch, settings, arithmetic).run();
  return Motion<double>(cell, stretch, settings, arithmetic).run();
}

double rayleigh_time_step(const GrainMaterial &material,
                          double smallest_radius,
                          double density_scaling)
{
  const double alpha = 0.1631 * material.poissons_ratio + 0.876605;
  return std::numbers::pi * smallest_radius / alpha *
         std::sqrt(density_scaling * material.density /
                   material.shear_modulus());
}

DynamicMeasures measure_dynamics(const UnitCell &cell,
                                 const Dynamics &settings,
                                 double pressure)
{
  DynamicMeasures result;
  const double density = cell.materials[0].density * settings.density_scaling;
  if (pressure > 0)
    result.inertial_number = settings.strain_rate * 2 * cell.mean_radius() *
                             std::sqrt(density / pressure);
  result.scaling_number =
      settings.strain_rate * cell.smallest_radius() *
      std::sqrt(density / cell.materials[0].limiting_pressure);
  for (std::size_t i = 0; i < cell.velocity.size(); ++i)
    result.kinetic_energy +=
        0.5 * settings.density_scaling * cell.mass(i) *
        (cell.velocity[i].squaredNorm() +
         0.4 * cell.radius[i] * cell.radius[i] * cell.spin[i].squaredNorm());
  return result;
}
} // namespace tamp::dem
