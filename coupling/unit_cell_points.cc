// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/polar.h>
#include <coupling/unit_cell_points.h>
#include <coupling/work_sharing.h>
#include <dem/measures.h>
#include <dem/stretch.h>
#include <dem/tangent.h>
#include <dem/unit_cell_bytes.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tamp::coupling
{
namespace
{
// A secant outside these bounds is noise. Measured: steps then converge in the
// fewest updates.
constexpr double smallest_secant = 0.2, largest_secant = 1.2;
} // namespace

/// One material point: the committed state, then the trial's.
struct UnitCellPoints::Point {
  dem::UnitCell committed;
  dem::Matrix3 rotation = dem::Matrix3::Identity(); ///< cell to die
  dem::Matrix3 stress = dem::Matrix3::Zero();       ///< in the die's frame [Pa]
  double secant = 1; ///< of the last committed step, over Voigt [-]
  dem::WarmGuess guess;
  double cost = 0; ///< of the last evaluation

  dem::UnitCell trial;
  dem::Matrix3 trial_rotation = dem::Matrix3::Identity();
  dem::Matrix3 trial_stress = dem::Matrix3::Zero();
  dem::Matrix3 carried_stress =
      dem::Matrix3::Zero(); ///< committed stress, turned by R [Pa]
  dem::Matrix3 log_stretch =
      dem::Matrix3::Zero(); ///< of the trial, in the die's frame [-]
  Tangent4 voigt;           ///< of the last trial that was asked for it
  bool has_voigt = false, has_trial = false;
  dem::CellAnswer answer;
  double asymmetry = 0;
  std::string problem; ///< why the last trial failed; empty: it did not

  void adopt();
};

void UnitCellPoints::Point::adopt()
{
  if (has_voigt) {
    const dealii::SymmetricTensor<2, 3> strain = to_tensor(log_stretch),
                                        gain = to_tensor(trial_stress -
                                                         carried_stress);
    const double stiff = strain * (voigt * strain);
    if (stiff > 0)
      secant =
          std::clamp(gain * strain / stiff, smallest_secant, largest_secant);
  }
  std::swap(committed, trial);
  rotation = trial_rotation;
  stress = trial_stress;
  guess.clear();
  has_voigt = has_trial = false;
}

UnitCellPoints::UnitCellPoints(std::vector<dem::UnitCell> cells,
                               const CellPointsOptions &options)
    : options_(options)
{
  options_.driving.check();
  points_.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    points_[i].committed = std::move(cells[i]);
    points_[i].stress = dem::measure(points_[i].committed).stress;
  }
}

UnitCellPoints::~UnitCellPoints() = default;

std::size_t UnitCellPoints::size() const
{
  return points_.size();
}

void UnitCellPoints::begin_attempt()
{
  for (Point &point : points_)
    point.guess.clear();
  // What was evaluated before the first attempt is no part of the step.
  if (!attempted_)
    step_begins_ = true;
  attempted_ = true;
}

void UnitCellPoints::evaluate(std::span<const fem::Deformation> deformations,
                              fem::Want want,
                              std::span<fem::Response> responses)
{
  if (deformations.size() != size() || responses.size() != size())
    throw std::invalid_argument("one deformation and one response per point");
  std::vector<std::size_t> order(size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return points_[a].cost > points_[b].cost;
  });
  share_work(order, options_.threads, [&](std::size_t i) {
    Point &point = points_[i];
    point.problem.clear();
    point.answer = {};
    point.asymmetry = 0;
    try {
      evaluate_point(point, deformations[i], want, responses[i]);
    } catch (const std::exception &error) { // no such state of the cell
      point.problem = error.what();
      point.guess.clear();
      point.has_trial = false;
      responses[i].status = fem::Status::failed;
    }
  });
  summarise(responses);
}

void UnitCellPoints::evaluate_point(Point &point,
                                    const fem::Deformation &deformation,
                                    fem::Want want,
                                    fem::Response &response) const
{
  const PolarSplit split = polar_split(to_matrix(deformation.relative_F));
  const dem::Matrix3 &Q = point.rotation;
  dem::Stretch stretch = Q.transpose() * split.stretch * Q;
  stretch = (0.5 * (stretch + stretch.transpose())).eval();

  point.trial = point.committed;
  point.answer = dem::deform(point.trial,
                             stretch,
                             options_.driving,
                             options_.warm ? &point.guess : nullptr);
  point.cost = static_cast<double>(point.answer.evaluations) *
               static_cast<double>(point.trial.radius.size());
  point.has_trial = true;
  point.trial_rotation = split.rotation * Q;
  const dem::Matrix3 &turn = point.trial_rotation;
  const dem::Matrix3 &raw = point.answer.stress;
  const dem::Matrix3 symmetric = 0.5 * (raw + raw.transpose());
  point.asymmetry =
      raw.norm() > 0 ? (raw - symmetric).norm() / raw.norm() : 0.0;
  point.trial_stress = turn * symmetric * turn.transpose();
  point.carried_stress =
      split.rotation * point.stress * split.rotation.transpose();
  point.log_stretch = split.rotation * dem::logarithm(split.stretch) *
                      split.rotation.transpose();

  response.stress = to_tensor(point.trial_stress);
  response.relative_density = point.trial.relative_density();
  response.status =
      point.answer.outcome == dem::Outcome::settled     ? fem::Status::converged
      : point.answer.outcome == dem::Outcome::unsettled ? fem::Status::doubtful
                                                        : fem::Status::failed;
  if (point.answer.outcome == dem::Outcome::diverged)
    point.problem = "the grains of the cell flew apart or were crushed";
  if (want == fem::Want::stress_and_tangent &&
      point.answer.outcome != dem::Outcome::diverged) {
    point.voigt = turned(to_tangent(dem::voigt_tangent(point.trial)), turn);
    point.has_voigt = true;
    response.tangent = point.secant * point.voigt;
  }
}

