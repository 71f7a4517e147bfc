// SPDX-License-Identifier: BSD-3-Clause
#include <fem/anderson.h>
#include <fem/linear_solver.h>
#include <tests/fem/elastic_block.h>
#include <tests/fem/solver_cases.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tamp::fem
{
namespace
{
/// A full, unsymmetric, well conditioned matrix of size n.
SparseRows full_matrix(int n)
{
  std::vector<std::set<int>> columns(n);
  for (auto &row : columns)
    for (int column = 0; column < n; ++column)
      row.insert(column);
  SparseRows matrix(columns);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      matrix.at(row, column) =
          std::sin(row + 2. * column) + (row == column) * n;
  return matrix;
}

double distance(const std::vector<double> &a, const std::vector<double> &b)
{
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}
double largest(const std::vector<double> &values)
{
  return distance(values, std::vector<double>(values.size(), 0.));
}

class LinearSolvers : public testing::TestWithParam<LinearSettings>
{
};
INSTANTIATE_TEST_SUITE_P(All,
                         LinearSolvers,
                         test::all_solvers(),
                         test::solver_name);
} // namespace

TEST_P(LinearSolvers, SolveUnsymmetricSystems)
{
  const SparseRows matrix = full_matrix(7);
  const std::vector<double> exact = {1, -2, 3, -4, 5, -6, 7};
  std::vector<double> solution(7);
  LinearSolver solver(matrix, GetParam());
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(multiply(matrix, exact), solution));
  // rounding; or the iteration's tolerance, 1e-9 of numbers near 10
  EXPECT_LT(distance(solution, exact),
            test::is_direct(GetParam()) ? 1e-13 : 1e-7);
}

TEST_P(LinearSolvers, SolveSymmetricSystemsThatAreNotDefinite)
{
  const test::ElasticBlock block{{5, 5, 5}};
  SparseRows matrix = test::stiffness(block);
  for (int row = 0; row < matrix.size(); ++row)
    matrix.at(row, row) -= 0.1; // the lowest eigenvalue is near 0.02
  std::vector<double> exact = test::forces(block), solution(exact.size());
  LinearSolver solver(matrix, GetParam(), Ranks(), test::rigid_modes(block));
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(multiply(matrix, exact), solution));
  // the iteration's tolerance 1e-9 over the eigenvalue nearest to zero
  EXPECT_LT(distance(solution, exact), 1e-5);
}

TEST_P(LinearSolvers, AnswerDoesNotDependOnEarlierMatrices)
{
  const test::ElasticBlock block{{4, 4, 4}, 1e2, 0.2};
  const SparseRows matrix = test::stiffness(block);
  const auto modes = test::rigid_modes(block);
  const std::vector<double> right = test::forces(block);
  std::vector<double> fresh(right.size()), used(fresh), ignored(fresh);
  LinearSolver first(matrix, GetParam(), Ranks(), modes);
  LinearSolver second(matrix, GetParam(), Ranks(), modes);
  ASSERT_TRUE(first.factorise(matrix.value));
  ASSERT_TRUE(first.solve(right, fresh));
  std::vector<double> other = matrix.value;
  for (std::size_t i = 0; i < other.size(); ++i)
    other[i] *= 1 + 1e-3 * std::cos(3. * static_cast<double>(i));
  ASSERT_TRUE(second.factorise(other));
  ASSERT_TRUE(second.solve(right, ignored));
  ASSERT_NE(fresh, ignored);
  ASSERT_TRUE(second.factorise(matrix.value));
  ASSERT_TRUE(second.solve(right, used));
  EXPECT_EQ(fresh, used);
}

