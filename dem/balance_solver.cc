// SPDX-License-Identifier: BSD-3-Clause
#include <dem/balance_solver.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseLU>

namespace tamp::dem
{
namespace
{
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Columns = Eigen::MatrixXd;

/// False at the first column that needs too many iterations.
template <class Solver>
bool iterate(Solver &&solver,
             const Matrix &matrix,
             const Columns &right_side,
             const Eigen::VectorXd &accuracy,
             Columns &x)
{
  constexpr int most_iterations = 1000;
  solver.setMaxIterations(most_iterations);
  solver.compute(matrix);
  for (Eigen::Index k = 0; k < right_side.cols(); ++k) {
    const double size = right_side.col(k).norm();
    if (size <= accuracy[k])
      continue; // rest is good enough
    solver.setTolerance(accuracy[k] / size);
    x.col(k) = solver.solve(right_side.col(k));
    if (solver.info() != Eigen::Success)
      return false;
  }
  return true;
}
} // namespace

std::optional<Columns> solve_balance(const Matrix &matrix,
                                     const Columns &right_side,
                                     bool symmetric,
                                     const Eigen::VectorXd &accuracy)
{
  Columns x = Columns::Zero(right_side.rows(), right_side.cols());
  const bool found =
      symmetric
          ? iterate(
                Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper>{},
                matrix,
                right_side,
                accuracy,
                x)
          : iterate(Eigen::BiCGSTAB<Matrix>{}, matrix, right_side, accuracy, x);
  if (found)
    return x;
  const Eigen::SparseMatrix<double> by_columns = matrix;
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(by_columns);
  if (factors.info() != Eigen::Success)
    return {};
  x = factors.solve(right_side);
  const Columns residual = matrix * x - right_side;
  for (Eigen::Index k = 0; k < x.cols(); ++k)
    if (!(residual.col(k).norm() <= accuracy[k])) // not a number, too
      return {};
  return x;
}
} // namespace tamp::dem
