// SPDX-License-Identifier: BSD-3-Clause
#include <dem/probed_tangent.h>
#include <dem/six.h>
#include <dem/stretch.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <algorithm>

namespace tamp::dem
{
void Probing::check() const
{
  const Positive positive;
  positive(strain, "probe strain");
  positive(unbalance_tolerance, "unbalance tolerance of probes");
  if (strain > 1e-3)
    refuse("probe strain", strain, "at most 1e-3");
}

namespace
{
/// The probes of one cell.
class Probes
{
public:
  Probes(const UnitCell &cell, const Probing &probing)
      : cell_(cell), path_(exponential(probing.path))
  {
    QuasiStatic &map = driving_.quasi_static;
    map.unbalance_tolerance = probing.unbalance_tolerance;
    map.maximum_evaluations = probing.maximum_evaluations;
    // One increment: answers shall not depend on a number of parts.
    map.maximum_strain_increment =
        2 * (largest_principal(probing.path) + probing.strain);
    unprobed_ = stress(Matrix3::Zero());
  }

  /// Stress after the path and a further stretch I + strain [Pa].
  Matrix3 stress(const Matrix3 &strain)
  {
    const Matrix3 F = (Matrix3::Identity() + strain) * path_;
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(F.transpose() * F);
    const Stretch stretch = eigen.operatorSqrt();
    const Matrix3 rotation = F * eigen.operatorInverseSqrt();
    UnitCell copy = cell_;
    WarmGuess guess = start_;
    const CellAnswer answer = deform(copy, stretch, driving_, &guess);
    settled_ = settled_ && answer.outcome == Outcome::settled;
    if (start_.empty())
      start_ = guess;
    return rotation * answer.stress * rotation.transpose();
  }

  const Matrix3 &unprobed() const { return unprobed_; }
  bool settled() const { return settled_; }

private:
  const UnitCell &cell_;
  Stretch path_;
  Driving driving_;
  WarmGuess start_; // where the grains came to rest without a probe
  Matrix3 unprobed_;
  bool settled_ = true;
};
} // namespace

SolvedTangent probed_tangent(const UnitCell &cell, const Probing &probing)
{
  probing.check();
  Probes probes(cell, probing);
  SolvedTangent result;
  for (int column = 0; column < 6; ++column) {
    const Matrix3 strain = probing.strain * unit_strain(column);
    const Matrix3 ahead = probes.stress(strain);
    const Matrix3 behind =
        probing.central ? probes.stress(-strain) : probes.unprobed();
    const double distance = (probing.central ? 2 : 1) * probing.strain;
    result.tangent.col(column) = to_six((ahead - behind) / distance);
  }
  result.converged = probes.settled();
  return result;
}
} // namespace tamp::dem
