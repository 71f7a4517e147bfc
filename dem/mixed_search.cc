// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/mixed_search.h>
#include <dem/six.h>
#include <dem/stretch.h>
#include <dem/tangent.h>
#include <dem/unit_cell.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tamp::dem
{
namespace
{
// No correction of a strain is larger, or than twice the prescribed strain.
constexpr double largest_correction = 5e-3;
constexpr int most_halvings = 6;

/// The search for the free strains of one increment.
class Search
{
public:
  Search(const UnitCell &committed,
         const MixedControl &control,
         const Driving &driving);
  MixedAnswer run(UnitCell &cell);

private:
  /// A strain, the cell that it makes, and what its stresses miss.
  struct Trial {
    Six strain;
    UnitCell cell;
    CellAnswer answer;
    Eigen::VectorXd miss;
    double size() const { return miss.cwiseAbs().maxCoeff(); }
  };

  Eigen::VectorXd missing(const Matrix3 &stress) const;
  bool is_near(const Trial &trial) const;
  Trial evaluate(const Six &strain);
  Eigen::VectorXd correction(const Eigen::VectorXd &miss) const;
  bool improve(Trial &best);
  void update(const Eigen::VectorXd &step, const Eigen::VectorXd &gain);
  Six moved(Six strain, const Eigen::VectorXd &step) const;

  const UnitCell &committed_;
  const MixedControl &control_;
  const Driving &driving_;
  std::vector<int> free_;
  Six prescribed_ = Six::Zero();
  Eigen::MatrixXd slope_; // d stress / d strain of the free components
  double largest_target_ = 0, most_;
  std::size_t evaluations_ = 0, trials_ = 0;
  WarmGuess guess_;
};

Search::Search(const UnitCell &committed,
               const MixedControl &control,
               const Driving &driving)
    : committed_(committed), control_(control), driving_(driving)
{
  for (int k = 0; k < 6; ++k) {
    const ComponentControl &component = control.components[k];
    if (component.kind == ComponentControl::Kind::strain) {
      prescribed_[k] = component.value;
      continue;
    }
    free_.push_back(k);
    largest_target_ = std::max(largest_target_, std::abs(component.value));
  }
  most_ = std::max(largest_correction, 2 * prescribed_.cwiseAbs().maxCoeff());
}

Eigen::VectorXd Search::missing(const Matrix3 &stress) const
{
  const Six components = to_six(stress);
  Eigen::VectorXd result(free_.size());
  for (std::size_t i = 0; i < free_.size(); ++i)
    result[Eigen::Index(i)] =
        components[free_[i]] - control_.components[free_[i]].value;
  return result;
}

bool Search::is_near(const Trial &trial) const
{
  const double pressure = std::abs(trial.answer.stress.trace()) / 3;
  return trial.size() <=
         control_.accuracy * std::max(largest_target_, pressure);
}

Search::Trial Search::evaluate(const Six &strain)
{
  Trial trial{strain, committed_, {}, {}};
  trial.answer =
      deform(trial.cell, exponential(from_six(strain)), driving_, &guess_);
  evaluations_ += trial.answer.evaluations;
  ++trials_;
  trial.miss = missing(trial.answer.stress);
  return trial;
}

Eigen::VectorXd Search::correction(const Eigen::VectorXd &miss) const
{
  Eigen::VectorXd step = -slope_.fullPivLu().solve(miss);
  if (!step.allFinite() || step.norm() <= 0) // no stiffness: where it is drawn
    step = -miss;
  const double size = step.cwiseAbs().maxCoeff();
  return size > most_ ? Eigen::VectorXd(step * (most_ / size)) : step;
}

Six Search::moved(Six strain, const Eigen::VectorXd &step) const
{
  for (std::size_t i = 0; i < free_.size(); ++i)
    strain[free_[i]] += step[Eigen::Index(i)];
  return strain;
}

void Search::update(const Eigen::VectorXd &step, const Eigen::VectorXd &gain)
{
  const double square = step.squaredNorm();
  if (square > 0)
    slope_ += (gain - slope_ * step) * step.transpose() / square;
}

/// A better trial, by a correction that is halved as long as it makes things
/// worse.
bool Search::improve(Trial &best)
{
  Eigen::VectorXd step = correction(best.miss);
  for (int halving = 0; halving < most_halvings; ++halving, step *= 0.5) {
    Trial next = evaluate(moved(best.strain, step));
    if (next.answer.outcome == Outcome::diverged)
      continue;
    update(step, next.miss - best.miss);
    if (next.size() < 1.5 * best.size()) {
      best = std::move(next);
      return true;
    }
  }
  return false;
}

MixedAnswer Search::run(UnitCell &cell)
{
  // The first guess: what Voigt's stiffness says.
  const auto n = Eigen::Index(free_.size());
  slope_.resize(n, n);
  const Tangent voigt = voigt_tangent(committed_);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      slope_(i, j) = voigt(free_[i], free_[j]);
  const Six expected = voigt * prescribed_;
  Eigen::VectorXd miss = missing(love_weber_stress(committed_));
  for (Eigen::Index i = 0; i < n; ++i)
    miss[i] += expected[free_[i]];
  Six strain = moved(prescribed_, correction(miss));
  Trial best = evaluate(strain);
  for (int halving = 0;
       best.answer.outcome == Outcome::diverged && halving < most_halvings;
       ++halving) {
    strain = prescribed_ + 0.5 * (strain - prescribed_);
    best = evaluate(strain);
  }
  bool near = best.answer.outcome != Outcome::diverged && is_near(best);
  while (best.answer.outcome != Outcome::diverged && !near &&
         trials_ < control_.most_trials && improve(best))
    near = is_near(best);

  MixedAnswer result{from_six(best.strain), {}, best.answer};
  result.stretch = exponential(result.strain);
  result.cell.evaluations = evaluations_;
  if (best.answer.outcome == Outcome::diverged)
    return result;
  if (!near)
    result.cell.outcome = Outcome::unsettled;
  cell = std::move(best.cell);
  return result;
}
} // namespace

MixedAnswer search_mixed(UnitCell &cell,
                         const MixedControl &control,
                         const Driving &driving)
{
  const UnitCell committed = cell;
  return Search(committed, control, driving).run(cell);
}
} // namespace tamp::dem
