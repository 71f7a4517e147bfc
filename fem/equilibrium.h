// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_equilibrium_h
#define fem_equilibrium_h

#include <fem/die_mesh_data.h>
#include <fem/kinematics.h>
#include <fem/material_points.h>
#include <fem/sparse_rows.h>
#include <fem/tool_contact.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tamp::fem
{
/// The compact after an accepted step.
struct CompactState {
  NodePositions positions; ///< [m]
  std::vector<Response> responses;
  std::vector<dealii::Tensor<2, 3>> deformation_gradients; ///< since the start
  std::vector<double> wall_friction; ///< on powder, upwards, per wall node [N]
  ToolForces forces;
};

/// What became of an attempt to find equilibrium.
struct Attempt {
  bool converged = false;
  std::string reason;      ///< why not
  std::size_t point = 0;   ///< where it went wrong, or the residual is largest
  unsigned iterations = 0; ///< evaluations of all points
  double force_residual = 0;      ///< / reactions [-]
  double displacement_change = 0; ///< / largest of a usual step [-]
  std::size_t doubtful_points = 0;
  ToolForces forces;
};

/// Seconds spent, by part.
struct SolverTimes {
  double material = 0, assembly = 0, linear_solver = 0;
};

/// Finds the displacement of an increment that balances powder and tools, and
/// keeps the accepted state. Each iteration evaluates all material points once
/// and then balances their linearised forces with the tools at no material
/// cost; with Anderson acceleration over these iterations if the tangent is
/// kept.
class Equilibrium
{
public:
  /// Evaluates the points once, undeformed. Mesh and points must outlive the
  /// object. @param largest_increment  of a point's deformation in a step; an
  /// iteration that goes further is shortened [-].
  Equilibrium(const DieMesh::Data &mesh,
              MaterialPoints &points,
              double wall_friction_coefficient,
              const SolverSettings &settings,
              double largest_increment);

  const CompactState &state() const { return state_; }

  /// Searches equilibrium for this motion of the punches from the accepted
  /// state on. Changes nothing accepted. @param guess  of the increment; what
  /// the tools prescribe is put in. @param guard  refuse states that open.
  [[nodiscard]] Attempt
  attempt(const PunchMotion &motion, const Displacement &guess, bool guard);

  /// Commits the last attempt, which must have converged, to state and points.
  void accept();

  /// Increment of displacement of the last attempt [m].
  const Displacement &increment() const { return trial_.increment; }

  unsigned evaluations() const { return evaluations_; }
  const SolverTimes &times() const { return times_; }

private:
  struct Trial {
    Displacement increment;
    NodePositions positions;
    std::vector<Deformation> deformations;
    std::vector<Response> responses;
    std::vector<double> internal; ///< forces per degree of freedom [N]
    ToolForces forces;
  };

  bool is_newton() const { return settings_.method == NonlinearMethod::newton; }
  /// |upper - lower - wall friction| over the largest force of a tool [-].
  double tool_imbalance() const;
  double reference_force() const;
  bool update_forces(const PunchMotion &motion, Attempt &attempt);
  std::vector<double> balance_linearised(Attempt &attempt);
  bool deform(Attempt &attempt);
  bool evaluate(Want want, Attempt &attempt);
  bool opens(Attempt &attempt) const;
  void shorten(const Displacement &from, Displacement &to) const;
  std::size_t point_of_largest(const std::vector<double> &imbalance) const;

  const DieMesh::Data &mesh_;
  MaterialPoints &points_;
  SolverSettings settings_;
  double largest_increment_;
  ToolContact contact_;
  SparseRows stiffness_;
  CompactState state_;
  Trial trial_;
  double peak_reactions_ = 0;
  unsigned evaluations_ = 0;
  SolverTimes times_;
};
} // namespace tamp::fem

#endif
