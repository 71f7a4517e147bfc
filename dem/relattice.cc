// SPDX-License-Identifier: BSD-3-Clause
#include <dem/relattice.h>
#include <dem/unit_cell.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
namespace
{
// A lattice on the border of two descriptions keeps the one it has.
constexpr double round_off = 1e-9;

/// Takes multiples of the shorter edge off the longer one. Returns whether it
/// got shorter.
bool reduce_pair(Matrix3 &h, Matrix3 &U, int a, int b)
{
  if (h.col(a).squaredNorm() > h.col(b).squaredNorm())
    std::swap(a, b);
  const double lean = h.col(a).dot(h.col(b)) / h.col(a).squaredNorm();
  if (std::abs(lean) <= 0.5 * (1 + round_off))
    return false;
  h.col(b) -= std::round(lean) * h.col(a);
  U.col(b) -= std::round(lean) * U.col(a);
  return true;
}

/// Adds both other edges, or takes them off, where that shortens an edge.
bool reduce_triple(Matrix3 &h, Matrix3 &U)
{
  for (int c = 0; c < 3; ++c)
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        const Vector3 edge = h.col(c) + x * h.col(a) + y * h.col(b);
        if (edge.squaredNorm() >= (1 - round_off) * h.col(c).squaredNorm())
          continue;
        h.col(c) = edge;
        U.col(c) += x * U.col(a) + y * U.col(b);
        return true;
      }
  return false;
}
} // namespace

Matrix3 reduction(const Matrix3 &h)
{
  Matrix3 edges = h, U = Matrix3::Identity();
  // Every turn shortens an edge, and a lattice has few short ones.
  while (reduce_pair(edges, U, 0, 1) || reduce_pair(edges, U, 0, 2) ||
         reduce_pair(edges, U, 1, 2) || reduce_triple(edges, U)) {
  }
  return U;
}

bool is_oblique(const Matrix3 &h)
{
  for (const auto &[a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    const double shorter =
        std::min(h.col(a).squaredNorm(), h.col(b).squaredNorm());
    if (std::abs(h.col(a).dot(h.col(b))) > 0.5 * (1 + round_off) * shorter)
      return true;
  }
  return false;
}

bool relattice(UnitCell &cell)
{
  if (!is_oblique(cell.box.h))
    return false;
  const Matrix3 U = reduction(cell.box.h);
  const Matrix3 inverse = U.inverse().array().round();
  cell.box.h = (cell.box.h * U).eval();
  for (Vector3 &place : cell.place)
    place = (inverse * place).eval();
  cell.neighbours.box = (cell.neighbours.box * U).eval();
  for (Vector3 &place : cell.neighbours.place)
    place = (inverse * place).eval();
  return true;
}
} // namespace tamp::dem
