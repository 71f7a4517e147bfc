// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_curve_targets_h
#define apps_calibrate_curve_targets_h

#include <apps/calibrate/compaction_curve.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What a value of a measured curve is, and where it stands.
enum class TargetKind {
  loading_axial,    ///< axial pressure at a relative density
  loading_lateral,  ///< lateral pressure there
  unloading_strain, ///< recovered axial strain, ln(peak density / density), at
                    ///< a share of the peak pressure
  unloading_lateral ///< lateral over peak axial pressure there
};

/// A measured value; what a simulation has instead of it is off by
/// (simulated - value) / scale.
struct CurveTarget {
  TargetKind kind = TargetKind::loading_axial;
  double place = 0; ///< relative density, or share of the peak pressure [-]
  double value = 0; ///< [Pa] in loading, [-] in unloading
  double scale = 1;
};

/// What simulations are compared with. In loading the scale of a pressure is
/// that pressure, but a hundredth of the largest one at least: all decades
/// count alike. Unloading is seen from each curve's own peak: what loading
/// misses is not counted twice; the scale of recovered strain is that at the
/// end, that of lateral pressure as in loading. All values have the same
/// weight.
class CurveTargets
{
public:
  /// Values below the density that simulations start from, and in unloading
  /// below 5 % of the peak pressure, are left out, and counted. Throws
  /// std::invalid_argument if fewer than five are left in loading.
  CurveTargets(const CompactionCurve &measured, double start_density);

  const std::vector<CurveTarget> &all() const { return targets_; }
  std::size_t left_out() const { return left_out_; }
  double largest_density() const { return largest_density_; }
  /// To which simulations are to be unloaded [-]; 0: not at all.
  double lowest_share() const { return lowest_share_; }

  /// What a simulated curve has at the places of the targets; none if it does
  /// not get there.
  std::optional<std::vector<double>>
  simulated(const CompactionCurve &curve) const;
  /// The same as (simulated - measured) / scale.
  std::optional<std::vector<double>>
  residuals(const CompactionCurve &curve) const;
  /// How far a curve comes that does not get there, and how far it should, in
  /// words.
  std::string reach(const CompactionCurve &curve) const;

private:
  void take_loading(const CompactionCurve &measured, double start_density);
  void take_unloading(const CompactionCurve &measured);

  std::vector<CurveTarget> targets_;
  std::size_t left_out_ = 0;
  double largest_density_ = 0, lowest_share_ = 0;
};

/// Root of the mean square [-].
double misfit_of(std::span<const double> residuals);
} // namespace tamp::apps

#endif