TEST_P(LinearSolvers, RefuseWhatHasNoSolution)
{
  const SparseRows matrix = full_matrix(3);
  LinearSolver solver(matrix, GetParam());
  std::vector<double> values = matrix.value;
  values[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solver.factorise(values));
  std::vector<double> right(3, 1.), solution(3, 5.);
  EXPECT_FALSE(solver.solve(right, solution));
  const std::vector<double> zero(values.size(), 0.);
  EXPECT_FALSE(solver.factorise(zero) && solver.solve(right, solution));
  // two equal rows, and a right side that contradicts
  values = {1, 2, 3, 1, 2, 3, 2, 1, 5};
  right[1] = 2;
  EXPECT_FALSE(solver.factorise(values) && solver.solve(right, solution));
  EXPECT_EQ(solution, std::vector<double>(3, 5.)) << "a failure must not write";
  // and works again afterwards
  ASSERT_TRUE(solver.factorise(matrix.value));
  EXPECT_TRUE(solver.solve(right, solution));
  right[1] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(solver.solve(right, solution));
}

TEST_P(LinearSolvers, NoForcesMoveNothing)
{
  const SparseRows matrix = full_matrix(3);
  LinearSolver solver(matrix, GetParam());
  std::vector<double> solution(3, 5.);
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(std::vector<double>(3, 0.), solution));
  EXPECT_EQ(largest(solution), 0);
}

TEST_P(LinearSolvers, FindTheSolutionOfAStifflyHeldBlock)
{
  // Springs 1e4 times as stiff as the material, which slips along them.
  const test::ElasticBlock block{{8, 8, 10}, 1e4, 0.2};
  const SparseRows matrix = test::stiffness(block);
  const std::vector<double> right = test::forces(block);
  std::vector<double> solution(right.size());
  LinearSolver solver(matrix, GetParam(), Ranks(), test::rigid_modes(block));
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(right, solution));
  // the iteration's tolerance, 1e-9, of the norm: forces of size 1 on 2430
  EXPECT_LT(distance(multiply(matrix, solution), right), 1e-7);
}

TEST_P(LinearSolvers, TakeFewIterations)
{
  constexpr unsigned few = 60; // a smoother alone takes hundreds
  const bool direct = test::is_direct(GetParam());
  for (const double friction : {0., 0.5})
    for (const double penalty : {0., 1e4}) {
      const test::ElasticBlock block{{4, 4, 24}, penalty, friction};
      const SparseRows matrix = test::stiffness(block);
      const std::vector<double> right = test::forces(block);
      std::vector<double> solution(right.size());
      LinearSolver solver(
          matrix, GetParam(), Ranks(), test::rigid_modes(block));
      ASSERT_TRUE(solver.factorise(matrix.value));
      ASSERT_TRUE(solver.solve(right, solution));
      EXPECT_LT(direct ? 0 : 1, solver.iterations());
      EXPECT_LT(solver.iterations(), direct ? 2 : few) << penalty;
    }
}

TEST(LinearSolver, AdmitsThatItsIterationDidNotConverge)
{
  const test::ElasticBlock block{{4, 4, 8}, 0., 0.};
  const SparseRows matrix = test::stiffness(block);
  const std::vector<double> right = test::forces(block);
  std::vector<double> solution(right.size());
  for (const LinearAlgebra algebra :
       {LinearAlgebra::petsc, LinearAlgebra::trilinos}) {
    LinearSettings settings{algebra, LinearMethod::iterative};
    settings.maximum_iterations = 3;
    LinearSolver solver(matrix, settings, Ranks(), test::rigid_modes(block));
    ASSERT_TRUE(solver.factorise(matrix.value));
    EXPECT_FALSE(solver.solve(right, solution));
  }
}

TEST(Anderson, SolvesALinearFixedPointInAsManyStepsAsUnknowns)
{
  // G(u) = u - (A u - b) / 9 with a matrix whose fixed point iteration is slow.
  const int n = 4;
  const SparseRows matrix = full_matrix(n);
  const std::vector<double> exact = {1, 2, -1, 3};
  const std::vector<double> right = multiply(matrix, exact);
  std::vector<double> u(n, 0.);
  Anderson anderson(n);
  for (int iteration = 0; iteration < n + 2; ++iteration) {
    std::vector<double> g = multiply(matrix, u);
    for (int i = 0; i < n; ++i)
      g[i] = (right[i] - g[i]) / 9;
    u = anderson.next(u, g);
  }
  EXPECT_LT(distance(u, exact), 1e-9);
}
} // namespace tamp::fem
