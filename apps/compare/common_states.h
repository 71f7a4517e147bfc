// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_common_states_h
#define apps_compare_common_states_h

#include <apps/compare/result_folder.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A state that all of several dies have written.
struct CommonState {
  std::string name; ///< "pressed" or "end", begins the names of fields
  std::string words;
  std::vector<WrittenFields> of_run; ///< a file for each run
  std::vector<std::size_t> lines;    ///< the line of each run's curve
};

/// The end of pressing, that is of the stage with the peak of the reference,
/// and the end of the last stage that all runs have begun. Where a run has not
/// ended a stage, its last written state there, and of the others those whose
/// punches are nearest. One state if both are the same; none if a run wrote no
/// fields.
std::vector<CommonState> common_states(std::span<const ResultFolder> runs);
} // namespace tamp::apps

#endif
