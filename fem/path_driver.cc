// SPDX-License-Identifier: BSD-3-Clause
#include <fem/path_driver.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tamp::fem
{
namespace
{
using dealii::SymmetricTensor;
using dealii::Tensor;

using Six = std::array<double, 6>; ///< xx, yy, zz, yz, xz, xy
using Matrix6 = std::array<Six, 6>;

constexpr std::array<std::array<unsigned, 2>, 6> entry{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

Six components(const SymmetricTensor<2, 3> &tensor)
{
  Six result;
  for (unsigned i = 0; i < 6; ++i)
    result[i] = tensor[entry[i][0]][entry[i][1]];
  return result;
}

double largest(const Six &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

Six difference(const Six &a, const Six &b)
{
  Six result;
  for (unsigned i = 0; i < 6; ++i)
    result[i] = a[i] - b[i];
  return result;
}

/// exp(E); exactly diagonal if E is.
Tensor<2, 3> stretch(const Six &strain)
{
  Tensor<2, 3> result;
  if (largest({strain[3], strain[4], strain[5]}) <= 0) {
    for (unsigned i = 0; i < 3; ++i)
      result[i][i] = std::exp(strain[i]);
    return result;
  }
  SymmetricTensor<2, 3> E;
  for (unsigned i = 0; i < 6; ++i)
    E[entry[i][0]][entry[i][1]] = strain[i];
  for (const auto &[value, axis] : dealii::eigenvectors(
           E, dealii::SymmetricTensorEigenvectorMethod::jacobi))
    result += std::exp(value) * outer_product(axis, axis);
  return result;
}

/// F_new F_old^-1; exactly diagonal if both are.
Tensor<2, 3> increment(const Tensor<2, 3> &F_new, const Tensor<2, 3> &F_old)
{
  double off = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      if (i != j)
        off = std::max({off, std::abs(F_new[i][j]), std::abs(F_old[i][j])});
  if (off > 0)
    return F_new * invert(F_old);
  Tensor<2, 3> result;
  for (unsigned i = 0; i < 3; ++i)
    result[i][i] = F_new[i][i] / F_old[i][i];
  return result;
}

/// Point 0 of some material points; the others stand still.
class Probe
{
public:
  explicit Probe(MaterialPoints &points)
      : points_(points), F_(dealii::unit_symmetric_tensor<3>()), trial_F_(F_),
        deformations_(points.size(), {F_}), responses_(points.size())
  {
    AssertThrow(points.size() > 0,
                dealii::ExcMessage("a path needs a material point"));
  }

  const Response &evaluate(const Tensor<2, 3> &F, const Want want)
  {
    trial_F_ = F;
    deformations_[0].relative_F = increment(F, F_);
    points_.evaluate(deformations_, want, responses_);
    return responses_[0];
  }

  void begin_attempt() { points_.begin_attempt(); }

  void commit()
  {
    points_.commit();
    F_ = trial_F_;
  }

  const Tensor<2, 3> &F() const { return F_; }
  const Response &response() const { return responses_[0]; }

private:
  MaterialPoints &points_;
  Tensor<2, 3> F_, trial_F_;
  std::vector<Deformation> deformations_;
  std::vector<Response> responses_;
};

/// What an increment aims at.
struct Goal {
  std::vector<unsigned> free;    ///< components under stress control
  Six strain{};                  ///< of the components under strain control
  Six stress{};                  ///< of the free components
  double tolerance = 0;          ///< relative to the largest stress
  double stress_scale = 0;       ///< the largest stress is at least this [Pa]
  double largest_correction = 0; ///< of a strain component in an iteration
};

/// Gaussian elimination with row exchange; none if the matrix is singular.
std::optional<std::vector<double>> solve(std::vector<std::vector<double>> a,
                                         std::vector<double> b)
{
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k]))
        pivot = i;
    if (!(std::abs(a[pivot][k]) > 0))
      return {};
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double ratio = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j)
        a[i][j] -= ratio * a[k][j];
      b[i] -= ratio * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j)
      b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
    if (!std::isfinite(b[k]))
      return {};
  }
  return b;
}

