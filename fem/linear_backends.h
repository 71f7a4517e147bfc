// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_linear_backends_h
#define fem_linear_backends_h

#include <fem/linear_solver.h>

#include <memory>
#include <span>
#include <vector>

namespace tamp::fem
{
/// What a library is told about the system before it sees values.
struct LinearSystem {
  SparseRows pattern; ///< of this rank's entries; values mean nothing
  LinearSettings settings;
  Ranks ranks;
  unsigned block = 1; ///< unknowns of a node, numbered one after another
  Share rows;         ///< of this rank; whole blocks
  /// Displacements of rigid bodies in all rows, orthonormal.
  std::vector<std::vector<double>> rigid_modes;
};

/// A library that solves. It sees finite values only, and answers for this
/// rank's rows; what it returns may differ between ranks.
struct LinearSolver::Backend {
  virtual ~Backend() = default;
  /// False if it found the matrix singular.
  /// @param symmetric  the matrix is; an iteration may use it.
  virtual bool factorise(std::span<const double> values, bool symmetric) = 0;
  /// Right side and solution in this rank's rows.
  virtual bool solve(std::span<const double> right_side,
                     std::span<double> solution) = 0;
  virtual unsigned iterations() const = 0; ///< of the last solve()
};

// The system must outlive the backend.
std::unique_ptr<LinearSolver::Backend> petsc_direct(const LinearSystem &system);
std::unique_ptr<LinearSolver::Backend>
petsc_multigrid(const LinearSystem &system);
std::unique_ptr<LinearSolver::Backend>
trilinos_direct(const LinearSystem &system);
std::unique_ptr<LinearSolver::Backend>
trilinos_multigrid(const LinearSystem &system);
} // namespace tamp::fem

#endif
