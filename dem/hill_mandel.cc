// SPDX-License-Identifier: BSD-3-Clause
#include <dem/hill_mandel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
double hill_mandel_residual(const UnitCell &cell,
                            std::span<const ContactForce> forces,
                            const Matrix3 &back,
                            std::span<const double> motion,
                            double least)
{
  const Matrix3 gradient = Matrix3::Identity() - back;
  Matrix3 stress = Matrix3::Zero();
  double micro = 0, traffic = 0;
  for (const ContactForce &c : forces) {
    const auto [i, j] = c.pair;
    const Vector3 n = c.branch.normalized();
    const Vector3 force = c.normal_force * n - c.tangential_force;
    const double arm = c.branch.norm() / (cell.radius[i] + cell.radius[j]);
    const Vector3 moved =
        back * (Vector3(&motion[6 * j]) - Vector3(&motion[6 * i]));
    const Vector3 rolled =
        Vector3(&motion[6 * i + 3]) + Vector3(&motion[6 * j + 3]);
    const double work =
        force.dot(moved + gradient * c.branch - arm * rolled.cross(n));
    micro -= work;
    traffic += std::abs(work);
    stress -= force * c.branch.transpose();
  }
  const double macro = (stress.array() * gradient.array()).sum();
  const double most = std::max(traffic, least);
  return most > 0 ? std::abs(micro - macro) / most : 0.0;
}
} // namespace tamp::dem
