// SPDX-License-Identifier: BSD-3-Clause
#include <fem/anderson.h>
#include <fem/dot.h>

#include <cmath>

namespace tamp::fem
{
namespace
{
using Vector = std::vector<double>;

void add(Vector &a, double factor, const Vector &b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += factor * b[i];
}

Vector difference(const Vector &a, const Vector &b)
{
  Vector result = a;
  add(result, -1, b);
  return result;
}
} // namespace

std::vector<double> Anderson::next(const std::vector<double> &u,
                                   const std::vector<double> &g)
{
  if (!last_u_.empty() && depth_ > 0)
    differences_.push_front({difference(u, last_u_), difference(g, last_g_)});
  if (differences_.size() > depth_)
    differences_.pop_back();
  last_u_ = u;
  last_g_ = g;

  // Modified Gram-Schmidt over the columns, newest first. Each column of g is
  // orthogonalised together with its column of u, so that subtracting its part
  // of the residual needs no back substitution.
  const double smallest = 1e-4; // of a column's norm: below, it is dependent
  Vector u_best = u, g_best = g;
  std::vector<Difference> basis;
  for (const Difference &column : differences_) {
    Difference now = column;
    const double norm_before = std::sqrt(dot(now.g, now.g));
    for (const Difference &old : basis) {
      const double part = dot(old.g, now.g);
      add(now.g, -part, old.g);
      add(now.u, -part, old.u);
    }
    const double norm = std::sqrt(dot(now.g, now.g));
    if (!(norm > smallest * norm_before))
      continue;
    for (double &value : now.g)
      value /= norm;
    for (double &value : now.u)
      value /= norm;
    const double part = dot(now.g, g_best);
    add(g_best, -part, now.g);
    add(u_best, -part, now.u);
    basis.push_back(std::move(now));
  }
  add(u_best, 1, g_best);
  return u_best;
}
} // namespace tamp::fem
