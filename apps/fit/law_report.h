// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_law_report_h
#define apps_fit_law_report_h

#include <apps/fit/probe_data.h>
#include <apps/output/plots.h>
#include <apps/run/run_session.h>
#include <coupling/material_factory.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What reports of all laws are about.
struct FitReport {
  const std::vector<ProbeData> &probes;
  /// Sentences about the data and how they were used, for the law's files.
  std::vector<std::string> data;
  RunSession &session;
};

/// Says how far a point of the law is from the uniaxial probes, see
/// check_law(): curve.csv, unloading.csv, key results, and a warning where the
/// law is off by more than 5 % while loading or 10 % in unloading. Returns the
/// plots of it. Throws OutputError.
std::vector<Plot>
report_law(const FitReport &report,
           const coupling::MaterialChoice &law,
           double lowest_density,
           double highest_density,
           const std::vector<coupling::MaterialChoice> &replicas = {});
} // namespace tamp::apps

#endif
