// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_fit.h>
#include <apps/fit/cap_samples.h>
#include <apps/fit/isotonic.h>
#include <apps/input/units.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>

namespace tamp::apps
{
namespace
{
/// The least cohesion over p_b: without any, the surface would end in a point
/// without strength at zero stress, which is where a compact's free faces are.
constexpr double least_cohesion = 1e-3;
/// Shear points above this share of p_b say little of d, as the line of failure
/// bends.
constexpr double far_from_axis = 0.2;
/// Tables begin so far below the start: a powder without stress dilates a
/// little before it compacts.
constexpr double room_below = 0.99;
constexpr std::size_t fewest_levels = 3;
constexpr unsigned hardening_rows = 40;

using Field = double CapValues::*;

// Linear between levels, constant beyond them.
double
at_levels(const std::vector<CapLevel> &levels, double density, Field field)
{
  const auto above =
      std::ranges::upper_bound(levels, density, {}, &CapLevel::density);
  if (above == levels.begin())
    return levels.front().value.*field;
  if (above == levels.end())
    return levels.back().value.*field;
  const CapLevel &low = *(above - 1), &high = *above;
  const double share = (density - low.density) / (high.density - low.density);
  return (1 - share) * (low.value.*field) + share * (high.value.*field);
}

double at_rows(const std::vector<HardeningRow> &rows, double density)
{
  const auto above =
      std::ranges::upper_bound(rows, density, {}, &HardeningRow::density);
  if (above == rows.begin())
    return rows.front().pressure;
  // Above the last row its line goes on, as in the law.
  const auto end = std::min(above, rows.end() - 1);
  const HardeningRow &low = *(end - 1), &high = *end;
  const double share = (density - low.density) / (high.density - low.density);
  return (1 - share) * low.pressure + share * high.pressure;
}

void smooth(std::vector<CapLevel> &levels, Field field)
{
  std::vector<double> values;
  for (const CapLevel &level : levels)
    values.push_back(level.value.*field);
  values = isotonic(values);
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i].value.*field = values[i];
}

class CapFitter
{
public:
  CapFitter(const std::vector<ProbeData> &probes, YieldCriterion criterion)
      : samples_(probes, criterion)
  {
  }

  CapFit fit()
  {
    find_levels();
    smooth(fit_.levels, &CapValues::cohesion);
    smooth(fit_.levels, &CapValues::youngs_modulus);
    fit_.hardening_from = samples_.has(Loading::isotropic) ? Loading::isotropic
                                                           : Loading::uniaxial;
    find_hardening();
    take_yield_pressures();
    raise_cohesion();
    judge_lines();
    make_law();
    return std::move(fit_);
  }

private:
  void find_levels()
  {
    unsigned dropped = 0;
    for (const SampleLevel &found : samples_.levels()) {
      if (const auto level = samples_.fit(found))
        fit_.levels.push_back(*level);
      else {
        ++dropped;
        fit_.remarks.push_back(fmt::format(
            "nothing was fitted at a relative density of {:.4g}: the state on "
            "the uniaxial path is not below the shear line (a scan whose yield "
            "is told by another --criterion may help), or has not yielded",
            found.density));
      }
    }
    if (fit_.levels.size() < fewest_levels)
      throw InputError(fmt::format(
          "the tables need at least {} relative densities with shear points "
          "and a yielded state on a uniaxial path; there are {}{}",
          fewest_levels,
          fit_.levels.size(),
          dropped > 0 ? ". At others: " + fit_.remarks.front() : ""));
    if (samples_.origin_lines() > 0)
      fit_.remarks.push_back(fmt::format(
          "{} shear lines have points of one pressure only and were drawn "
          "through the origin: their cohesion is not known",
          samples_.origin_lines()));
    if (!samples_.has_moduli())
      fit_.remarks.push_back("there is no moduli.csv: E and nu are those of "
                             "the unloading of the uniaxial path");
  }

  double pressure_of(const PlasticPath &path, double density) const
  {
    if (fit_.hardening_from == Loading::isotropic)
      return path.pressure(density);
    const auto at = [&](Field field) {
      return at_levels(fit_.levels, density, field);
    };
    const PathSlope state = path.slope(density);
    const auto cap = cap_through(
        {at(&CapValues::cohesion), std::tan(at(&CapValues::friction_angle))},
        at(&CapValues::eccentricity),
        {state.pressure, state.deviatoric_stress});
    return cap ? cap->yield_pressure : std::numeric_limits<double>::quiet_NaN();
  }

  void find_hardening()
  {
    const auto paths = samples_.paths(fit_.hardening_from);
    double first = 0, last = 1;
    for (const PlasticPath *path : paths) {
      const auto points = path->yielded(yield_offset);
      if (points.size() < 2)
        throw InputError("the powder does not yield on its way: no plastic "
                         "compaction above 5e-4");
      first = std::max(first, points.front().density);
      last = std::min(last, points.back().density);
    }
    std::vector<double> densities, pressures;
    for (unsigned i = 0; i < hardening_rows; ++i) {
      const double share = i / (hardening_rows - 1.),
                   density = first * std::exp(share * std::log(last / first));
      double sum = 0;
      for (const PlasticPath *path : paths)
        sum += std::log(pressure_of(*path, density));
      if (!std::isfinite(sum))
        continue;
      densities.push_back(density);
      pressures.push_back(std::exp(sum / static_cast<double>(paths.size())));
    }
    // Rows of one pressure become one row at their mean density.
    for (const IsotonicBlock &block : isotonic_blocks(pressures)) {
      double sum = 0;
      for (std::size_t k = 0; k < block.count; ++k)
        sum += densities[block.first + k];
      fit_.hardening.push_back(
          {sum / static_cast<double>(block.count), block.value});
    }
    if (fit_.hardening.size() < 2)
      throw InputError("the pressure does not grow with density on the paths");
  }

