// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_cap_samples_h
#define apps_fit_cap_samples_h

#include <apps/fit/cap_fit.h>
#include <apps/fit/plastic_density.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// A powder has yielded once its plastic compaction is above this [-].
inline constexpr double yield_offset = 5e-4;

/// A density at which replicas were scanned.
struct SampleLevel {
  double density = 0;    ///< mean, of the unloaded powder [-]
  double half_width = 0; ///< scans so near count as here [-]
};

/// Probes sorted by replica: the first isotropic folder goes with the first
/// uniaxial one, and so on, and within folders the numbers of replicas with
/// each other.
class CapSamples
{
public:
  /// Throws InputError saying what is missing.
  CapSamples(const std::vector<ProbeData> &probes, YieldCriterion criterion);

  bool has(Loading loading) const { return !paths(loading).empty(); }
  bool has_moduli() const { return has_moduli_; }
  std::vector<const PlasticPath *> paths(Loading loading) const;
  /// The densities of all scans, increasing.
  std::vector<SampleLevel> levels() const;
  /// Mean and deviation over replicas, without p_b from isotropic paths; none
  /// if no replica has all that is needed.
  std::optional<CapLevel> fit(const SampleLevel &level);
  /// Mean and deviation of p_b over replicas.
  /// @param table  p_b over density, to compare densities that differ a little.
  void take_yield_pressure(Loading from,
                           const std::function<double(double)> &table,
                           CapLevel &level) const;
  /// E [Pa] and nu of the uniaxial paths at a density, also below that of
  /// scans.
  std::pair<double, double> elasticity(double density) const;
  /// Lines so far that were drawn through the origin for want of points.
  unsigned origin_lines() const { return origin_lines_; }

private:
  struct Probe {
    const ProbeData *data;
    std::size_t ordinal; ///< among those of its loading
    PathElasticity elasticity;
    PlasticPath path;
  };
  using Replica = std::pair<std::size_t, int>; ///< ordinal, number in folder

  /// What one replica tells at a level.
  struct Finding {
    CapValues values; ///< p_b is that of the uniaxial path
    ShearLine line;
    StressPoint uniaxial;
    double plastic_ratio = 0, rigid_eccentricity = 0;
    std::vector<StressPoint> shear_points, cap_points;
  };

  std::vector<Replica> replicas() const;
  const Probe &uniaxial_of(const Replica &replica) const;
  std::vector<StressPoint> points_of(const Replica &replica,
                                     const SampleLevel &level,
                                     YieldCriterion criterion) const;
  std::optional<Finding> find(const Replica &replica,
                              const SampleLevel &level) const;
  bool divide(const std::vector<StressPoint> &points, Finding &finding) const;
  void take_moduli(const Replica &replica,
                   const SampleLevel &level,
                   CapValues &values) const;
  double angle_by(YieldCriterion criterion, const SampleLevel &level) const;

  std::vector<Probe> probes_;
  YieldCriterion criterion_;
  bool has_moduli_ = false;
  unsigned origin_lines_ = 0;
};
} // namespace tamp::apps

#endif
