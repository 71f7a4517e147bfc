// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/constants_fit.h>
#include <apps/fit/fitted_laws.h>
#include <apps/fit/law_courses.h>
#include <apps/fit/plastic_density.h>
#include <apps/input/units.h>
#include <fem/laws/bracketed_root.h>

#include <algorithm>
#include <array>
#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>
#include <utility>

namespace tamp::apps
{
namespace
{
/// What a kind of difference counts: paths, yield points, moduli. A law whose
/// surface has another shape than that of the powder is to follow the paths.
constexpr std::array<double, 3> weights{1, 0.2, 0.5};

/// How often the way from the middle of the surface on the axis of p to a point
/// fits into that to the surface in the same direction [-]: sound at both ends
/// of the surface, also where q is small.
template <class Unknowns, class Law, class State>
double times_to_surface(const Law &law, const State &state, StressPoint point)
{
  const double middle = Unknowns::yield_pressure(law, state) / 2;
  const auto outside = [&](double times) {
    return times * point.q -
           Unknowns::shear_limit(
               law, state, middle + times * (point.p - middle));
  };
  double far = 1;
  for (unsigned i = 0; i < 60 && outside(far) < 0; ++i)
    far *= 2;
  return fem::bracketed_root(outside, 0, far, 1e-10).value_or(far);
}

/// The differences between a law and courses, as Ceres asks for them.
template <class Unknowns>
struct Differences {
  const FirstGuess &guess;
  const std::vector<Course> &courses;

  /// Hands each difference and its kind (0 path, 1 yield, 2 moduli) out.
  template <class Take>
  bool tell(const typename Unknowns::Law &law, Take take) const
  {
    for (const Course &course : courses)
      if (!follow(law, course, [&](const CourseStop &stop, const auto &state) {
            tell_stop(law, course.loading, stop, state, take);
          }))
        return false;
    return true;
  }

