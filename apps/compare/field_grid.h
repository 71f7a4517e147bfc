// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_field_grid_h
#define apps_compare_field_grid_h

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tamp::apps
{
using Place = std::array<double, 3>; // [m]

/// The fields of a compact as a .vtu file of tamp has them: parts of elements,
/// one for each material point, those of an element one after the other, each
/// with 4 or 8 corners, the first axis running fastest.
struct FieldGrid {
  unsigned dimension = 2;         ///< 2: half section, x = r, y = z
  std::vector<Place> now;         ///< corners of all parts
  std::vector<Place> undeformed;  ///< likewise, at the start of the run
  bool knows_displacement = true; ///< else `undeformed` is `now`
  /// A value for each part: relative_density, pressure, deviatoric_stress,
  /// stress_*; compression positive [Pa].
  std::map<std::string, std::vector<double>> values;

  unsigned corners() const { return 1u << dimension; } ///< of each part
  std::size_t parts() const { return now.size() / corners(); }
};

/// Throws InputError naming the file if it cannot be read or is not what tamp
/// writes.
FieldGrid read_fields(const std::filesystem::path &file);

/// Have both the same parts in the same undeformed places? The files have
/// single precision: to 1e-5 of the size.
bool same_mesh(const FieldGrid &first, const FieldGrid &second);

/// Volumes of parts with these corners [m3]; of a half section those of whole
/// rings. By two Gauss points an axis.
std::vector<double> part_volumes(unsigned dimension,
                                 std::span<const Place> corners);

/// The material points' places in parts with these corners: the Gauss points of
/// the elements.
std::vector<Place> point_places(unsigned dimension,
                                std::span<const Place> corners);

/// Of the undeformed places: the largest distance from the planes x = 0 and y =
/// 0, and along the pressing axis, the last one, lowest place and height [m].
struct Extent {
  Place low{}, size{};
};
Extent extent_of(const FieldGrid &grid);

/// Scales the undeformed places to a box of unit height, standing on zero, and
/// unit half width.
void normalise(FieldGrid &grid);

/// Values of another grid at places in undeformed coordinates.
struct SampledFields {
  std::map<std::string, std::vector<double>> values;
  std::vector<bool> inside; ///< elsewhere values mean nothing
};

/// In each element a value is the multilinear function that meets the values
/// of its material points: a field linear in space is found again exactly.
SampledFields sample(const FieldGrid &grid, std::span<const Place> places);
} // namespace tamp::apps

#endif
