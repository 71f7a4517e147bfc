// SPDX-License-Identifier: BSD-3-Clause
#include <fem/sparse_rows.h>

#include <algorithm>
#include <cassert>

namespace tamp::fem
{
namespace
{
std::size_t position(const SparseRows &matrix, int row, int column)
{
  const auto first = matrix.column.begin() + matrix.begin[row];
  const auto last = matrix.column.begin() + matrix.begin[row + 1];
  const auto found = std::lower_bound(first, last, column);
  assert(found != last && *found == column);
  return static_cast<std::size_t>(found - matrix.column.begin());
}
} // namespace

SparseRows::SparseRows(const std::vector<std::set<int>> &columns)
{
  begin.push_back(0);
  for (const auto &row : columns) {
    column.insert(column.end(), row.begin(), row.end());
    begin.push_back(static_cast<int>(column.size()));
  }
  value.assign(column.size(), 0.);
}

double &SparseRows::at(int row, int column)
{
  return value[position(*this, row, column)];
}

double SparseRows::at(int row, int column) const
{
  return value[position(*this, row, column)];
}

std::vector<double> multiply(const SparseRows &matrix,
                             std::span<const double> x)
{
  std::vector<double> y(x.size(), 0.);
  for (int row = 0; row < matrix.size(); ++row)
    for (int k = matrix.begin[row]; k < matrix.begin[row + 1]; ++k)
      y[row] += matrix.value[k] * x[matrix.column[k]];
  return y;
}
} // namespace tamp::fem
