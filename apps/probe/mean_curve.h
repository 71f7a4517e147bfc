// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_probe_mean_curve_h
#define apps_probe_mean_curve_h

#include <apps/output/number_table.h>

#include <span>
#include <vector>

namespace tamp::apps
{
/// The curve of a probe, with the line of its start at least.
struct ProbeCurve {
  NumberTable table;
  bool ended = true; ///< its path; otherwise it broke off
};

/// The mean of curves of probes along the same path, stage by stage: each line
/// of the curve with the most of them, the first of such curves, and what the
/// others have at the same share of their way in strain through the stage. A
/// stage whose end was met as it began leaves a curve where it is. The mean
/// ends where the first curve broke off: in that stage the same ways are
/// compared, not the same shares. Behind the columns of the curves stand the
/// standard deviations of stresses and density, "NAME_deviation[unit]". Throws
/// OutputError if columns differ.
NumberTable mean_curve(const std::vector<ProbeCurve> &curves);
} // namespace tamp::apps

#endif
