// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_balance_solver_h
#define dem_balance_solver_h

#include <Eigen/SparseCore>

#include <optional>

namespace tamp::dem
{
/// Solves matrix . x = right_side for all columns: by iteration, which takes
/// 100 to 300 products with the matrix where a packing is stable, and by a
/// factorisation if that fails (200 grains: 30 ms, 1000 grains: 1 s).
/// @param symmetric  whether the matrix is symmetric
/// @param accuracy   largest |matrix . x - right_side| of a column
/// @return empty if neither is accurate
[[nodiscard]] std::optional<Eigen::MatrixXd>
solve_balance(const Eigen::SparseMatrix<double, Eigen::RowMajor> &matrix,
              const Eigen::MatrixXd &right_side,
              bool symmetric,
              const Eigen::VectorXd &accuracy);
} // namespace tamp::dem

#endif
