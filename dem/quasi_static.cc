// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_growth.h>
#include <dem/fire.h>
#include <dem/hill_mandel.h>
#include <dem/kernel/kernel.h>
#include <dem/measures.h>
#include <dem/quasi_static.h>
#include <dem/stretch.h>
#include <dem/sweep_layout.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <span>

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
        back_(stretch.inverse()), affine_{stretch},
        loops_(kernel_of(arithmetic.instruction_set).loops<T>().grains),
        layout_(cell, arithmetic.instruction_set), grains_(cell.size()),
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

  /// Starts from a motion of six numbers a grain, scaled; from none if it is
  /// empty.
  void start_from(std::span<const double> motion, double scale);

  /// Relaxes to equilibrium. The cell is as before until adopt().
  CellAnswer relax();

  /// Writes the state into the cell.
  void adopt(CellAnswer &answer, const StepStart &start);

  /// Displacement and radius x rotation of every grain [m].
  std::vector<double> motion() const;

private:
  void list_pairs();
  void choose_masses();
  RelaxationSums sweep(CellAnswer &answer);
  bool move(const RelaxationMove &move);

  UnitCell &cell_;
  const QuasiStatic &settings_;
  Matrix3 log_stretch_;
  PeriodicBox box_;
  Matrix3 inverse_box_, back_;
  AffineMotion affine_;
  const GrainLoops<T> &loops_;
  SweepLayout<T> layout_;
  std::vector<RelaxingGrain> grains_;
  std::vector<Vector3> place_;
};

template <class T>
void Increment<T>::start_from(std::span<const double> motion, double scale)
{
  if (motion.empty())
    return;
  for (std::size_t i = 0; i < grains_.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      grains_[i].position[k] = scale * motion[6 * i + k];
      grains_[i].position[4 + k] = scale * motion[6 * i + 3 + k];
    }
}

template <class T>
std::vector<double> Increment<T>::motion() const
{
  std::vector<double> result;
  result.reserve(6 * grains_.size());
  for (const RelaxingGrain &grain : grains_)
    for (int k : {0, 1, 2, 4, 5, 6})
      result.push_back(grain.position[k]);
  return result;
}

template <class T>
void Increment<T>::list_pairs()
{
  for (std::size_t i = 0; i < place_.size(); ++i) {
    place_[i] = cell_.place[i] + inverse_box_ * Vector3(grains_[i].position);
    std::copy_n(grains_[i].position, 3, grains_[i].listed);
  }
  layout_.list_pairs(cell_, box_, place_, affine_.stretch);
}

template <class T>
void Increment<T>::choose_masses()
{
  // A time step of 1 suits a mass of 0.6 times the stiffness around a grain,
  // and of 1.2 times the tangential one for radius x rotation. The floor keeps
  // grains with few contacts from flying.
  const auto stiffness = layout_.stiffness();
  double floor = 0.6 * stiffness.largest;
  if (floor <= 0) // no contact yet: that of a small overlap, of the stiffest
    floor =
        0.005 * cell_.mean_radius() *
        std::ranges::max(cell_.materials, {}, &GrainMaterial::youngs_modulus)
            .youngs_modulus;
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    double *mobility = grains_[i].mobility;
    std::fill_n(mobility, 3, 1 / std::max(floor, 0.6 * stiffness.both[i]));
    std::fill_n(
        mobility + 4, 3, 1 / std::max(floor, 1.2 * stiffness.tangential[i]));
  }
}

template <class T>
RelaxationSums Increment<T>::sweep(CellAnswer &answer)
{
  const SweepTotals totals =
      layout_.sweep(affine_, {Memory::frozen, false, true});
  ++answer.evaluations;
  const RelaxationSums sums =
      loops_.survey(layout_.rows().data(), grains_.data(), grains_.size());
  const double contact = std::max(
      totals.contacts > 0 ? totals.normal_force / double(totals.contacts) : 0.0,
      settings_.force_floor);
  answer.unbalance = contact > 0 ? std::max(sums.force, sums.torque) /
                                       double(grains_.size()) / contact
                                 : 0.0;
  if (!std::isfinite(answer.unbalance) || totals.too_deep)
    answer.outcome = Outcome::diverged;
  return sums;
}

/// Moves all grains; whether the list of pairs still holds then.
template <class T>
bool Increment<T>::move(const RelaxationMove &move)
{
  const double farthest2 =
      loops_.relax(move, layout_.rows().data(), grains_.data(), grains_.size());
  return 4 * farthest2 < layout_.gap() * layout_.gap();
}

