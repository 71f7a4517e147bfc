// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_plastic_density_h
#define apps_fit_plastic_density_h

#include <apps/fit/probe_data.h>

#include <vector>

namespace tamp::apps
{
/// Elastic moduli over relative density: powers of it between neighbouring rows
/// and beyond them. Rows of one density, such as those of replicas, count as
/// their mean.
class PathElasticity
{
public:
  /// @param rows      at least one, in any order.
  /// @param unloaded  their densities are those of the unloaded powder, which
  ///                  holds for other paths, too; else under load, on one path.
  explicit PathElasticity(std::vector<ModuliPoint> rows, bool unloaded = false);

  /// K and G at a density, of the kind of the rows [Pa].
  ModuliPoint at(double relative_density) const;
  /// K and G of a state of both densities [Pa].
  ModuliPoint at(double loaded, double unloaded) const
  {
    return at(unloaded_ ? unloaded : loaded);
  }
  double first_density() const { return rows_.front().relative_density; }
  double last_density() const { return rows_.back().relative_density; }

private:
  std::vector<ModuliPoint> rows_; ///< increasing in density
  bool unloaded_;
};

/// How pressure and deviatoric stress change along a path, and what of the
/// strain is plastic.
struct PathSlope {
  double pressure = 0;          ///< smoothed [Pa]
  double deviatoric_stress = 0; ///< smoothed [Pa]
  /// Plastic compaction over plastic shear, sqrt(2/3 de:de), of an increment
  /// without lateral strain [-]; 3/2 if lateral plastic strain is zero.
  double plastic_ratio = 0;
};

/// The main path of a probe, over the density that the powder would keep if it
/// were unloaded elastically: ln D_plastic = ln D - int dp / K(D). What stands
/// in the tables of continuum laws depends on that density.
class PlasticPath
{
public:
  struct Point {
    double density = 0; ///< unloaded [-]
    PathPoint state;
  };

  PlasticPath(const ProbeData &probe, const PathElasticity &elasticity);

  /// The states whose plastic compaction since the start is above `offset`: the
  /// powder has yielded there.
  std::vector<Point> yielded(double offset) const;
  /// The unloaded density where the density under load is D; beyond the path as
  /// at its nearest end.
  double unloaded(double relative_density) const;
  /// The reverse.
  double loaded(double density) const;
  double first_density() const { return points_.front().density; }
  double last_density() const { return points_.back().density; }
  /// The pressure where the unloaded density is this one [Pa].
  double pressure(double density) const;
  /// From a parabola through the states about an unloaded density: those
  /// nearer than `reach` in ln D, at least seven.
  PathSlope slope(double density, double reach = 0.015) const;

private:
  std::vector<Point> points_; ///< not decreasing in unloaded density
  PathElasticity elasticity_;
};
/// The moduli of a probe, if it has some, over the unloaded density of its
/// path: that depends on them in turn, and is found by repetition.
std::vector<ModuliPoint> unloaded_moduli(const ProbeData &probe);
} // namespace tamp::apps

#endif
