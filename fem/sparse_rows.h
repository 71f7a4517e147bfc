// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_sparse_rows_h
#define fem_sparse_rows_h

#include <set>
#include <span>
#include <vector>

namespace tamp::fem
{
/// A square matrix in compressed rows; columns of a row are sorted.
struct SparseRows {
  std::vector<int> begin; ///< of each row, and the end of the last
  std::vector<int> column;
  std::vector<double> value;

  SparseRows() = default;
  /// Zero matrix with these columns in each row.
  explicit SparseRows(const std::vector<std::set<int>> &columns);

  int size() const { return static_cast<int>(begin.size()) - 1; }
  /// An entry, which must be in the pattern.
  double &at(int row, int column);
  double at(int row, int column) const;
};

/// y = A x.
std::vector<double> multiply(const SparseRows &matrix,
                             std::span<const double> x);
} // namespace tamp::fem

#endif
