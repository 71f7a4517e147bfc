// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_cap_report_h
#define apps_fit_cap_report_h

#include <apps/fit/cap_fit.h>
#include <apps/fit/law_report.h>

namespace tamp::apps
{
/// Writes the folder of a fitted cap: law.prm, law_abaqus.inp, fit.csv, what
/// report_law() writes, plots, results and warnings. Throws OutputError.
void report_cap(const CapFit &fit, const FitReport &report);
} // namespace tamp::apps

#endif
