// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_press_system_h
#define fem_press_system_h

#include <fem/assembler.h>
#include <fem/friction.h>
#include <fem/linear_solver.h>
#include <fem/mesh.h>
#include <fem/ranks.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace tamp::fem
{
/// Unknowns of compact and tools in one vector: the degrees of freedom of all
/// nodes, then the displacement along z of each tool. The core goes with the
/// die.
inline std::size_t number_of_unknowns(const Mesh &mesh)
{
  return mesh.number_of_dofs() + number_of_tools;
}
inline std::size_t tool_dof(const Mesh &mesh, unsigned tool)
{
  return mesh.number_of_dofs() + (tool == core_rod ? die_wall : tool);
}

/// The contact of a node with a tool as it enters the equations.
struct ContactBlock {
  unsigned node = 0, tool = 0;
  ContactStatus status = ContactStatus::open;
  dealii::Tensor<2, 3> stiffness; ///< - d force / d position of the node [N/m]
  double secant = 0; ///< friction over slip in the increment, if it slips [N/m]
};

/// The linear equations of the compact between its tools. The matrix holds the
/// nodes alone; tools that are loaded border it: they cost a solution each, and
/// multigrid sees nodes only.
class PressSystem
{
public:
  /// @param assembler  of this rank's cells. Mesh must outlive the object.
  PressSystem(const Mesh &mesh,
              const Assembler &assembler,
              const LinearSettings &settings,
              const Ranks &ranks);

  /// Zero where a displacement is given: held nodes, tools that are not loaded.
  std::vector<char>
  free_unknowns(const std::array<bool, number_of_tools> &loaded) const;

  /// Makes the equations of these contacts; keeps the factors if little has
  /// changed since: an iteration that looks at its residual gets there all the
  /// same, in cheaper steps. @param stiffness  of the powder, this rank's part
  /// [N/m]. False if the equations are singular. Collective.
  [[nodiscard]] bool factorise(const SparseRows &stiffness,
                               const std::vector<ContactBlock> &contacts,
                               const std::array<bool, number_of_tools> &loaded);

  /// The powder's stiffness has changed: the factors are of no use.
  void forget_factors() { factored_ = false; }

  /// Solves for a change of all unknowns; zero where it is given. Collective.
  [[nodiscard]] bool solve(std::span<const double> right,
                           std::span<double> change);

  /// Stiffness times a change of the nodes, summed over the ranks [N].
  std::vector<double> multiply_powder(const SparseRows &stiffness,
                                      std::span<const double> change) const;

private:
  void fill(const SparseRows &stiffness,
            const std::vector<ContactBlock> &contacts);
  bool border(const std::vector<ContactBlock> &contacts);

  const Mesh &mesh_;
  Ranks ranks_;
  SparseRows matrix_;
  std::vector<char> held_;  ///< per degree of freedom
  std::vector<char> owned_; ///< this rank adds what stands at a node once
  LinearSolver solver_;
  std::vector<ContactBlock> contacts_; ///< of the factors
  std::array<bool, number_of_tools> loaded_{};
  bool factored_ = false;
  /// Of the upper punch, the lower punch and the die: K^-1 times the column,
  /// and the row. Empty if not loaded.
  std::array<std::vector<double>, 3> answers_, rows_;
  dealii::Tensor<2, 3> inverse_schur_;
};
} // namespace tamp::fem

#endif
