// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_compare_report_h
#define apps_compare_compare_report_h

#include <apps/compare/compared_curves.h>
#include <apps/compare/compared_fields.h>
#include <apps/compare/result_folder.h>

#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// All that is known of runs beside each other, the first one the reference.
struct Comparison {
  std::vector<ResultFolder> runs;
  std::vector<StageDifference> curves;
  std::vector<ComparedState> states;
  std::vector<std::string> warnings;
};

/// A quantity "name[unit]" of all runs; not a number where a run has none. What
/// tells a difference from the reference is 0 for the reference itself.
struct ComparedQuantity {
  std::string name;
  std::vector<double> values;
};

/// Key results, cost, norms of curves and of fields, in this order.
std::vector<ComparedQuantity>
key_results(const std::vector<ResultFolder> &runs);
std::vector<ComparedQuantity> costs(const std::vector<ResultFolder> &runs);
std::vector<ComparedQuantity>
curve_norms(const std::vector<StageDifference> &curves);
std::vector<ComparedQuantity>
field_norms(const std::vector<ComparedState> &states);

/// compare.csv: a line for each quantity with its value in each run, then the
/// difference of each run from the reference, in its unit and per cent.
std::string comparison_table(const Comparison &comparison);

/// summary.txt: the same in words, with what a reader has to know.
std::string comparison_summary(const Comparison &comparison);
} // namespace tamp::apps

#endif
