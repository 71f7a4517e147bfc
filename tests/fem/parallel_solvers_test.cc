// SPDX-License-Identifier: BSD-3-Clause
#include <fem/linear_solver.h>
#include <tests/fem/elastic_block.h>
#include <tests/fem/same_everywhere.h>
#include <tests/fem/solver_cases.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tamp::fem
{
namespace
{
double norm(const std::vector<double> &values)
{
  double sum = 0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum);
}

/// A block whose cells are shared out: nodes between them get a part of their
/// rows from each of several ranks.
class ParallelSolvers : public testing::TestWithParam<LinearSettings>
{
protected:
  /// By a direct solver that stands alone.
  std::vector<double> serial_solution(const std::vector<double> &right) const
  {
    const SparseRows whole = test::stiffness(block);
    LinearSolver solver(whole);
    std::vector<double> solution(right.size());
    EXPECT_TRUE(solver.factorise(whole.value));
    EXPECT_TRUE(solver.solve(right, solution));
    return solution;
  }

  void expect_solution(const std::vector<double> &solution,
                       const std::vector<double> &right) const
  {
    EXPECT_TRUE(test::same_everywhere(solution, ranks));
    std::vector<double> difference = serial_solution(right);
    const double size = norm(difference);
    for (std::size_t i = 0; i < difference.size(); ++i)
      difference[i] -= solution[i];
    // rounding, or the iteration's tolerance, times the condition
    EXPECT_LT(norm(difference) / size,
              test::is_direct(settings) ? 1e-10 : 1e-6);
  }

  const Ranks ranks = Ranks(MPI_COMM_WORLD);
  const test::ElasticBlock block{{5, 4, 6}, 1e4, 0.2};
  const SparseRows matrix =
      test::stiffness(block, ranks.share(block.cell_count()));
  const LinearSettings settings = GetParam();
};
INSTANTIATE_TEST_SUITE_P(All,
                         ParallelSolvers,
                         test::all_solvers(),
                         test::solver_name);
} // namespace

TEST_P(ParallelSolvers, AgreeWithASolverThatStandsAlone)
{
  const std::vector<double> right = test::forces(block);
  std::vector<double> solution(right.size());
  LinearSolver solver(matrix, settings, ranks, test::rigid_modes(block));
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(right, solution));
  expect_solution(solution, right);
}

TEST_P(ParallelSolvers, ForgetEarlierMatrices)
{
  const std::vector<double> right = test::forces(block);
  std::vector<double> solution(right.size());
  LinearSolver solver(matrix, settings, ranks, test::rigid_modes(block));
  std::vector<double> other = matrix.value;
  for (double &value : other)
    value *= 3;
  ASSERT_TRUE(solver.factorise(other));
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(right, solution));
  expect_solution(solution, right);
}

TEST_P(ParallelSolvers, AFailureOnOneRankIsAFailureEverywhere)
{
  const std::vector<double> right = test::forces(block);
  std::vector<double> solution(right.size());
  LinearSolver solver(matrix, settings, ranks, test::rigid_modes(block));
  std::vector<double> values = matrix.value;
  if (ranks.rank() + 1 == ranks.size())
    values[values.size() / 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solver.factorise(values));
  EXPECT_FALSE(solver.solve(right, solution));
  // Nothing at all: singular.
  values.assign(values.size(), 0.);
  EXPECT_FALSE(solver.factorise(values) && solver.solve(right, solution));
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(right, solution));
  expect_solution(solution, right);
}

TEST_P(ParallelSolvers, ARankWithoutEntriesTakesPart)
{
  const bool has_all = ranks.rank() + 1 == ranks.size();
  const SparseRows own =
      test::stiffness(block, has_all ? Share{0, block.cell_count()} : Share{});
  const std::vector<double> right = test::forces(block);
  std::vector<double> solution(right.size());
  LinearSolver solver(own, settings, ranks, test::rigid_modes(block));
  ASSERT_TRUE(solver.factorise(own.value));
  ASSERT_TRUE(solver.solve(right, solution));
  expect_solution(solution, right);
}

TEST_P(ParallelSolvers, ARankMayWorkAlone)
{
  // Each with its own system, at the same time.
  const Ranks alone;
  const test::ElasticBlock own{{2, 2, 2 + static_cast<int>(ranks.rank())}};
  const SparseRows K = test::stiffness(own);
  const std::vector<double> right = test::forces(own);
  std::vector<double> solution(right.size());
  LinearSolver solver(K, settings, alone, test::rigid_modes(own));
  ASSERT_TRUE(solver.factorise(K.value));
  ASSERT_TRUE(solver.solve(right, solution));
  std::vector<double> residual = multiply(K, solution);
  for (std::size_t i = 0; i < right.size(); ++i)
    residual[i] -= right[i];
  EXPECT_LT(norm(residual), 2e-9 * norm(right)); // the iteration's tolerance
}
} // namespace tamp::fem
