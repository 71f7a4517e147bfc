// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_law_courses_h
#define apps_fit_law_courses_h

#include <apps/fit/cap_fit.h>
#include <fem/material_points.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// A density on a path, and what the probe found there.
struct CourseStop {
  double relative_density = 0; ///< under load [-]
  std::optional<StressPoint> stress;
  std::vector<StressPoint> yields;
  std::vector<ModuliPoint> moduli;
};

/// The main path of a probe as a law is asked to follow it.
struct Course {
  Loading loading = Loading::uniaxial;
  std::vector<CourseStop> stops; ///< increasing in density
};

/// Drives a law along a course, from its initial state; tells each stop and
/// the state of the law there. False if the law failed on its way.
template <class Law, class Visit>
bool follow(const Law &law, const Course &course, Visit visit)
{
  constexpr double largest_increment = 1e-2;
  auto state = law.initial_state();
  for (const CourseStop &stop : course.stops) {
    const double strain =
        std::log(stop.relative_density / state.relative_density);
    const auto steps = static_cast<unsigned>(
        std::ceil(std::max(1., std::abs(strain) / largest_increment)));
    dealii::Tensor<2, 3> F = dealii::unit_symmetric_tensor<3>();
    const bool isotropic = course.loading == Loading::isotropic;
    for (unsigned axis = isotropic ? 0 : 2; axis < 3; ++axis)
      F[axis][axis] = std::exp(-strain / steps / (isotropic ? 3 : 1));
    for (unsigned i = 0; i < steps; ++i) {
      const auto old = state;
      if (law.respond(old, state, {F}, fem::Want::stress).status ==
          fem::Status::failed)
        return false;
    }
    visit(stop, state);
  }
  return true;
}

/// Which part of the data a fit uses: the ordinal of folders of one loading,
/// and the number of a replica in them.
using ReplicaOfProbes = std::pair<std::size_t, int>;

/// The state on the main path of a probe, linear between its states.
StressPoint stress_at(const ProbeData &probe, double relative_density);

/// The data of probes as courses, between the first and the last density of
/// their scans.
class Courses
{
public:
  /// Throws InputError if there are scans of fewer than three densities.
  ///  probes  have to outlive this.
  Courses(const std::vector<ProbeData> &probes, YieldCriterion criterion);

  std::vector<ReplicaOfProbes> replicas() const;
  ///  only  one replica, or null for all
  std::vector<Course> courses(const ReplicaOfProbes *only) const;
  double first_density() const { return first_; }
  double last_density() const { return last_; }

private:
  std::size_t ordinal(std::size_t number) const;
  Course course(const ProbeData &probe, const ReplicaOfProbes *only) const;

  const std::vector<ProbeData> &probes_;
  YieldCriterion criterion_;
  double first_ = 0, last_ = 0;
};
} // namespace tamp::apps

#endif
