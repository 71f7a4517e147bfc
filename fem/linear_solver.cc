// SPDX-License-Identifier: BSD-3-Clause
#include <fem/linear_backends.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tamp::fem
{
namespace
{
using Modes = std::vector<std::vector<double>>;

bool finite(std::span<const double> values)
{
  return std::all_of(values.begin(), values.end(), [](double value) {
    return std::isfinite(value);
  });
}

/// Does the mode move one of every `block` unknowns only, all by the same?
bool moves_one_component(const std::vector<double> &mode, std::size_t block)
{
  std::size_t first = 0;
  while (first < mode.size() && mode[first] == 0)
    ++first;
  for (std::size_t i = 0; i < mode.size(); ++i)
    if (mode[i] != 0 && (i % block != first % block || mode[i] != mode[first]))
      return false;
  return first < mode.size();
}

/// The unknowns per node, which a translation tells.
unsigned block_of(const Modes &modes, std::size_t size)
{
  for (const unsigned block : {3u, 2u})
    if (size % block == 0 &&
        std::any_of(modes.begin(), modes.end(), [&](const auto &mode) {
          return moves_one_component(mode, block);
        }))
      return block;
  return 1;
}

double product(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

/// Modified Gram-Schmidt; leaves out what the modes before it span.
Modes orthonormal(Modes modes)
{
  constexpr double smallest_part = 1e-8;
  Modes result;
  for (std::vector<double> &mode : modes) {
    const double before = std::sqrt(product(mode, mode));
    for (const std::vector<double> &other : result) {
      const double share = product(mode, other);
      for (std::size_t i = 0; i < mode.size(); ++i)
        mode[i] -= share * other[i];
    }
    const double length = std::sqrt(product(mode, mode));
    if (!(length > smallest_part * before))
      continue;
    for (double &entry : mode)
      entry /= length;
    result.push_back(std::move(mode));
  }
  return result;
}

LinearSystem system_of(const SparseRows &matrix,
                       const LinearSettings &settings,
                       const Ranks &ranks,
                       Modes modes)
{
  const auto size = static_cast<std::size_t>(matrix.size());
  LinearSystem system{matrix, settings, ranks, 1, {}, {}};
  system.pattern.value.clear();
  system.block = block_of(modes, size);
  system.rows = ranks.share(size / system.block);
  system.rows.begin *= system.block;
  system.rows.end *= system.block;
  system.rigid_modes = orthonormal(std::move(modes));
  return system;
}

std::unique_ptr<LinearSolver::Backend> backend_for(const LinearSystem &system)
{
  const bool direct = system.settings.method != LinearMethod::iterative;
  if (system.settings.algebra == LinearAlgebra::petsc)
    return direct ? petsc_direct(system) : petsc_multigrid(system);
  return direct ? trilinos_direct(system) : trilinos_multigrid(system);
}

enum class Shape { singular, symmetric, general };

/// Compares A x with A^T x for one x that has no pattern, row by row. Singular:
/// a row without entries; nothing else is looked for.
Shape shape_of(const LinearSystem &system, std::span<const double> values)
{
  constexpr double tolerance = 1e-10; // [-] of a row; rounding of assembly
  const SparseRows &pattern = system.pattern;
  const auto x = [](int i) { return 1.5 + std::sin(2.4 * i); };
  const std::size_t n = pattern.size();
  std::vector<double> sums(2 * n, 0.); // A x - A^T x, |A| x
  for (int row = 0; row < pattern.size(); ++row)
    for (int k = pattern.begin[row]; k < pattern.begin[row + 1]; ++k) {
      const int column = pattern.column[k];
      sums[row] += values[k] * x(column);
      sums[column] -= values[k] * x(row);
      sums[n + row] += std::abs(values[k]) * x(column);
    }
  system.ranks.sum(sums);
  Shape shape = Shape::symmetric;
  for (std::size_t row = 0; row < n; ++row) {
    if (sums[n + row] == 0)
      return Shape::singular;
    if (std::abs(sums[row]) > tolerance * sums[n + row])
      shape = Shape::general;
  }
  return shape;
}
} // namespace

struct LinearSolver::Implementation {
  LinearSystem system;
  std::unique_ptr<Backend> backend;
  bool ready = false; ///< the last factorise() succeeded
};

LinearSolver::LinearSolver(const SparseRows &matrix,
                           const LinearSettings &settings,
                           const Ranks &ranks,
                           std::vector<std::vector<double>> rigid_modes)
    : implementation_(std::make_unique<Implementation>())
{
  implementation_->system =
      system_of(matrix, settings, ranks, std::move(rigid_modes));
  implementation_->backend = backend_for(implementation_->system);
}

LinearSolver::~LinearSolver() = default;

bool LinearSolver::factorise(std::span<const double> values)
{
  Implementation &s = *implementation_;
  assert(values.size() == s.system.pattern.column.size());
  s.ready = false;
  if (!s.system.ranks.all(finite(values)))
    return false;
  bool symmetric = false;
  if (s.system.settings.method == LinearMethod::iterative) {
    const Shape shape = shape_of(s.system, values);
    if (shape == Shape::singular)
      return false;
    symmetric = shape == Shape::symmetric;
  }
  s.ready = s.system.ranks.all(s.backend->factorise(values, symmetric));
  return s.ready;
}

bool LinearSolver::solve(std::span<const double> right_side,
                         std::span<double> solution)
{
  Implementation &s = *implementation_;
  const Share &rows = s.system.rows;
  assert(right_side.size() == solution.size());
  if (!s.ready || !finite(right_side))
    return false;
  std::vector<double> all(solution.size(), 0.);
  const bool good =
      s.backend->solve(right_side.subspan(rows.begin, rows.size()),
                       std::span(all).subspan(rows.begin, rows.size()));
  s.system.ranks.sum(all); // of one number and zeros: exact
  if (!s.system.ranks.all(good) || !finite(all))
    return false;
  std::copy(all.begin(), all.end(), solution.begin());
  return true;
}

unsigned LinearSolver::iterations() const
{
  return implementation_->backend->iterations();
}
} // namespace tamp::fem
