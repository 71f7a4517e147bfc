// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_compared_fields_h
#define apps_compare_compared_fields_h

#include <apps/compare/common_states.h>
#include <apps/compare/field_grid.h>

#include <map>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A field of a run less that of the reference, weighted with the volumes of
/// the reference.
struct FieldNorm {
  double mean = 0, root_mean_square = 0;
  double largest = 0; ///< with its sign
  Place at{};         ///< of the largest, in the reference's compact [m]
  double reference_root_mean_square = 0;
};

/// A run in a state, against the reference.
struct FieldDifference {
  std::string matching; ///< how material points were matched, in words
  double outside = 0;   ///< share of points that the other mesh has not [-]
  double mass = 0;      ///< solid volume of the run, by its own mesh [m3]
  /// Solid volume of the run less that of the reference, on the reference's
  /// mesh [m3].
  double mass_difference = 0;
  std::map<std::string, std::vector<double>> values; ///< not a number: outside
  std::map<std::string, FieldNorm> norms;
};

/// All runs in a state.
struct ComparedState {
  CommonState state;
  FieldGrid reference;
  double reference_mass = 0;           ///< solid volume [m3]
  std::vector<FieldDifference> others; ///< of the runs after the first
};

/// Reads the fields of all runs in a state. Throws InputError if a file cannot
/// be read or a half section stands beside a compact in three dimensions.
ComparedState compare_fields(const CommonState &state);

/// Writes the reference's mesh, undeformed, with its fields in all states, its
/// displacement, and for each run the differences, one value a part. Throws
/// OutputError.
void write_differences(const std::filesystem::path &file,
                       const std::vector<ComparedState> &states,
                       const std::vector<std::string> &names);
} // namespace tamp::apps

#endif
