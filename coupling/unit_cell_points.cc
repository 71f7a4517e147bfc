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
#include <limits>
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

std::vector<std::size_t> numbers(std::size_t count)
{
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}
} // namespace

/// What is a material point's own besides its cell: committed, then the
/// trial's.
struct UnitCellPoints::Point {
  dem::Matrix3 rotation = dem::Matrix3::Identity(); ///< cell to die
  dem::Matrix3 stress = dem::Matrix3::Zero();       ///< in the die's frame [Pa]
  double secant = 1; ///< of the last committed step, over Voigt [-]

  dem::Matrix3 trial_rotation = dem::Matrix3::Identity();
  dem::Matrix3 trial_stress = dem::Matrix3::Zero();
  dem::Matrix3 carried_stress =
      dem::Matrix3::Zero(); ///< committed stress, turned by R [Pa]
  dem::Matrix3 log_stretch =
      dem::Matrix3::Zero(); ///< of the trial, in the die's frame [-]
  Tangent4 voigt;           ///< of the last trial that was asked for it
  bool has_voigt = false;
  double asymmetry = 0;

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
  rotation = trial_rotation;
  stress = trial_stress;
  has_voigt = false;
}
UnitCellPoints::UnitCellPoints(std::vector<dem::UnitCell> cells,
                               std::vector<std::size_t> cell_of,
                               const CellPointsOptions &options)
    : options_(options), cells_(std::move(cells), std::move(cell_of))
{
  options_.driving.check();
  points_.resize(cells_.points());
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t first = cells_.of(i).first_point;
    points_[i].stress =
        first == i ? dem::measure(cell(i)).stress : points_[first].stress;
  }
}

UnitCellPoints::UnitCellPoints(std::vector<dem::UnitCell> cells,
                               const CellPointsOptions &options)
    : UnitCellPoints(std::move(cells), numbers(cells.size()), options)
{
}

UnitCellPoints::~UnitCellPoints() = default;

std::size_t UnitCellPoints::size() const
{
  return points_.size();
}

void UnitCellPoints::begin_attempt()
{
  cells_.rejoin();
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
  if (unpacked_)
    cells_.join_equal();
  unpacked_ = false;
  std::vector<std::size_t> all = numbers(size());
  std::vector<dem::Stretch> stretches(size());
  share_work(all, options_.threads, [&](std::size_t i) {
    stretches[i] = split(points_[i], deformations[i]);
  });
  cells_.part(stretches);
  press(stretches, want);
  share_work(all, options_.threads, [&](std::size_t i) {
    respond(points_[i], cells_.of(i), responses[i]);
  });
  summarise(responses);
}

dem::Stretch UnitCellPoints::split(Point &point,
                                   const fem::Deformation &deformation) const
{
  try {
    const PolarSplit split = polar_split(to_matrix(deformation.relative_F));
    const dem::Matrix3 &Q = point.rotation;
    const dem::Stretch stretch = Q.transpose() * split.stretch * Q;
    point.trial_rotation = split.rotation * Q;
    point.carried_stress =
        split.rotation * point.stress * split.rotation.transpose();
    point.log_stretch = split.rotation * dem::logarithm(split.stretch) *
                        split.rotation.transpose();
    return 0.5 * (stretch + stretch.transpose());
  } catch (const std::domain_error &) {
    return dem::Stretch::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

void UnitCellPoints::press(std::span<const dem::Stretch> stretches,
                           fem::Want want)
{
  const std::span<CommonCell> cells = cells_.cells();
  std::vector<std::size_t> order = numbers(cells.size());
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return cells[a].cost > cells[b].cost;
  });
  share_work(order, options_.threads, [&](std::size_t k) {
    cells[k].press(stretches[cells[k].first_point],
                   options_.driving,
                   options_.warm,
                   want == fem::Want::stress_and_tangent);
  });
}

