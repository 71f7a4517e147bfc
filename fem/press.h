// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_press_h
#define fem_press_h

#include <fem/compact.h>
#include <fem/die_settings.h>
#include <fem/press_system.h>
#include <fem/state_bytes.h>
#include <fem/tool_contact.h>
#include <fem/tool_motion.h>
#include <fem/work_account.h>

#include <array>
#include <span>
#include <vector>

namespace tamp::fem
{
/// Displacements of all nodes and tools in an increment, see
/// number_of_unknowns() [m].
using Increment = std::vector<double>;

/// Seconds spent, by part.
struct PressTimes {
  double material = 0, assembly = 0, contact = 0, linear_solver = 0;
};

/// Powder and tools: the accepted state, and a trial with the forces of both.
/// What is unbalanced between them, and the linear equations that say how to
/// balance it. Whoever searches equilibrium does it with this.
class Press
{
public:
  /// All must outlive the object.
  Press(const Mesh &mesh,
        const Tools &tools,
        MaterialPoints &points,
        const SolverSettings &settings,
        const Ranks &ranks);

  const Mesh &mesh() const { return compact_.mesh(); }
  const Ranks &ranks() const { return compact_.ranks(); }
  const Compact &compact() const { return compact_; }
  const ToolContact &contact() const { return contact_; }
  const ToolPositions &tools() const { return tools_; } ///< accepted
  /// Accepted forces of the tools, of the mesh's part of the compact.
  const ToolForces &forces() const { return forces_; }
  /// Work of all accepted increments, of the whole compact.
  const WorkAccount &work() const { return work_; }

  /// Begins an attempt at this motion: the first trial, with tangent and
  /// contact stiffness. @param increment  a guess, in which the motion of the
  /// tools is put.
  [[nodiscard]] Fault begin(const Motion &motion, Increment &increment);

  /// The next trial.
  [[nodiscard]] Fault move(const Increment &increment, Want want);
  /// Stiffness of the powder in the trial, which must have been moved to with
  /// the tangent.
  void assemble_stiffness();

  /// Unbalanced force of every unknown of the trial [N]; zero where a
  /// displacement is given.
  std::vector<double> imbalance() const;
  /// Norm of all nodes' contact forces in the trial, at least a small share of
  /// the largest so far [N].
  double reference_force() const;
  /// Unbalanced force of the tools over the largest of them [-].
  double tool_imbalance() const;
  /// Work of the powder's forces in the trial on an increment [J].
  double work_of_powder(const Increment &increment) const;
  ToolForces trial_forces() const { return contact_.sums(pair_forces_); }

  /// The change that balances the tools with a powder that answers linearly: a
  /// semi-smooth Newton iteration over open, stick and slip at no material
  /// cost, to 1e-9 of the reactions or as far as it goes; contact is exact: no
  /// node is inside a tool. The normal forces that it ends with are those of
  /// the next trial. Empty: no balance.
  std::vector<double> balance_tools(const Increment &increment);

  /// Multipliers become what balances the powder of the trial.
  void take_reactions();

  /// The trial becomes the accepted state.
  void accept();

  /// Appends the accepted state, on the first rank; unpack() takes it up, on
  /// any number of ranks, from the same bytes on each. Collective. Throws
  /// std::runtime_error if it is that of another mesh.
  void pack(std::vector<char> &bytes) const;
  void unpack(StateBytes &bytes);

  const PressTimes &times() const { return times_; }

private:
  /// The powder's part of a trial, then the tools'.
  Fault move_powder(const Increment &increment, Want want);
  void meet_tools(const Increment &increment);
  struct Balance;
  Balance balance_after(const std::vector<double> &change,
                        std::vector<double> internal,
                        const Increment &increment) const;
  std::vector<ContactBlock> contact_blocks(const std::vector<PairForce> &forces,
                                           const NodePositions &positions,
                                           const ToolPositions &tools) const;
  std::vector<double> imbalance_of(std::span<const double> internal,
                                   const std::vector<PairForce> &forces) const;
  bool advance_balance(Balance &now, const Increment &increment);
  double reference_of(const Balance &balance) const;
  bool is_exact(const Balance &balance) const;
  void snap(Balance &balance) const;
  ToolPositions tools_after(std::span<const double> increment) const;
  std::vector<double> node_stiffness() const;
  std::vector<double> node_densities() const;
  template <class Self, class Use>
  static void each_part(Self &self, const Use &use);

  Compact compact_;
  ToolContact contact_;
  PressSystem system_;
  SparseRows stiffness_;
  Motion motion_{};
  std::array<bool, number_of_tools> loaded_{};
  std::vector<char> free_;
  ToolPositions tools_{}, trial_tools_{};
  ToolForces forces_;
  WorkAccount work_;
  std::vector<double> internal_;
  std::vector<PairForce> pair_forces_;
  double least_reaction_; ///< share of the peak
  double peak_reactions_ = 0;
  PressTimes times_;
};
} // namespace tamp::fem

#endif
