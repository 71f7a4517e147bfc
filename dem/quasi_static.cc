// SPDX-License-Identifier: BSD-3-Clause
#include <dem/fire.h>
#include <dem/hill_mandel.h>
#include <dem/measures.h>
#include <dem/quasi_static.h>
#include <dem/stretch.h>
#include <dem/sweep_layout.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
namespace
{
/// One increment of the map from a cell to its new state, with sweeps in the
/// precision of T.
template <class T>
class Increment
{
public:
  Increment(UnitCell &cell,
            const Stretch &stretch,
            const QuasiStatic &settings,
            const Arithmetic &arithmetic)
      : cell_(cell), settings_(settings),
        log_stretch_(logarithm(stretch)), box_{stretch * cell.box.h},
        inverse_box_(box_.h.inverse()),
        back_(stretch.inverse()), affine_{Matrix3::Identity(),
                                          Matrix3::Identity() - back_},
        layout_(cell, arithmetic.instruction_set),
        motion_(6 * cell.size(), 0.0), force_(6 * cell.size(), 0.0),
        place_(cell.place)
  {
  }

  /// How much of the last increment's motion to start from: its share in the
  /// direction of the last stretch, nothing if the direction turned.
  double predictor_scale() const
  {
    const Matrix3 &last = cell_.last.log_stretch;
    const double length2 = last.squaredNorm();
    if (cell_.last.motion.empty() || length2 == 0)
      return 0;
    const double along = (log_stretch_.array() * last.array()).sum();
    if (along < 0.5 * std::sqrt(length2) * log_stretch_.norm())
      return 0;
    return std::min(along / length2, 1.5);
  }

  void start_from_predictor(double scale)
  {
    if (scale > 0)
      for (std::size_t k = 0; k < motion_.size(); ++k)
        motion_[k] = scale * cell_.last.motion[k];
  }
  void start_from(const std::vector<double> &motion) { motion_ = motion; }

  /// Relaxes to equilibrium. The cell is as before until adopt().
  CellAnswer relax();

  /// Writes the state into the cell.
  void adopt(CellAnswer &answer);

  const std::vector<double> &motion() const { return motion_; }

private:
  void move_rows();
  void list_pairs();
  bool pairs_hold() const;
  Fire make_fire() const;
  double sweep(CellAnswer &answer);

  UnitCell &cell_;
  const QuasiStatic &settings_;
  Matrix3 log_stretch_;
  PeriodicBox box_;
  Matrix3 inverse_box_, back_;
  AffineMotion affine_;
  SweepLayout<T> layout_;
  std::vector<double> motion_, force_; // displacement, radius x rotation
  std::vector<double> listed_motion_;  // when the pairs were listed
  std::vector<Vector3> place_;
};

template <class T>
void Increment<T>::move_rows()
{
  const std::span<GrainRow<T>> rows = layout_.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector3 moved(&motion_[6 * i]);
    const Vector3 relative = back_ * moved;
    for (int k = 0; k < 3; ++k) {
      rows[i].moved[k] = T(moved[k] - listed_motion_[6 * i + k]);
      rows[i].motion[k] = T(relative[k]);
      const double rolled = motion_[6 * i + 3 + k];
      rows[i].rotation[k] = T(rolled / cell_.radius[i]);
      rows[i].motion[4 + k] = T(rolled);
    }
  }
}

template <class T>
void Increment<T>::list_pairs()
{
  for (std::size_t i = 0; i < place_.size(); ++i)
    place_[i] = cell_.place[i] + inverse_box_ * Vector3(&motion_[6 * i]);
  layout_.list_pairs(cell_, box_, place_);
  listed_motion_ = motion_;
  move_rows();
}

template <class T>
bool Increment<T>::pairs_hold() const
{
  double drift2 = 0;
  for (const GrainRow<T> &row : layout_.rows())
    drift2 = std::max(drift2,
                      double(row.moved[0] * row.moved[0] +
                             row.moved[1] * row.moved[1] +
                             row.moved[2] * row.moved[2]));
  return 4 * drift2 < layout_.gap() * layout_.gap();
}

template <class T>
Fire Increment<T>::make_fire() const
{
  // A time step of 1 suits a mass of 0.6 times the stiffness around a grain,
  // and of 1.2 times the tangential one for radius x rotation. The floor keeps
  // grains with few contacts from flying.
  const auto stiffness = layout_.stiffness();
  double floor = 0.6 * stiffness.largest;
  if (floor <= 0) // no contact yet: that of a small overlap
    floor = cell_.materials[0].youngs_modulus * 0.01 * cell_.mean_radius();
  std::vector<double> mass(motion_.size());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    std::fill_n(&mass[6 * i], 3, std::max(floor, 0.6 * stiffness.both[i]));
    std::fill_n(
        &mass[6 * i + 3], 3, std::max(floor, 1.2 * stiffness.tangential[i]));
  }
  return Fire(std::move(mass));
}