  void take_yield_pressures()
  {
    const auto table = [&](double density) {
      return at_rows(fit_.hardening, density);
    };
    double ratio = 0;
    for (CapLevel &level : fit_.levels) {
      samples_.take_yield_pressure(fit_.hardening_from, table, level);
      level.value.yield_pressure = table(level.density);
      ratio +=
          std::log(level.uniaxial_yield_pressure / level.value.yield_pressure);
    }
    ratio = std::exp(ratio / static_cast<double>(fit_.levels.size()));
    if (fit_.hardening_from == Loading::isotropic && std::abs(ratio - 1) > 0.02)
      fit_.remarks.push_back(fmt::format(
          "p_b of the isotropic paths; the uniaxial ones alone would give "
          "{:.3g} times as much. For dies, give only uniaxial probes to the "
          "fit: the law then follows them",
          ratio));
  }

  void raise_cohesion()
  {
    unsigned raised = 0;
    for (CapLevel &level : fit_.levels)
      if (const double least = least_cohesion * level.value.yield_pressure;
          level.value.cohesion < least) {
        level.value.cohesion = least;
        ++raised;
      }
    smooth(fit_.levels, &CapValues::cohesion);
    if (raised > 0)
      fit_.remarks.push_back(
          fmt::format("the cohesion of {} of {} densities is below {} p_b (the "
                      "powder has next to none) and was raised to it, so that "
                      "a stress-free face has some strength",
                      raised,
                      fit_.levels.size(),
                      least_cohesion));
  }

  void judge_lines()
  {
    std::vector<double> extrapolated;
    for (CapLevel &level : fit_.levels) {
      const auto &points = level.shear_points;
      level.shear_residual = residual_of(
          {level.value.cohesion, std::tan(level.value.friction_angle), false},
          points);
      level.cohesion_error = cohesion_error(points);
      level.cohesion_extrapolated =
          std::ranges::min(points, {}, &StressPoint::p).p >
          far_from_axis * level.value.yield_pressure;
      if (level.cohesion_extrapolated)
        extrapolated.push_back(level.density);
    }
    if (!extrapolated.empty())
      fit_.remarks.push_back(fmt::format(
          "the cohesion of {} of {} densities, the lowest {:.4g}, is a guess: "
          "their shear points are above {} p_b, and the line of failure bends "
          "(cohesion_extrapolated in fit.csv); scan smaller "
          "Scan/Compression shares",
          extrapolated.size(),
          fit_.levels.size(),
          extrapolated.front(),
          far_from_axis));
  }

  // Scans begin later than paths. The law starts where these do: only so are
  // its elastic strains at the first level those of the probes. Its tables
  // begin a little below.
  void begin_tables(coupling::CapChoice &law)
  {
    const HardeningRow &first = fit_.hardening[0], &second = fit_.hardening[1];
    const double power = std::log(second.pressure / first.pressure) /
                         std::log(second.density / first.density);
    const HardeningRow below{room_below * first.density,
                             first.pressure * std::pow(room_below, power)};
    law.hardening_density.push_back(below.density);
    law.hydrostatic_yield.push_back(below.pressure);
    law.initial_relative_density = first.density;
    const CapLevel &level = fit_.levels.front();
    for (const HardeningRow &row : {below, first}) {
      if (!(row.density < level.density))
        continue;
      law.relative_density.push_back(row.density);
      law.cohesion.push_back(level.value.cohesion * row.pressure /
                             level.value.yield_pressure);
      law.friction_angle.push_back(level.value.friction_angle);
      law.cap_eccentricity.push_back(level.value.eccentricity);
      const auto [E, nu] = samples_.elasticity(row.density);
      law.elasticity.relative_density.push_back(row.density);
      law.elasticity.youngs_modulus.push_back(
          std::min(E, level.value.youngs_modulus));
      law.elasticity.poissons_ratio.push_back(nu);
    }
  }

  void make_law()
  {
    coupling::CapChoice &law = fit_.law;
    if (const double last = fit_.levels.back().density,
        end = fit_.hardening.back().density;
        end > 1.01 * last)
      fit_.remarks.push_back(
          fmt::format("the paths go on to a relative density of {:.4g}, the "
                      "scans end at {:.4g}: elasticity and shape are held "
                      "beyond; scan the end of the path, too",
                      end,
                      last));
    begin_tables(law);
    for (const CapLevel &level : fit_.levels) {
      law.relative_density.push_back(level.density);
      law.cohesion.push_back(level.value.cohesion);
      law.friction_angle.push_back(level.value.friction_angle);
      law.cap_eccentricity.push_back(level.value.eccentricity);
      law.elasticity.relative_density.push_back(level.density);
      law.elasticity.youngs_modulus.push_back(level.value.youngs_modulus);
      law.elasticity.poissons_ratio.push_back(level.value.poissons_ratio);
    }
    for (const HardeningRow &row : fit_.hardening) {
      law.hardening_density.push_back(row.density);
      law.hydrostatic_yield.push_back(row.pressure);
    }
  }

  CapSamples samples_;
  CapFit fit_;
};
} // namespace

CapFit fit_cap(const std::vector<ProbeData> &probes, YieldCriterion criterion)
{
  return CapFitter(probes, criterion).fit();
}
} // namespace tamp::apps
