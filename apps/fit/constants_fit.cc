// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/constants_fit.h>
#include <apps/fit/fitted_laws.h>
#include <apps/fit/law_courses.h>
#include <apps/fit/plastic_density.h>
#include <apps/input/units.h>
#include <apps/output/scatter.h>
#include <fem/laws/bracketed_root.h>

#include <algorithm>
#include <array>
#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace tamp::apps
{
namespace
{
/// What a kind of difference counts: paths, yield points, moduli. A law whose
/// surface has another shape than that of the powder is to follow the paths.
constexpr std::array<double, 3> weights{1, 0.2, 0.5};

/// How often a step from (middle, 0) in the plane of p and q fits into the way
/// to the surface in its direction [-]: sound at both ends of the surface, also
/// where q is small.
template <class Unknowns, class Law, class State>
double times_to_surface(const Law &law,
                        const State &state,
                        double middle,
                        StressPoint step)
{
  const auto outside = [&](double times) {
    return times * step.q -
           Unknowns::shear_limit(law, state, middle + times * step.p);
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
    const double middle = Unknowns::yield_pressure(law, state) / 2;
    for (const StressPoint &point : stop.yields)
      take(std::log(times_to_surface<Unknowns>(
               law, state, middle, {point.p - middle, point.q})),
           1);
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
  for (const ProbeData &probe : probes)
    guess.initial_density +=
        std::min(PlasticPath(probe, elasticity).first_density(),
                 courses.first_density()) /
        static_cast<double>(probes.size());
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

/// The states of a law at the stops of a course that have yield points; fewer
/// if it failed on its way.
template <class Law>
std::vector<typename Law::State> scanned_states(const Law &law,
                                                const Course &course)
{
  std::vector<typename Law::State> states;
  (void)follow(law, course, [&](const CourseStop &stop, const auto &state) {
    if (!stop.yields.empty())
      states.push_back(state);
  });
  return states;
}

/// A law and its states at the same stops as those of other laws.
template <class Law>
struct FollowedLaw {
  Law law;
  std::vector<typename Law::State> states;
};

/// The surface of the first law at a stop, and the band of the others, along
/// rays from the middle of the first.
template <class Unknowns>
void take_surface(const std::vector<FollowedLaw<typename Unknowns::Law>> &laws,
                  std::size_t stop,
                  SurfacePicture &picture)
{
  constexpr unsigned rays = 100;
  constexpr double edge = 1e-6; // of the angle at both ends: q is not zero
  const auto &[law, states] = laws.front();
  picture.yield_pressure = Unknowns::yield_pressure(law, states[stop]);
  const double middle = picture.yield_pressure / 2;
  std::vector<StressPoint> nearest, farthest;
  for (unsigned k = 0; k <= rays; ++k) {
    const double angle =
        edge + (1 - 2 * edge) * (rays - k) / rays * std::numbers::pi;
    const StressPoint step{middle * std::cos(angle), middle * std::sin(angle)};
    std::vector<double> times;
    for (const auto &[other, at] : laws)
      if (stop < at.size())
        times.push_back(
            times_to_surface<Unknowns>(other, at[stop], middle, step));
    const auto point = [&](double far) {
      return StressPoint{middle + far * step.p, far * step.q};
    };
    picture.line.push_back(point(times.front()));
    if (times.size() < 3)
      continue;
    const auto [least, most] =
        std::minmax_element(times.begin() + 1, times.end());
    nearest.push_back(point(*least));
    farthest.push_back(point(*most));
  }
  picture.band = farthest;
  picture.band.insert(picture.band.end(), nearest.rbegin(), nearest.rend());
}

/// @param laws  the fit, then those to single replicas.
template <class Unknowns>
void take_surfaces(const std::vector<typename Unknowns::Law> &laws,
                   const std::vector<Course> &courses,
                   ConstantsFit &fit)
{
  std::map<double, SurfacePicture> pictures; // by density
  for (const Course &course : courses) {
    std::vector<FollowedLaw<typename Unknowns::Law>> followed;
    for (const auto &law : laws)
      followed.push_back({law, scanned_states(law, course)});
    std::size_t number = 0;
    for (const CourseStop &stop : course.stops) {
      if (stop.yields.empty() || number == followed.front().states.size())
        continue;
      SurfacePicture &picture = pictures[stop.relative_density];
      picture.density = stop.relative_density;
      if (picture.line.empty())
        take_surface<Unknowns>(followed, number, picture);
      picture.yields.insert(
          picture.yields.end(), stop.yields.begin(), stop.yields.end());
      if (stop.stress && course.loading == Loading::uniaxial)
        picture.uniaxial.push_back(*stop.stress);
      ++number;
    }
  }
  for (const auto &[density, picture] : pictures)
    fit.surfaces.push_back(picture);
}

/// @param laws  the fit, then those to single replicas.
template <class Unknowns>
void take_deviations(const std::vector<typename Unknowns::Law> &laws,
                     ConstantsFit &fit)
{
  for (std::size_t i = 0; i < fit.constants.size(); ++i) {
    std::vector<double> values;
    for (auto law = laws.begin() + 1; law != laws.end(); ++law)
      values.push_back(Unknowns::constants(*law)[i].value);
    fit.constants[i].deviation = scatter_of(values).deviation;
  }
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

  std::vector laws{law};
  const auto replicas = data.replicas();
  fit.replicas = static_cast<unsigned>(replicas.size());
  if (replicas.size() > 1)
    for (const ReplicaOfProbes &replica : replicas) {
      laws.push_back(minimise<Unknowns>(
          guess, data.courses(&replica), starts<Unknowns>(guess)));
      fit.replica_laws.push_back(Unknowns::material(laws.back()));
    }
  take_deviations<Unknowns>(laws, fit);
  take_surfaces<Unknowns>(laws, courses, fit);
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