/// Finds the free strains of one increment: Newton's method with the tangent
/// of the point, kept and improved by Broyden's rank-one updates (Broyden
/// 1965), corrections limited in size and halved where the residual grows.
class StressSearch
{
public:
  StressSearch(Probe &probe, const Goal &goal) : probe_(probe), goal_(goal) {}

  /// @param strain  in: a guess of the free strains; out: the solution, which
  ///                is also the last trial of the probe. False: none found.
  bool find(Six &strain)
  {
    probe_.begin_attempt();
    constexpr unsigned iterations = 40, refresh = 10;
    strain_ = strain;
    for (unsigned i = 0; i < 6; ++i)
      if (std::find(goal_.free.begin(), goal_.free.end(), i) ==
          goal_.free.end())
        strain_[i] = goal_.strain[i];
    for (unsigned iteration = 0; iteration < iterations; ++iteration) {
      if (iteration % refresh == 0) {
        if (!evaluate(strain_, Want::stress_and_tangent))
          return false;
        residual_ = trial_residual_;
        take_tangent();
      }
      if (norm(residual_) <= goal_.tolerance * scale()) {
        strain = strain_;
        return true;
      }
      if (!correct())
        return false;
    }
    return false;
  }

private:
  bool evaluate(const Six &strain, const Want want)
  {
    const Response &response = probe_.evaluate(stretch(strain), want);
    const Six stress = components(response.stress);
    trial_residual_.clear();
    for (const unsigned i : goal_.free)
      trial_residual_.push_back(stress[i] - goal_.stress[i]);
    return response.status != Status::failed && std::isfinite(largest(stress));
  }

  double scale() const
  {
    const double now = largest(components(probe_.response().stress));
    return std::max(now, goal_.stress_scale);
  }

  static double norm(const std::vector<double> &values)
  {
    double result = 0;
    for (const double value : values)
      result = std::max(result, std::abs(value));
    return result;
  }

  /// The derivative by the components of the logarithmic strain, for which the
  /// tangent is exact in the limit of small strains and a good start otherwise.
  void take_tangent()
  {
    const auto &tangent = probe_.response().tangent;
    const std::size_t n = goal_.free.size();
    slope_.assign(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const auto &[a, b] = entry[goal_.free[i]];
        const auto &[c, d] = entry[goal_.free[j]];
        slope_[i][j] = tangent[a][b][c][d] * (c == d ? 1 : 2);
      }
  }

  std::vector<double> correction() const
  {
    auto step = solve(slope_, residual_);
    const double most = goal_.largest_correction;
    if (!step) // a point without stiffness: go where the stress asks for
      step = residual_;
    const double size = norm(*step);
    const double factor = !(size > most) ? 1 : most / size;
    for (double &value : *step)
      value *= -factor;
    return *step;
  }

  bool correct()
  {
    std::vector<double> step = correction();
    const double before = norm(residual_);
    for (unsigned halving = 0; halving < 6; ++halving) {
      Six trial = strain_;
      for (std::size_t i = 0; i < step.size(); ++i)
        trial[goal_.free[i]] += step[i];
      if (evaluate(trial, Want::stress) &&
          norm(trial_residual_) < 1.5 * before) {
        update(step);
        strain_ = trial;
        residual_ = trial_residual_;
        return true;
      }
      for (double &value : step)
        value *= 0.5;
    }
    return false;
  }

  void update(const std::vector<double> &step)
  {
    double square = 0;
    for (const double value : step)
      square += value * value;
    if (!(square > 0))
      return;
    for (std::size_t i = 0; i < step.size(); ++i) {
      double miss = trial_residual_[i] - residual_[i];
      for (std::size_t j = 0; j < step.size(); ++j)
        miss -= slope_[i][j] * step[j];
      for (std::size_t j = 0; j < step.size(); ++j)
        slope_[i][j] += miss * step[j] / square;
    }
  }

  Probe &probe_;
  const Goal &goal_;
  Six strain_{};
  std::vector<double> residual_, trial_residual_;
  std::vector<std::vector<double>> slope_;
};

