// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_compared_curves_h
#define apps_compare_compared_curves_h

#include <apps/compare/curve_difference.h>
#include <apps/compare/result_folder.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tamp::apps
{
/// One column over another in stages of these kinds.
struct CurvePair {
  std::string ordinate, abscissa;
  std::vector<std::string> kinds = {}; ///< none: all stages
  bool logarithmic = false;            ///< integrals are over ln(abscissa)
};

/// The curves that runs of a command are judged by. Columns that a run lacks,
/// as a law has no coordination number, are passed over.
std::vector<CurvePair> curve_pairs(const std::string &command);

/// Adds columns that follow from others. Die: approach[m] of the punches since
/// the start, travel[m] of the lower one in the die since the first ejection
/// began, density_range[-], the largest less the smallest density. Probe:
/// lateral_stress[Pa], the mean of xx and yy.
void add_derived_columns(ResultFolder &run);

/// How many stages, counted from the first, are of the same kind in all runs.
std::size_t common_stages(std::span<const ResultFolder> runs);

/// A pair in one stage: the difference of each run from the first one.
struct StageDifference {
  CurvePair pair;
  unsigned stage = 1;
  std::string kind;
  std::vector<std::optional<CurveDifference>> of_run; ///< the first is none
};

/// All pairs in all common stages in which at least one run has a difference.
std::vector<StageDifference> compare_curves(std::span<const ResultFolder> runs);
} // namespace tamp::apps

#endif
