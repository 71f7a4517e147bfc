// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/elastic_block.h>

#include <cmath>

namespace tamp::fem::test
{
namespace
{
using Triple = std::array<int, 3>;
using CellMatrix = std::array<std::array<double, 24>, 24>;

Triple corner(int number)
{
  return {number & 1, (number >> 1) & 1, (number >> 2) & 1};
}

/// Gradient of a corner's shape function in the unit cube.
std::array<double, 3> gradient(int number, const std::array<double, 3> &x)
{
  const Triple at = corner(number);
  std::array<double, 3> result;
  for (int i = 0; i < 3; ++i) {
    result[i] = 1;
    for (int j = 0; j < 3; ++j)
      result[i] *= (i == j ? 1. : x[j]) * (at[j] == 1 ? 1. : -1.) +
                   (i == j || at[j] == 1 ? 0. : 1.);
  }
  return result;
}

void add_point(const std::array<double, 3> &x, CellMatrix &K)
{
  constexpr double lambda = 0.3 / (1.3 * 0.4), mu = 1 / 2.6, weight = 1 / 8.;
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b) {
      const auto p = gradient(a, x), q = gradient(b, x);
      const double dot = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          K[3 * a + i][3 * b + j] +=
              weight * (lambda * p[i] * q[j] + mu * p[j] * q[i] +
                        (i == j ? mu * dot : 0.));
    }
}

CellMatrix cell_stiffness()
{
  const double gauss[] = {0.5 - std::sqrt(1 / 12.), 0.5 + std::sqrt(1 / 12.)};
  CellMatrix K{};
  for (const double x : gauss)
    for (const double y : gauss)
      for (const double z : gauss)
        add_point({x, y, z}, K);
  return K;
}

Triple cell_at(const ElasticBlock &block, std::size_t cell)
{
  const int number = static_cast<int>(cell);
  const auto &n = block.cells;
  return {number % n[0], number / n[0] % n[1], number / n[0] / n[1]};
}

/// The first unknown of a cell's corner; negative if it is clamped.
int unknown(const ElasticBlock &block, const Triple &cell, int number)
{
  const Triple at = corner(number);
  const int x = cell[0] + at[0], y = cell[1] + at[1], z = cell[2] + at[2];
  const auto &n = block.cells;
  return z == 0 ? -1 : 3 * (x + (n[0] + 1) * (y + (n[1] + 1) * (z - 1)));
}

/// Calls act(row, column, row in the cell, column in the cell).
template <class Act>
void for_entries(const ElasticBlock &block, const Triple &cell, Act act)
{
  for (int a = 0; a < 24; ++a)
    for (int b = 0; b < 24; ++b) {
      const int row = unknown(block, cell, a / 3);
      const int column = unknown(block, cell, b / 3);
      if (row >= 0 && column >= 0)
        act(row + a % 3, column + b % 3, a, b);
    }
}

void add_springs(const ElasticBlock &block, const Triple &cell, SparseRows &K)
{
  if (cell[0] + 1 < block.cells[0])
    return;
  for (int number = 1; number < 8; number += 2) { // on the side
    const int x = unknown(block, cell, number);
    if (x < 0)
      continue;
    K.at(x, x) += block.penalty / 4;
    K.at(x + 2, x) -= block.friction * block.penalty / 4;
  }
}
} // namespace

std::size_t ElasticBlock::cell_count() const
{
  return static_cast<std::size_t>(cells[0]) * cells[1] * cells[2];
}

std::size_t ElasticBlock::unknowns() const
{
  return std::size_t(3) * (cells[0] + 1) * (cells[1] + 1) * cells[2];
}

SparseRows stiffness(const ElasticBlock &block, const Share &cells)
{
  std::vector<std::set<int>> columns(block.unknowns());
  for (std::size_t cell = cells.begin; cell < cells.end; ++cell)
    for_entries(
        block, cell_at(block, cell), [&](int row, int column, int, int) {
          columns[row].insert(column);
        });
  SparseRows K(columns);
  const CellMatrix one = cell_stiffness();
  for (std::size_t cell = cells.begin; cell < cells.end; ++cell) {
    for_entries(
        block, cell_at(block, cell), [&](int row, int column, int a, int b) {
          K.at(row, column) += one[a][b];
        });
    add_springs(block, cell_at(block, cell), K);
  }
  return K;
}

SparseRows stiffness(const ElasticBlock &block)
{
  return stiffness(block, {0, block.cell_count()});
}

std::vector<std::vector<double>> rigid_modes(const ElasticBlock &block)
{
  const std::size_t n = block.unknowns();
  std::vector<std::vector<double>> modes(6, std::vector<double>(n, 0.));
  for (std::size_t i = 0; i < n; i += 3) {
    const int node = static_cast<int>(i / 3);
    const int nx = block.cells[0] + 1, ny = block.cells[1] + 1;
    const double x[] = {
        double(node % nx), double(node / nx % ny), double(node / nx / ny + 1)};
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      modes[axis][i + axis] = 1;
      modes[3 + axis][i + next] = -x[last];
      modes[3 + axis][i + last] = x[next];
    }
  }
  return modes;
}

std::vector<double> forces(const ElasticBlock &block)
{
  std::vector<double> result(block.unknowns());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = std::sin(1. + 0.7 * double(i) + 0.01 * double(i * i % 1000));
  return result;
}
} // namespace tamp::fem::test
