// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_calibration_report_h
#define apps_calibrate_calibration_report_h

#include <apps/calibrate/curve_targets.h>
#include <apps/calibrate/fit_confidence.h>
#include <apps/run/run_session.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// Writes `measured.csv`, `curve.csv` (the best run with the first packing)
/// and `residuals.csv` (of the mean of all packings), and draws them. Throws
/// OutputError.
void write_best_curve(RunSession &session,
                      const CompactionCurve &measured,
                      const CompactionCurve &best,
                      const CurveTargets &targets,
                      const Eigen::VectorXd &residuals);

/// Hands over what is known of the parameters: results, and sentences as
/// warnings where the data tell too little.
void give_confidence(RunSession &session,
                     const std::vector<FitParameter> &parameters,
                     const FitConfidence &confidence);
} // namespace tamp::apps

#endif