template <class T>
CellAnswer Increment<T>::relax()
{
  constexpr RelaxationMove stay{};
  CellAnswer answer;
  move(stay); // writes the guess into the rows
  list_pairs();
  choose_masses();
  Fire fire;
  while (true) {
    const RelaxationSums sums = sweep(answer);
    if (answer.outcome == Outcome::diverged ||
        answer.unbalance <= settings_.unbalance_tolerance)
      break;
    if (answer.evaluations >= settings_.maximum_evaluations) {
      answer.outcome = Outcome::unsettled;
      break;
    }
    if (!move(fire.next(sums)))
      list_pairs();
  }
  return answer;
}

template <class T>
void Increment<T>::adopt(CellAnswer &answer, const StepStart &start)
{
  const double old_volume = cell_.box.volume();
  const std::size_t old_contacts = cell_.contacts.size();
  layout_.read_memories(cell_); // without pairs that have parted for good
  const double old_loss = cell_.contacts.size() == old_contacts
                              ? start.plastic_loss
                              : survey_contacts(cell_).plastic_loss;
  const SweepTotals totals = layout_.sweep(affine_, {Memory::written});
  cell_.box = box_;
  for (std::size_t i = 0; i < place_.size(); ++i)
    cell_.place[i] += inverse_box_ * Vector3(grains_[i].position);
  layout_.read_memories(cell_);
  cell_.last = {log_stretch_, motion()};
  const ContactSurvey after = survey_contacts(cell_);
  answer.stress = love_weber_stress(after.forces, cell_.box.volume());
  answer.hill_mandel = hill_mandel_residual(
      cell_, after.forces, back_, cell_.last.motion, after.elastic_energy);
  cell_.energy.work +=
      0.25 * (old_volume + cell_.box.volume()) *
      ((start.stress + answer.stress).array() * log_stretch_.array()).sum();
  cell_.energy.friction_dissipation += totals.lost_work;
  cell_.energy.adhesion_dissipation += totals.adhesion_loss;
  // Where grains grow the loss is what the work leaves, see step().
  if (!grains_grow(cell_))
    cell_.energy.plastic_dissipation +=
        after.plastic_loss - old_loss + totals.forgotten_loss;
}

StepStart start_of(const UnitCell &cell)
{
  const ContactSurvey survey = survey_contacts(cell);
  return {love_weber_stress(survey.forces, cell.box.volume()),
          survey.plastic_loss};
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
  bool guessed = false;
  if (guess && guess->predictor_scale < 0)
    guess->predictor_scale = increment.predictor_scale();
  if (guess && !guess->empty()) {
    increment.start_from(guess->motion, 1);
    guessed = true;
  } else if (const double scale =
                 guess ? guess->predictor_scale : increment.predictor_scale();
             scale > 0) {
    increment.start_from(cell.last.motion, scale);
    guessed = true;
  }
  CellAnswer answer = increment.relax();
  if (answer.outcome == Outcome::diverged && guessed) {
    // After an avalanche a guess throws grains into each other: do without.
    cell.last = {};
    if (guess) {
      guess->motion.clear();
      guess->predictor_scale = 0;
    }
    CellAnswer again = step_in<T>(cell, stretch, settings, arithmetic, guess);
    again.evaluations += answer.evaluations;
    return again;
  }
  if (guess) {
    if (answer.outcome == Outcome::settled)
      guess->motion = increment.motion();
    else
      guess->motion.clear();
  }
  if (answer.outcome != Outcome::diverged) {
    const StepStart start =
        guess && guess->start ? *guess->start : start_of(cell);
    if (guess)
      guess->start = start;
    increment.adopt(answer, start);
  }
  return answer;
}

CellAnswer step_of_lasting_sizes(UnitCell &cell,
                                 const Stretch &stretch,
                                 const QuasiStatic &settings,
                                 const Arithmetic &arithmetic,
                                 WarmGuess *guess)
{
  return arithmetic.precision == Precision::mixed
             ? step_in<float>(cell, stretch, settings, arithmetic, guess)
             : step_in<double>(cell, stretch, settings, arithmetic, guess);
}

/// One increment. Grains that grow do so first.
CellAnswer step(UnitCell &cell,
                const Stretch &stretch,
                const QuasiStatic &settings,
                const Arithmetic &arithmetic,
                WarmGuess *guess)
{
  if (!grains_grow(cell))
    return step_of_lasting_sizes(cell, stretch, settings, arithmetic, guess);
  const double loss = cell.energy.plastic_dissipation - unstored_work(cell);
  grow(cell);
  const CellAnswer answer =
      step_of_lasting_sizes(cell, stretch, settings, arithmetic, guess);
  if (answer.outcome != Outcome::diverged)
    cell.energy.plastic_dissipation = loss + unstored_work(cell);
  return answer;
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