  bool operator()(double const *const *unknowns, double *residuals) const
  {
    try {
      std::vector<std::pair<double, int>> all;
      if (!tell(Unknowns::law(guess, unknowns[0]),
                [&](double value, int kind) { all.emplace_back(value, kind); }))
        return false;
      std::array<double, 3> counts{};
      for (const auto &[value, kind] : all)
        counts[static_cast<std::size_t>(kind)] += 1;
      for (const auto &[value, kind] : all) {
        if (!std::isfinite(value))
          return false;
        *residuals++ = weights[static_cast<std::size_t>(kind)] * value /
                       std::sqrt(counts[static_cast<std::size_t>(kind)]);
      }
      return true;
    } catch (const std::invalid_argument &) {
      return false; // constants that the law does not take
    }
  }

private:
  template <class Law, class State, class Take>
  static void tell_stop(const Law &law,
                        Loading loading,
                        const CourseStop &stop,
                        const State &state,
                        Take &take)
  {
    if (stop.stress) {
      const auto s = deviator(state.stress);
      const double p = -trace(state.stress) / 3, q = std::sqrt(1.5 * (s * s));
      take(std::log(p / stop.stress->p), 0);
      if (loading == Loading::uniaxial)
        take(q / p - stop.stress->q / stop.stress->p, 0);
    }
    for (const StressPoint &point : stop.yields)
      take(std::log(times_to_surface<Unknowns>(law, state, point)), 1);
    for (const ModuliPoint &row : stop.moduli) {
      const ModuliPoint moduli = Unknowns::moduli(law, state);
      take(std::log(moduli.bulk_modulus / row.bulk_modulus), 2);
      take(std::log(moduli.shear_modulus / row.shear_modulus), 2);
    }
  }
};

std::vector<ModuliPoint> moduli_rows(const std::vector<ProbeData> &probes)
{
  std::vector<ModuliPoint> rows;
  for (const ProbeData &probe : probes) {
    rows.insert(rows.end(), probe.moduli.begin(), probe.moduli.end());
    if (const ModuliPoint row = moduli_of_unloading(probe);
        probe.moduli.empty() && row.bulk_modulus > 0 && row.shear_modulus > 0)
      rows.push_back(row);
  }
  if (rows.empty())
    throw InputError(
        "no elastic moduli: no folder has a moduli.csv, nor a uniaxial path "
        "that is unloaded; expected Scan/Densities in the input of the probe");
  return rows;
}

FirstGuess first_guess(const std::vector<ProbeData> &probes,
                       const Courses &courses)
{
  const PathElasticity elasticity(moduli_rows(probes));
  FirstGuess guess;
  guess.initial_density = 1;
  for (const ProbeData &probe : probes)
    guess.initial_density = std::min(
        guess.initial_density, PlasticPath(probe, elasticity).first_density());
  const auto state = [&](double density) {
    const StressPoint stress = stress_at(probes.front(), density);
    return PathPoint{density, stress.p, stress.q, 0, 0};
  };
  guess.early = state(courses.first_density());
  guess.late = state(std::min(courses.last_density(),
                              probes.front().curve.back().relative_density));
  guess.soft = elasticity.at(elasticity.first_density());
  guess.stiff = elasticity.at(elasticity.last_density());
  return guess;
}

template <class Unknowns>
typename Unknowns::Law minimise(const FirstGuess &guess,
                                const std::vector<Course> &courses,
                                const std::array<double, Unknowns::count> &from)
{
  using Function = ceres::DynamicNumericDiffCostFunction<Differences<Unknowns>,
                                                         ceres::CENTRAL>;
  std::array<double, Unknowns::count> values = from;
  const Differences<Unknowns> differences{guess, courses};
  int count = 0;
  if (!differences.tell(Unknowns::law(guess, values.data()),
                        [&](double, int) { ++count; }))
    throw std::runtime_error("the law fails with the first guess of its "
                             "constants");
  ceres::NumericDiffOptions difference;
  difference.relative_step_size = 1e-4;
  auto function =
      std::make_unique<Function>(new Differences<Unknowns>(differences),
                                 ceres::TAKE_OWNERSHIP,
                                 difference);
  function->AddParameterBlock(Unknowns::count);
  function->SetNumResiduals(count);
  ceres::Problem problem;
  problem.AddResidualBlock(function.release(), nullptr, values.data());
  const auto bounds = Unknowns::unknowns(guess);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int index = static_cast<int>(i);
    problem.SetParameterLowerBound(values.data(), index, bounds[i].lowest);
    problem.SetParameterUpperBound(values.data(), index, bounds[i].highest);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-8;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable())
    throw std::runtime_error("no constants of the law were found: " +
                             summary.message);
  return Unknowns::law(guess, values.data());
}

template <class Unknowns>
std::array<double, Unknowns::count> starts(const FirstGuess &guess)
{
  std::array<double, Unknowns::count> values{};
  const auto unknowns = Unknowns::unknowns(guess);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        std::clamp(unknowns[i].start, unknowns[i].lowest, unknowns[i].highest);
  return values;
}

template <class Unknowns>
void take_residuals(const typename Unknowns::Law &law,
                    const Differences<Unknowns> &differences,
                    ConstantsFit &fit)
{
  std::array<double, 3> squares{}, counts{};
  differences.tell(law, [&](double value, int kind) {
    squares[static_cast<std::size_t>(kind)] += value * value;
    counts[static_cast<std::size_t>(kind)] += 1;
  });
  const auto mean = [&](std::size_t kind) {
    return counts[kind] > 0 ? std::sqrt(squares[kind] / counts[kind]) : 0;
  };
  fit.path_residual = mean(0);
  fit.yield_residual = mean(1);
  fit.modulus_residual = mean(2);
}

template <class Unknowns>
void take_surfaces(const typename Unknowns::Law &law,
                   const std::vector<Course> &courses,
                   ConstantsFit &fit)
{
  for (const Course &course : courses)
    follow(law, course, [&](const CourseStop &stop, const auto &state) {
      if (stop.yields.empty())
        return;
      SurfacePicture picture;
      picture.density = stop.relative_density;
      picture.yield_pressure = Unknowns::yield_pressure(law, state);
      for (unsigned k = 0; k <= 100; ++k) {
        const double p = picture.yield_pressure * k / 100;
        picture.line.push_back({p, Unknowns::shear_limit(law, state, p)});
      }
      picture.yields = stop.yields;
      if (stop.stress && course.loading == Loading::uniaxial)
        picture.uniaxial.push_back(*stop.stress);
      fit.surfaces.push_back(picture);
    });
}

template <class Unknowns>
ConstantsFit fit_law(const std::vector<ProbeData> &probes,
                     YieldCriterion criterion)
{
  const Courses data(probes, criterion);
  const FirstGuess guess = first_guess(probes, data);
  const auto courses = data.courses(nullptr);
  const auto law = minimise<Unknowns>(guess, courses, starts<Unknowns>(guess));
  ConstantsFit fit;
  fit.law = Unknowns::material(law);
  fit.first_density = data.first_density();
  fit.last_density = data.last_density();
  for (const NamedConstant &constant : Unknowns::constants(law))
    fit.constants.push_back({constant.name, constant.unit, constant.value, 0});
  take_residuals<Unknowns>(law, {guess, courses}, fit);
  take_surfaces<Unknowns>(law, courses, fit);

  const auto replicas = data.replicas();
  fit.replicas = static_cast<unsigned>(replicas.size());
  if (replicas.size() < 2)
    return fit;
  std::vector<std::vector<double>> values(fit.constants.size());
  for (const ReplicaOfProbes &replica : replicas) {
    const auto own = minimise<Unknowns>(
        guess, data.courses(&replica), starts<Unknowns>(guess));
    const auto constants = Unknowns::constants(own);
    for (std::size_t i = 0; i < constants.size(); ++i)
      values[i].push_back(constants[i].value);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    double mean = 0, square = 0;
    for (const double value : values[i])
      mean += value / static_cast<double>(values[i].size());
    for (const double value : values[i])
      square += std::pow(value - mean, 2);
    fit.constants[i].deviation =
        std::sqrt(square / static_cast<double>(values[i].size() - 1));
  }
  return fit;
}
} // namespace

ConstantsFit fit_constants(coupling::MaterialKind kind,
                           const std::vector<ProbeData> &probes,
                           YieldCriterion criterion)
{
  return kind == coupling::MaterialKind::modified_cam_clay
             ? fit_law<CamClayUnknowns>(probes, criterion)
             : fit_law<FkmGursonUnknowns>(probes, criterion);
}
} // namespace tamp::apps
