// SPDX-License-Identifier: BSD-3-Clause
#include <fem/anderson.h>
#include <fem/linear_solver.h>

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
} // namespace

TEST(LinearSolver, SolvesUnsymmetricSystems)
{
  const SparseRows matrix = full_matrix(7);
  const std::vector<double> exact = {1, -2, 3, -4, 5, -6, 7};
  std::vector<double> solution(7);
  LinearSolver solver(matrix);
  ASSERT_TRUE(solver.factorise(matrix.value));
  ASSERT_TRUE(solver.solve(multiply(matrix, exact), solution));
  EXPECT_LT(distance(solution, exact), 1e-13);
}

TEST(LinearSolver, AnswerDoesNotDependOnEarlierMatrices)
{
  const SparseRows matrix = full_matrix(7);
  const std::vector<double> right = {1, 2, 3, 4, 5, 6, 7};
  std::vector<double> fresh(7), used(7), ignored(7);
  LinearSolver first(matrix), second(matrix);
  ASSERT_TRUE(first.factorise(matrix.value));
  ASSERT_TRUE(first.solve(right, fresh));
  std::vector<double> other = matrix.value;
  for (std::size_t i = 0; i < other.size(); ++i)
    other[i] += std::cos(3. * i);
  ASSERT_TRUE(second.factorise(other));
  ASSERT_TRUE(second.solve(right, ignored));
  ASSERT_TRUE(second.factorise(matrix.value));
  ASSERT_TRUE(second.solve(right, used));
  EXPECT_EQ(fresh, used);
}

TEST(LinearSolver, RefusesWhatHasNoSolution)
{
  const SparseRows matrix = full_matrix(3);
  LinearSolver solver(matrix);
  std::vector<double> values = matrix.value;
  values[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solver.factorise(values));
  const std::vector<double> zero(values.size(), 0.), right(3, 1.);
  std::vector<double> solution(3);
  EXPECT_FALSE(solver.factorise(zero) && solver.solve(right, solution));
  // and works again afterwards
  ASSERT_TRUE(solver.factorise(matrix.value));
  EXPECT_TRUE(solver.solve(right, solution));
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
