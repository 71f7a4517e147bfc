// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_linear_solver_h
#define fem_linear_solver_h

#include <fem/sparse_rows.h>

#include <memory>
#include <span>
#include <vector>

namespace tamp::fem
{
/// Sparse direct solution of unsymmetric systems with PETSc and MUMPS, on this
/// rank alone. The answer depends on the matrix only, not on the ones before.
class LinearSolver
{
public:
  /// Takes the pattern of `matrix`, whose values may still be anything.
  explicit LinearSolver(const SparseRows &matrix);
  ~LinearSolver();

  /// Factorises; the pattern must be that of the constructor. False if the
  /// matrix is singular or has a value that is not finite.
  [[nodiscard]] bool factorise(std::span<const double> values);

  /// Solves with the factors, which the last factorise() must have found. False
  /// if the answer is not finite.
  [[nodiscard]] bool solve(std::span<const double> right_side,
                           std::span<double> solution);

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace tamp::fem

#endif
