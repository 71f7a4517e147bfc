// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compared_fields.h>
#include <apps/input/units.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
// Where a part's volume has gone since the start: a field like the others.
const std::string volume_ratio = "volume_ratio";

double sum_of_products(const std::vector<double> &a,
                       const std::vector<double> &b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

double total(const std::vector<double> &volumes)
{
  return sum_of_products(volumes, std::vector<double>(volumes.size(), 1.));
}

bool same_size(const FieldGrid &first, const FieldGrid &second)
{
  const Place a = extent_of(first).size, b = extent_of(second).size;
  bool same = first.knows_displacement && second.knows_displacement;
  for (unsigned axis = 0; axis < first.dimension; ++axis)
    same = same && std::abs(b[axis] - a[axis]) <= 1e-3 * a[axis];
  return same;
}

struct Volumes {
  std::vector<double> now, undeformed;
  explicit Volumes(const FieldGrid &grid)
      : now(part_volumes(grid.dimension, grid.now)),
        undeformed(part_volumes(grid.dimension, grid.undeformed))
  {
  }
  std::vector<double> ratios() const
  {
    std::vector<double> result;
    for (std::size_t i = 0; i < now.size(); ++i)
      result.push_back(now[i] / undeformed[i]);
    return result;
  }
};

// The other run's fields at the reference's material points.
SampledFields bring(FieldGrid reference, FieldGrid other, std::string &how)
{
  if (same_mesh(reference, other)) {
    how = "point for point: the meshes are the same";
    return {other.values, std::vector<bool>(other.parts(), true)};
  }
  if (same_size(reference, other)) {
    how = "resampled at the reference's material points, at equal places at "
          "the start of the run";
  } else {
    normalise(reference);
    normalise(other);
    how = reference.knows_displacement && other.knows_displacement
              ? "resampled at the reference's material points; the powders "
                "were not of the same size at the start, so places are "
                "matched by their shares of radius and height"
              : "resampled at the reference's material points; a run wrote no "
                "displacement, so places are matched by their shares of the "
                "present radius and height";
  }
  return sample(other, point_places(reference.dimension, reference.undeformed));
}

FieldNorm norm_of(const std::vector<double> &difference,
                  const std::vector<double> &reference,
                  const std::vector<double> &volumes,
                  const std::vector<Place> &places)
{
  FieldNorm norm;
  double whole = 0;
  for (std::size_t i = 0; i < difference.size(); ++i) {
    if (std::isnan(difference[i]))
      continue;
    whole += volumes[i];
    norm.mean += volumes[i] * difference[i];
    norm.root_mean_square += volumes[i] * difference[i] * difference[i];
    norm.reference_root_mean_square += volumes[i] * reference[i] * reference[i];
    if (std::abs(difference[i]) > std::abs(norm.largest)) {
      norm.largest = difference[i];
      norm.at = places[i];
    }
  }
  if (whole > 0) {
    norm.mean /= whole;
    norm.root_mean_square = std::sqrt(norm.root_mean_square / whole);
    norm.reference_root_mean_square =
        std::sqrt(norm.reference_root_mean_square / whole);
  }
  return norm;
}

FieldDifference compare(const FieldGrid &reference, FieldGrid other)
{
  const Volumes volumes(reference), own(other);
  FieldDifference result;
  result.mass = sum_of_products(other.values.at("relative_density"), own.now);
  other.values[volume_ratio] = own.ratios();
  const SampledFields sampled = bring(reference, other, result.matching);
  const auto parts = static_cast<double>(reference.parts());
  result.outside =
      static_cast<double>(std::ranges::count(sampled.inside, false)) / parts;
  const auto places = point_places(reference.dimension, reference.now);
  for (const auto &[name, values] : reference.values) {
    if (!sampled.values.contains(name))
      continue;
    std::vector<double> &difference = result.values[name];
    for (std::size_t i = 0; i < values.size(); ++i)
      difference.push_back(sampled.inside[i]
                               ? sampled.values.at(name)[i] - values[i]
                               : std::nan(""));
    result.norms[name] = norm_of(difference, values, volumes.now, places);
  }
  // Unequal sizes are matched share by share: so are volumes.
  const double scale = same_size(reference, other)
                           ? 1
                           : total(own.undeformed) / total(volumes.undeformed);
  const std::vector<double> ratios = volumes.ratios();
  for (std::size_t i = 0; i < reference.parts(); ++i)
    if (sampled.inside[i])
      result.mass_difference +=
          volumes.undeformed[i] *
          (scale * sampled.values.at("relative_density")[i] *
               sampled.values.at(volume_ratio)[i] -
           reference.values.at("relative_density")[i] * ratios[i]);
  return result;
}
} // namespace

ComparedState compare_fields(const CommonState &state)
{
  ComparedState result{state, read_fields(state.of_run.front().file), 0, {}};
  const FieldGrid &reference = result.reference;
  result.reference_mass =
      sum_of_products(reference.values.at("relative_density"),
                      part_volumes(reference.dimension, reference.now));
  for (std::size_t run = 1; run < state.of_run.size(); ++run) {
    FieldGrid other = read_fields(state.of_run[run].file);
    if (other.dimension != reference.dimension)
      throw InputError(
          fmt::format("'{}' is a half section and '{}' is not, or the other "
                      "way round: their fields have no mesh in common",
                      state.of_run.front().file.string(),
                      state.of_run[run].file.string()));
    result.others.push_back(compare(reference, std::move(other)));
  }
  return result;
}
} // namespace tamp::apps