void UnitCellPoints::summarise(std::span<fem::Response> responses)
{
  const std::uint64_t so_far = step_begins_ ? 0 : report_.evaluations;
  report_ = {};
  report_.evaluations = so_far;
  report_.cells = size();
  step_begins_ = false;
  for (std::size_t i = 0; i < size(); ++i) {
    const Point &point = points_[i];
    const std::size_t number = options_.first_point + i;
    report_.evaluations += point.answer.evaluations;
    if (point.answer.unbalance > report_.worst_unbalance) {
      report_.worst_unbalance = point.answer.unbalance;
      report_.worst_unbalance_point = number;
    }
    report_.worst_hill_mandel =
        std::max(report_.worst_hill_mandel, point.answer.hill_mandel);
    report_.worst_asymmetry =
        std::max(report_.worst_asymmetry, point.asymmetry);
    if (report_.problem.empty() && !point.problem.empty())
      report_.problem =
          "material point " + std::to_string(number) + ": " + point.problem;
    report_.unsettled += responses[i].status == fem::Status::doubtful;
  }
}

void UnitCellPoints::commit()
{
  for (Point &point : points_)
    if (point.has_trial)
      point.adopt();
  step_begins_ = true;
  attempted_ = false;
}

void UnitCellPoints::turn()
{
  for (Point &point : points_) {
    point.guess.clear();
    point.secant = 1;
    point.committed.last = {};
  }
}

void UnitCellPoints::set_force_floor(double force)
{
  options_.driving.quasi_static.force_floor = force;
}

void UnitCellPoints::pack(std::size_t i, std::vector<char> &bytes) const
{
  const Point &point = points_.at(i);
  const auto append = [&bytes](const auto &value) {
    const char *begin = reinterpret_cast<const char *>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof(value));
  };
  append(point.rotation);
  append(point.stress);
  append(point.secant);
  dem::to_bytes(point.committed, bytes);
}

void UnitCellPoints::unpack(std::size_t i, std::span<const char> bytes)
{
  Point fresh;
  const auto take = [&bytes](auto &value) {
    if (bytes.size() < sizeof(value))
      throw std::runtime_error("material point: bytes are cut off");
    std::memcpy(static_cast<void *>(&value), bytes.data(), sizeof(value));
    bytes = bytes.subspan(sizeof(value));
  };
  take(fresh.rotation);
  take(fresh.stress);
  take(fresh.secant);
  fresh.committed = dem::from_bytes(bytes);
  points_.at(i) = std::move(fresh);
}

double UnitCellPoints::cost(std::size_t i) const
{
  return points_.at(i).cost;
}

std::vector<fem::Variable> UnitCellPoints::variables() const
{
  return {{"coordination_number", "-", "contacts per grain"},
          {"mechanical_coordination_number",
           "-",
           "contacts per grain that carries load"},
          {"plastic_contact_share", "-", "of all contacts"},
          {"sliding_contact_share", "-", "of all contacts"}};
}

void UnitCellPoints::variables_of(std::size_t point,
                                  std::span<double> values) const
{
  const dem::CellMeasures measures = dem::measure(cell(point));
  const auto contacts =
      static_cast<double>(std::max<std::size_t>(1, measures.contacts));
  const std::array<double, 4> now{
      measures.coordination_number,
      measures.mechanical_coordination_number,
      static_cast<double>(measures.plastic_contacts) / contacts,
      static_cast<double>(measures.sliding_contacts) / contacts};
  std::ranges::copy(now, values.begin());
}

fem::Share UnitCellPoints::share() const
{
  return {options_.first_point, options_.first_point + size()};
}

void UnitCellPoints::hold(const fem::Share &share)
{
  const fem::Share old = this->share();
  std::vector<Point> points(share.size());
  for (std::size_t i = share.begin; i < share.end; ++i)
    if (old.holds(i))
      points[i - share.begin] = std::move(points_[i - old.begin]);
  points_ = std::move(points);
  options_.first_point = share.begin;
}

const CellReport &UnitCellPoints::report() const
{
  return report_;
}

const dem::UnitCell &UnitCellPoints::cell(std::size_t i) const
{
  return points_.at(i).committed;
}

dem::Matrix3 UnitCellPoints::rotation(std::size_t i) const
{
  return points_.at(i).rotation;
}
} // namespace tamp::coupling
