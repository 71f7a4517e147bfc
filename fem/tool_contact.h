// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_tool_contact_h
#define fem_tool_contact_h

#include <fem/die_mesh_data.h>
#include <fem/kinematics.h>
#include <fem/linear_solver.h>
#include <fem/sparse_rows.h>
#include <fem/wall_friction.h>

#include <memory>
#include <span>
#include <vector>

namespace tamp::fem
{
/// How the punches move during an increment. The lower punch is always moved;
/// the upper one is moved or loaded.
struct PunchMotion {
  bool upper_is_loaded = false;
  /// Of the upper punch, upwards [m]; a first guess if it is loaded.
  double upper = 0;
  double upper_force = 0; ///< on a loaded upper punch, compressive [N]
  double lower = 0;       ///< of the lower punch, upwards [m]
};

/// Forces between powder and tools.
struct ToolForces {
  double upper = 0;           ///< powder on upper punch, upwards [N]
  double lower = 0;           ///< lower punch on powder, upwards [N]
  double wall_friction = 0;   ///< wall on powder, upwards [N]
  double wall_normal = 0;     ///< wall on powder, inwards [N]
  double reactions = 0;       ///< norm of all nodal reactions [N]
  std::vector<WallForce> wall; ///< per wall node
};

/// The rigid tools: a die wall with Coulomb friction, whose nodes stay at the
/// wall, two flat frictionless punches, and the axis. The nodes of the upper
/// punch share one vertical displacement, an unknown if the punch is loaded.
class ToolContact
{
public:
  /// @param mesh  must outlive the object.
  ToolContact(const DieMesh::Data &mesh, double friction_coefficient);
  ~ToolContact();

  /// Begins an increment. @param stiffness  of the powder, from which the
  /// stiffness of sticking contact is taken, three times the node's own [N/m].
  /// @param committed_friction  per wall node [N].
  void begin(const SparseRows &stiffness,
             const PunchMotion &motion,
             std::span<const double> committed_friction);

  /// Sets the degrees of freedom that the tools prescribe.
  void prescribe(const PunchMotion &motion, Displacement &increment) const;

  /// Forces for these internal forces and this increment.
  ToolForces forces(std::span<const double> internal,
                    std::span<const double> increment) const;

  /// Unbalanced force of every degree of freedom that is free [N]; zero where
  /// a tool prescribes the displacement. The balance of a loaded upper punch
  /// stands at its first node.
  std::vector<double> imbalance(std::span<const double> internal,
                                const ToolForces &forces) const;

  /// Balances powder and tools if the powder answers linearly: internal force +
  /// stiffness x change. A semi-smooth Newton iteration over stick and slip,
  /// to 1e-9 of the reactions. Returns the change of the increment; empty if
  /// no balance was found.
  std::vector<double> balance(const SparseRows &stiffness,
                              std::span<const double> internal,
                              std::span<const double> increment,
                              double smallest_reference);

  /// The powder's stiffness has changed: old factors are of no use.
  void forget_factors();

private:
  struct System; ///< the unknowns of one kind of control and their solver
  System &system() const;
  void fill(const SparseRows &stiffness,
            const std::vector<WallForce> &wall,
            System &system) const;
  bool prepare(const SparseRows &stiffness,
               const std::vector<WallForce> &wall,
               System &system);

  const DieMesh::Data &mesh_;
  double friction_coefficient_;
  PunchMotion motion_;
  std::vector<double> committed_friction_, stick_stiffness_;
  std::unique_ptr<System> moved_, loaded_;
};
} // namespace tamp::fem

#endif