template <class T>
double Increment<T>::sweep(CellAnswer &answer)
{
  const SweepTotals totals = layout_.sweep(affine_, {Memory::frozen});
  ++answer.evaluations;
  double force = 0, torque = 0;
  const std::span<const GrainRow<T>> rows = layout_.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const T *f = rows[i].force;
    std::copy_n(f, 3, &force_[6 * i]);
    std::copy_n(f + 4, 3, &force_[6 * i + 3]);
    force += std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    torque += std::sqrt(f[4] * f[4] + f[5] * f[5] + f[6] * f[6]);
  }
  const double n = double(rows.size());
  const double contact = std::max(
      totals.contacts > 0 ? totals.normal_force / double(totals.contacts) : 0.0,
      settings_.force_floor);
  answer.unbalance = contact > 0 ? std::max(force, torque) / n / contact : 0.0;
  if (!std::isfinite(answer.unbalance) || totals.too_deep)
    answer.outcome = Outcome::diverged;
  return answer.unbalance;
}

template <class T>
CellAnswer Increment<T>::relax()
{
  CellAnswer answer;
  list_pairs();
  Fire fire = make_fire();
  while (true) {
    const double unbalance = sweep(answer);
    if (answer.outcome == Outcome::diverged ||
        unbalance <= settings_.unbalance_tolerance)
      break;
    if (answer.evaluations >= settings_.maximum_evaluations) {
      answer.outcome = Outcome::unsettled;
      break;
    }
    fire.move(motion_, force_);
    move_rows();
    if (!pairs_hold())
      list_pairs();
  }
  return answer;
}

template <class T>
void Increment<T>::adopt(CellAnswer &answer)
{
  const Matrix3 old_stress = love_weber_stress(cell_);
  const double old_loss = plastic_loss(cell_);
  const double old_volume = cell_.box.volume();
  const SweepTotals totals = layout_.sweep(affine_, {Memory::written});
  cell_.box = box_;
  for (std::size_t i = 0; i < place_.size(); ++i)
    cell_.place[i] += inverse_box_ * Vector3(&motion_[6 * i]);
  layout_.read_memories(cell_);
  cell_.last = {log_stretch_, motion_};
  answer.stress = love_weber_stress(cell_);
  answer.hill_mandel = hill_mandel_residual(cell_, back_, motion_);
  cell_.energy.work +=
      0.25 * (old_volume + cell_.box.volume()) *
      ((old_stress + answer.stress).array() * log_stretch_.array()).sum();
  cell_.energy.friction_dissipation += totals.lost_work;
  cell_.energy.plastic_dissipation += plastic_loss(cell_) - old_loss;
}

/// One increment with or without a guess.
template <class T>
CellAnswer step_in(UnitCell &cell,
                   const Stretch &stretch,
                   const QuasiStatic &settings,
                   const Arithmetic &arithmetic,
                   WarmGuess *guess)
{
  Increment<T> increment(cell, stretch, settings, arithmetic);
  if (guess && guess->predictor_scale < 0)
    guess->predictor_scale = increment.predictor_scale();
  if (guess && !guess->empty())
    increment.start_from(guess->motion);
  else
    increment.start_from_predictor(guess ? guess->predictor_scale
                                         : increment.predictor_scale());
  CellAnswer answer = increment.relax();
  if (guess) {
    if (answer.outcome == Outcome::settled)
      guess->motion = increment.motion();
    else
      guess->motion.clear();
  }
  if (answer.outcome != Outcome::diverged)
    increment.adopt(answer);
  return answer;
}

CellAnswer step(UnitCell &cell,
                const Stretch &stretch,
                const QuasiStatic &settings,
                const Arithmetic &arithmetic,
                WarmGuess *guess)
{
  return arithmetic.precision == Precision::mixed
             ? step_in<float>(cell, stretch, settings, arithmetic, guess)
             : step_in<double>(cell, stretch, settings, arithmetic, guess);
}
} // namespace

CellAnswer deform_quasi_static(UnitCell &cell,
                               const Stretch &stretch,
                               const QuasiStatic &settings,
                               const Arithmetic &arithmetic,
                               WarmGuess *guess)
{
  const Matrix3 log_stretch = logarithm(stretch);
  const double size = largest_principal(log_stretch);
  const auto parts =
      std::max(1.0, std::ceil(size / settings.maximum_strain_increment - 1e-9));
  if (parts == 1)
    return step(cell, stretch, settings, arithmetic, guess);

  const Matrix3 h = stretch * cell.box.h;
  const Stretch part = exponential(log_stretch / parts);
  CellAnswer answer;
  std::size_t evaluations = 0;
  bool settled = true;
  for (int k = 0; k < int(parts); ++k) {
    answer = step(cell, part, settings, arithmetic, nullptr);
    evaluations += answer.evaluations;
    settled = settled && answer.outcome == Outcome::settled;
    if (answer.outcome == Outcome::diverged)
      break;
  }
  cell.box.h = h; // the product of the parts, without their round-off
  answer.evaluations = evaluations;
  if (!settled && answer.outcome == Outcome::settled)
    answer.outcome = Outcome::unsettled;
  return answer;
}
} // namespace tamp::dem
