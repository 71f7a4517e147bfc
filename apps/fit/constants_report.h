// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_constants_report_h
#define apps_fit_constants_report_h

#include <apps/fit/constants_fit.h>
#include <apps/fit/law_report.h>

namespace tamp::apps
{
/// Writes the folder of a fitted law of a few constants: law.prm, for Cam-Clay
/// law_abaqus.inp, fit.csv, what report_law() writes, plots, results and
/// warnings. Throws OutputError.
void report_constants(const ConstantsFit &fit, const FitReport &report);
} // namespace tamp::apps

#endif
