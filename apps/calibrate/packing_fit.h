// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_packing_fit_h
#define apps_calibrate_packing_fit_h

#include <apps/calibrate/calibration.h>
#include <apps/calibrate/fit_confidence.h>

#include <Eigen/Dense>

namespace tamp::apps
{
/// A fit to the mean of several packings.
struct PackingFit {
  SearchSample best; ///< with the mean of their residuals
  FitScatter scatter;
};

/// A search with one packing finds what suits that packing. Makes runs at its
/// best place with all packings, goes one Gauss-Newton step to where the mean
/// of their residuals is least, and makes them again there; if that is worse it
/// stays. What each packing alone would move the place by is the scatter.
/// Packings with which a run fails are left out.
PackingFit fit_mean_of_packings(CalibrationRuns &runs,
                                const SearchSample &best,
                                const Eigen::MatrixXd &jacobian,
                                unsigned packings);
} // namespace tamp::apps

#endif
