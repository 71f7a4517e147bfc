// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_linear_solver_h
#define fem_linear_solver_h

#include <fem/ranks.h>
#include <fem/sparse_rows.h>

#include <memory>
#include <span>
#include <vector>

namespace tamp::fem
{
enum class LinearAlgebra { petsc, trilinos };
enum class LinearMethod {
  automatic, ///< iterative in three dimensions above 20000 unknowns
  direct,    ///< MUMPS
  iterative  ///< Krylov with algebraic multigrid
};

struct LinearSettings {
  LinearAlgebra algebra = LinearAlgebra::petsc;
  LinearMethod method = LinearMethod::automatic;
  double tolerance = 1e-9; ///< of the residual / right side, iterative [-]
  unsigned maximum_iterations = 500;
};

/// Solves sparse unsymmetric systems on all ranks. The system is given as sums:
/// each rank holds entries of its cells, entries of several ranks add up. Right
/// sides and solutions are held by every rank in full. The answer depends on
/// the matrix only, not on the ones before; MUMPS on several ranks rounds
/// differently from run to run. All functions are collective and answer the
/// same bits on every rank.
class LinearSolver
{
public:
  /// Takes the pattern of this rank's `matrix`, whose values may be anything.
  /// Rows and columns are numbered alike on all ranks.
  /// @param rigid_modes  displacements of rigid bodies, of the system's length
  ///                     each: what multigrid must know. It works best if
  ///                     all components of a node are unknowns, numbered
  ///                     one after another. Empty: none.
  explicit LinearSolver(const SparseRows &matrix,
                        const LinearSettings &settings = {},
                        const Ranks &ranks = Ranks(),
                        std::vector<std::vector<double>> rigid_modes = {});
  ~LinearSolver();

  /// Factorises, or sets up the preconditioner; the pattern must be that of the
  /// constructor. False if the matrix is found to be singular (an
  /// iteration finds it in solve() only) or has a value that is not finite.
  [[nodiscard]] bool factorise(std::span<const double> values);

  /// Solves with what the last factorise() found. False if the answer is not
  /// finite or the iteration did not reach its tolerance.
  [[nodiscard]] bool solve(std::span<const double> right_side,
                           std::span<double> solution);

  /// Of the last solve() [-]; 1 for a direct method.
  unsigned iterations() const;

  struct Backend; ///< one of the libraries: fem/linear_backends.h

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace tamp::fem

#endif