/// Walks the stages; knows the committed strain and stress.
class Walk
{
public:
  Walk(MaterialPoints &points,
       const std::function<void(const PathRecord &)> &observe,
       const double stress_tolerance)
      : probe_(points), observe_(observe), tolerance_(stress_tolerance)
  {
    stress_ =
        components(probe_.evaluate(stretch(strain_), Want::stress).stress);
    report();
  }

  bool run(const PathStage &stage, const unsigned index)
  {
    begin(stage, index);
    if (stage.has_until && beyond(stress_))
      return true;
    constexpr double most_cuts = 256, smallest_step = 1e-9;
    const double longest = nominal_;
    for (double place = 0, step = nominal_; place < 1;) {
      if (place + 1.001 * step >= 1)
        step = 1 - place;
      if (!attempt(place + step, step)) {
        step /= 2;
        if (step < 0.999 * std::min(nominal_, 1 - place) / most_cuts)
          return false;
        continue;
      }
      const double size =
          largest(difference(trial_strain_, strain_)) / stage.maximum_increment;
      if (size > 1.5) { // the stress asks for more strain than expected
        nominal_ = step = step * std::max(0.1, 0.9 / size);
        if (nominal_ < smallest_step)
          return false;
        continue;
      }
      if (stage.has_until && beyond(trial_stress_)) {
        if (!refine(place, step))
          return false;
        accept(step);
        return true;
      }
      accept(step);
      place = step >= 1 - place ? 1 : place + step;
      if (size < 0.5)
        nominal_ = std::min(longest, 1.5 * nominal_);
      step = std::min(nominal_, 2 * step);
    }
    return true;
  }

private:
  void begin(const PathStage &stage, const unsigned index)
  {
    stage_ = &stage;
    index_ = index;
    last_step_ = 0;
    begin_strain_ = end_strain_ = strain_;
    begin_stress_ = end_stress_ = stress_;
    goal_ = {};
    goal_.tolerance = tolerance_;
    goal_.largest_correction = stage.maximum_increment;
    for (unsigned i = 0; i < 6; ++i) {
      const ComponentTarget &target = stage.components[i];
      if (target.control == ComponentTarget::Control::stress) {
        goal_.free.push_back(i);
        end_stress_[i] = target.value;
      } else
        end_strain_[i] =
            target.value + (target.relative ? begin_strain_[i] : 0);
    }
    goal_.stress_scale = largest(begin_stress_);
    for (const unsigned i : goal_.free)
      goal_.stress_scale =
          std::max(goal_.stress_scale, std::abs(end_stress_[i]));
    const double way = largest(difference(end_strain_, begin_strain_));
    nominal_ = 1 / std::max({1.,
                             1. * stage.minimum_steps,
                             std::ceil(way / stage.maximum_increment - 1e-6)});
  }

  /// Finds the trial at a place between 0 and 1 of the stage.
  bool attempt(const double place, const double step)
  {
    const auto between = [place](const double a, const double b) {
      return place < 1 ? a + place * (b - a) : b;
    };
    for (unsigned i = 0; i < 6; ++i) {
      goal_.strain[i] = between(begin_strain_[i], end_strain_[i]);
      goal_.stress[i] = between(begin_stress_[i], end_stress_[i]);
    }
    bool found = false;
    if (last_step_ > 0 && !goal_.free.empty()) {
      for (unsigned i = 0; i < 6; ++i)
        trial_strain_[i] = strain_[i] + last_increment_[i] * step / last_step_;
      found = StressSearch(probe_, goal_).find(trial_strain_);
    }
    if (!found) {
      trial_strain_ = strain_;
      found = StressSearch(probe_, goal_).find(trial_strain_);
    }
    trial_stress_ = components(probe_.response().stress);
    return found;
  }

  bool beyond(const Six &stress) const
  {
    const double value = stress[stage_->until_component];
    return stage_->until_above ? value >= stage_->until_stress
                               : value <= stage_->until_stress;
  }