void UnitCellPoints::respond(Point &point,
                             const CommonCell &cell,
                             fem::Response &response) const
{
  if (!cell.has_trial) {
    point.asymmetry = 0;
    response.status = fem::Status::failed;
    return;
  }
  const dem::Matrix3 &turn = point.trial_rotation, &raw = cell.answer.stress;
  const dem::Matrix3 symmetric = 0.5 * (raw + raw.transpose());
  point.asymmetry =
      raw.norm() > 0 ? (raw - symmetric).norm() / raw.norm() : 0.0;
  point.trial_stress = turn * symmetric * turn.transpose();
  response.stress = to_tensor(point.trial_stress);
  response.relative_density = cell.trial.relative_density();
  response.status =
      cell.answer.outcome == dem::Outcome::settled     ? fem::Status::converged
      : cell.answer.outcome == dem::Outcome::unsettled ? fem::Status::doubtful
                                                       : fem::Status::failed;
  if (cell.voigt) {
    point.voigt = turned(to_tangent(*cell.voigt), turn);
    point.has_voigt = true;
    response.tangent = point.secant * point.voigt;
  }
}

void UnitCellPoints::summarise(std::span<const fem::Response> responses)
{
  const CellReport before = step_begins_ ? CellReport() : report_;
  report_ = {};
  report_.evaluations = before.evaluations;
  report_.done_evaluations = before.done_evaluations;
  report_.points = size();
  report_.cells = cells_.cells().size();
  step_begins_ = false;
  for (const CommonCell &cell : cells_.cells())
    report_.done_evaluations += cell.answer.evaluations;
  for (std::size_t i = 0; i < size(); ++i) {
    const CommonCell &cell = cells_.of(i);
    const std::size_t number = options_.first_point + i;
    report_.evaluations += cell.answer.evaluations;
    if (cell.answer.unbalance > report_.worst_unbalance) {
      report_.worst_unbalance = cell.answer.unbalance;
      report_.worst_unbalance_point = number;
    }
    report_.worst_hill_mandel =
        std::max(report_.worst_hill_mandel, cell.answer.hill_mandel);
    report_.worst_asymmetry =
        std::max(report_.worst_asymmetry, points_[i].asymmetry);
    if (report_.problem.empty() && !cell.problem.empty())
      report_.problem =
          "material point " + std::to_string(number) + ": " + cell.problem;
    report_.unsettled += responses[i].status == fem::Status::doubtful;
  }
}

void UnitCellPoints::commit()
{
  for (std::size_t i = 0; i < size(); ++i)
    if (cells_.of(i).has_trial)
      points_[i].adopt();
  cells_.commit();
  step_begins_ = true;
  attempted_ = false;
}

void UnitCellPoints::turn()
{
  for (Point &point : points_)
    point.secant = 1;
  for (CommonCell &cell : cells_.cells()) {
    cell.guess.clear();
    cell.committed.last = {};
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
  dem::to_bytes(cell(i), bytes);
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
  dem::UnitCell cell = dem::from_bytes(bytes);
  points_.at(i) = fresh;
  cells_.put(i, std::move(cell));
  unpacked_ = true;
}

double UnitCellPoints::cost(std::size_t i) const
{
  const CommonCell &cell = cells_.of(i);
  return cell.first_point == i ? cell.cost : 0;
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
      points[i - share.begin] = points_[i - old.begin];
  points_ = std::move(points);
  cells_.hold(static_cast<std::ptrdiff_t>(share.begin) -
                  static_cast<std::ptrdiff_t>(old.begin),
              share.size());
  options_.first_point = share.begin;
}

const CellReport &UnitCellPoints::report() const
{
  return report_;
}

const dem::UnitCell &UnitCellPoints::cell(std::size_t i) const
{
  return cells_.of(i).committed;
}

dem::Matrix3 UnitCellPoints::rotation(std::size_t i) const
{
  return points_.at(i).rotation;
}
} // namespace tamp::coupling
