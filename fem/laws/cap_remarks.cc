// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_remarks.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace tamp::fem
{
namespace
{
/// Tables have to reach this relative density to be complete.
constexpr double almost_full = 0.99;
constexpr double degree = std::numbers::pi / 180;
/// Published friction angles fall by a few degrees, not by more.
constexpr double largest_fall = 10 * degree;

std::string digits(const double value)
{
  std::ostringstream out;
  out.precision(4);
  out << value;
  return out.str();
}

std::string megapascal(const double pressure)
{
  return digits(pressure / 1e6) + " MPa";
}

struct NamedRange {
  std::string name;
  double first, last; ///< relative densities
};

std::vector<NamedRange> ranges(const DruckerPragerCapParameters &parameters)
{
  const auto over_density = [](const char *name, const DensityTable &table) {
    return NamedRange{name, table.first_place(), table.last_place()};
  };
  const DensityTable &hardening = parameters.hardening;
  return {over_density("Young's modulus", parameters.elasticity.youngs_modulus),
          over_density("Poisson's ratio", parameters.elasticity.poissons_ratio),
          over_density("cohesion", parameters.cohesion),
          over_density("friction angle", parameters.friction_angle),
          over_density("cap eccentricity", parameters.eccentricity),
          {"hydrostatic yield pressure",
           parameters.reference_density * std::exp(hardening.first_place()),
           parameters.reference_density * std::exp(hardening.last_place())}};
}

/// "a, b and c".
std::string joined(const std::vector<std::string> &names)
{
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

void judge_start(const DruckerPragerCapParameters &parameters,
                 std::vector<Remark> &result)
{
  const double start = parameters.initial_relative_density,
               reference = parameters.reference_density;
  const double strain = std::log(start / reference);
  // Rows below a row at the start are for powder that dilates first.
  if (std::ranges::any_of(parameters.hardening.rows().x, [&](const double x) {
        return std::abs(x - strain) <= 1e-6;
      }))
    return;
  const std::string pressure =
      megapascal(parameters.hardening.read(strain).value);
  const std::string found = "the powder starts at a relative density of " +
                            digits(start) + ", the hardening table at " +
                            digits(reference);
  const std::string remedy = "set the initial relative density to " +
                             digits(reference) + " to start at its first row";
  if (start > reference)
    result.push_back({found,
                      "it starts with the plastic volumetric strain " +
                          digits(strain) +
                          " between them and p_b = " + pressure,
                      remedy});
  else
    result.push_back({found,
                      "it yields at the first p_b = " + pressure +
                          " without hardening until it gets there, and points "
                          "are doubtful",
                      remedy});
}

/// Start densities that some tables do not have, those of the shape first.
void judge_first_rows(const DruckerPragerCapParameters &parameters,
                      std::vector<Remark> &result)
{
  constexpr double edge = 1e-9;
  const double start = parameters.initial_relative_density;
  for (const NamedRange &range : ranges(parameters)) {
    // A hardening table that begins later is told of by judge_start().
    const bool early = start < range.first - edge &&
                       range.name != "hydrostatic yield pressure";
    if (!early && !(start > range.last + edge))
      continue;
    result.push_back({"the powder starts at a relative density of " +
                          digits(start) + ", outside the table of " +
                          range.name + " from " + digits(range.first) + " to " +
                          digits(range.last),
                      "points are doubtful from the start",
                      "extend the table"});
  }
}

void judge_last_rows(const DruckerPragerCapParameters &parameters,
                     std::vector<Remark> &result)
{
  std::map<double, std::vector<std::string>> ends;
  for (const NamedRange &range : ranges(parameters))
    if (range.last < almost_full - 1e-6)
      ends[range.last].push_back(range.name);
  for (const auto &[density, names] : ends) {
    const bool hardens =
        std::ranges::count(names, "hydrostatic yield pressure");
    result.push_back(
        {"the table" + std::string(names.size() > 1 ? "s" : "") + " of " +
             joined(names) + " end" + (names.size() > 1 ? "" : "s") +
             " at a relative density of " + digits(density) + ", below " +
             digits(almost_full),
         std::string(hardens ? "the last line of the yield pressure goes on"
                             : "beyond it the last value holds") +
             ", and points that get there are doubtful",
         "extend the table if the run is to go further"});
  }
}

void judge_strength(const DruckerPragerCapParameters &parameters,
                    std::vector<Remark> &result)
{
  if (!parameters.cohesion.is_increasing())
    result.push_back({"the cohesion falls with density at some rows, from at "
                      "most " +
                          megapascal(parameters.cohesion.largest()),
                      "the powder weakens in tension while it is pressed",
                      "check the rows of the cohesion"});
  double highest = 0, fall = 0;
  for (const double angle : parameters.friction_angle.rows().y) {
    highest = std::max(highest, angle);
    fall = std::max(fall, highest - angle);
  }
  if (fall > largest_fall)
    result.push_back({"the friction angle falls by " + digits(fall / degree) +
                          " degrees over density, by more than " +
                          digits(largest_fall / degree),
                      "the powder weakens in shear while it is pressed",
                      "check the rows of the friction angle"});
}

/// The cap from the start to the last row of hardening, in steps of density.
void judge_cap(const DruckerPragerCapParameters &parameters,
               std::vector<Remark> &result)
{
  const DruckerPragerCap law(parameters);
  const double begin = std::log(parameters.initial_relative_density /
                                parameters.reference_density),
               end = std::max(begin, parameters.hardening.last_place());
  if (!std::isfinite(end))
    return;
  const auto density = [&](const double compaction) {
    return digits(parameters.reference_density * std::exp(compaction));
  };
  bool tension = false, weakens = false;
  double before = 0;
  for (unsigned i = 0; i <= 200; ++i) {
    const double compaction = begin + (end - begin) * i / 200;
    const auto surface = law.surface(compaction);
    if (!tension && surface.centre <= 0) {
      tension = true;
      result.push_back(
          {"the cap begins at p_a = " + megapascal(surface.centre) +
               " at a relative density of " + density(compaction) +
               ", not above 0",
           "the powder compacts wherever it is pressed and never fails in "
           "shear",
           "lower the cap eccentricity or the cohesion there"});
    }
    if (!weakens && surface.top() < before) {
      weakens = true;
      result.push_back({"the top of the cap falls below " + megapascal(before) +
                            " at a relative density of " + density(compaction),
                        "the powder weakens in shear while it is pressed",
                        "check the cap eccentricity and friction angle there"});
    }
    before = surface.top();
  }
}
} // namespace

std::string Remark::text() const
{
  return found + ": " + effect + (remedy.empty() ? "" : "; " + remedy);
}

std::vector<Remark> remarks(const DruckerPragerCapParameters &parameters)
{
  std::vector<Remark> result;
  judge_start(parameters, result);
  judge_first_rows(parameters, result);
  judge_last_rows(parameters, result);
  judge_strength(parameters, result);
  judge_cap(parameters, result);
  return result;
}
} // namespace tamp::fem