  /// Shortens the step until the trial meets the stress that ends the stage:
  /// regula falsi, every third time bisection.
  bool refine(const double place, double &step)
  {
    const auto off = [this](const Six &stress) {
      return stress[stage_->until_component] - stage_->until_stress;
    };
    const double near = 0.01 * (std::abs(stage_->until_stress) > 0
                                    ? std::abs(stage_->until_stress)
                                    : largest(begin_stress_));
    double low = 0, high = step, off_low = off(stress_);
    double off_high = off(trial_stress_);
    for (unsigned i = 1; i <= 40; ++i) {
      if (std::abs(off(trial_stress_)) <= near)
        return true;
      const double share = i % 3 == 0 ? 0.5 : off_low / (off_low - off_high);
      step = low + std::clamp(share, 0.02, 0.98) * (high - low);
      if (!attempt(place + step, step))
        return false;
      (beyond(trial_stress_) ? high : low) = step;
      (beyond(trial_stress_) ? off_high : off_low) = off(trial_stress_);
    }
    step = high; // the stress jumps: take the far side
    return attempt(place + step, step);
  }

  void accept(const double step)
  {
    probe_.commit();
    last_increment_ = difference(trial_strain_, strain_);
    last_step_ = step;
    strain_ = trial_strain_;
    stress_ = trial_stress_;
    ++step_;
    report();
  }

  void report() const
  {
    if (observe_)
      observe_({step_, index_, probe_.F(), probe_.response()});
  }

  Probe probe_;
  const std::function<void(const PathRecord &)> &observe_;
  double tolerance_ = 0;
  unsigned step_ = 0, index_ = 0;
  Six strain_{}, stress_{}, trial_strain_{}, trial_stress_{};

  const PathStage *stage_ = nullptr;
  Goal goal_;
  double nominal_ = 1, last_step_ = 0;
  Six begin_strain_{}, end_strain_{}, begin_stress_{}, end_stress_{};
  Six last_increment_{};
};
} // namespace

PathEnd drive_path(MaterialPoints &points,
                   const std::vector<PathStage> &stages,
                   const std::function<void(unsigned)> &stage_begins,
                   const std::function<void(const PathRecord &)> &observe,
                   const double stress_tolerance)
{
  Walk walk(points, observe, stress_tolerance);
  for (unsigned index = 0; index < stages.size(); ++index) {
    if (stage_begins)
      stage_begins(index);
    if (!walk.run(stages[index], index))
      return PathEnd::not_converged;
  }
  return PathEnd::finished;
}

PathEnd drive_gradients(MaterialPoints &points,
                        const std::vector<Tensor<2, 3>> &gradients,
                        const std::function<void(const PathRecord &)> &observe)
{
  std::vector<Tensor<2, 3>> increments;
  Tensor<2, 3> before = dealii::unit_symmetric_tensor<3>();
  for (const Tensor<2, 3> &F : gradients) {
    increments.push_back(increment(F, before));
    before = F;
  }
  return drive_increments(points, increments, observe);
}

PathEnd drive_increments(MaterialPoints &points,
                         const std::vector<Tensor<2, 3>> &increments,
                         const std::function<void(const PathRecord &)> &observe)
{
  std::vector<Deformation> deformation(points.size());
  std::vector<Response> response(points.size());
  const auto evaluate = [&](const Tensor<2, 3> &relative_F) {
    std::ranges::fill(deformation, Deformation{relative_F});
    points.begin_attempt();
    points.evaluate(deformation, Want::stress, response);
    return response[0].status != Status::failed;
  };
  PathRecord record;
  record.F = dealii::unit_symmetric_tensor<3>();
  if (!evaluate(record.F))
    return PathEnd::not_converged;
  record.response = response[0];
  if (observe)
    observe(record);
  for (const Tensor<2, 3> &relative_F : increments) {
    if (!evaluate(relative_F))
      return PathEnd::not_converged;
    points.commit();
    ++record.step;
    record.F = relative_F * record.F;
    record.response = response[0];
    if (observe)
      observe(record);
  }
  return PathEnd::finished;
}
} // namespace tamp::fem
