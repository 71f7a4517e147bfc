// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_return_h
#define fem_laws_cap_return_h

#include <fem/laws/cap_tables.h>

#include <array>

namespace tamp::fem
{
/// An elastic trial state in the p-q plane.
template <class Number>
struct CapTrial {
  Number p, q;        ///< [Pa], compression positive
  Number bulk, shear; ///< K and G [Pa]
  Number compaction;  ///< plastic volumetric strain before [-]
};

/// Where a trial state returns to: the unknowns of the return.
struct CapReturn {
  DruckerPragerCap::Surface surface = DruckerPragerCap::Surface::none;
  double compaction_change = 0; ///< [-]
  /// On the cap its parametric angle [rad], 0 at p_b, pi/2 at p_a; else q
  /// [Pa].
  double position = 0;
  /// Inverse of the Jacobian of the two residuals at the solution, [residual]
  /// last.
  std::array<std::array<double, 2>, 2> inverse_jacobian{};
  /// The surface at the end.
  CapSurface<ByCompaction> at;
  bool converged = false;
};

/// Backward Euler return of a trial state that is not inside its surface; says
/// `none` for one that is. Newton's method from the trial state; where that
/// does not lead to an admissible root, roots are bracketed.
/// @param start  the surface at the trial's compaction.
CapReturn return_to_surface(CapTables &tables,
                            const CapSurface<ByCompaction> &start,
                            const CapTrial<double> &trial);

/// The two equations of a return, zero at the solution, for unknowns
/// `compaction_change` and `position`. On the cap:
///   p_a + R_c A cos(t) - p = 0,
///   (q_trial - c A sin(t)) cos(t) - 3 G x R_c / c sin(t) = 0;
/// on shear and transition:
///   q - q_limit(p) = 0,
///   3 G x q / c^2 + (q_trial - q) dilation(p, q) = 0,
/// with p = p_trial - K x and x the change of compaction.
/// @param s  the surface at the compaction of the end.
template <class Number>
std::array<Number, 2> return_residual(const CapSurface<Number> &s,
                                      const CapTrial<Number> &trial,
                                      const bool on_cap,
                                      const std::array<Number, 2> &unknowns)
{
  using std::cos;
  using std::sin;
  const auto &[x, position] = unknowns;
  const Number p = trial.p - trial.bulk * x;
  if (on_cap) {
    const Number cosine = cos(position), sine = sin(position);
    return {Number(s.centre + s.radius() * cosine - p),
            Number((trial.q - s.top() * sine) * cosine -
                   3. * trial.shear * x * s.eccentricity / s.factor * sine)};
  }
  return {Number(position - s.shear_limit(p)),
          Number(3. * trial.shear * x * position / (s.factor * s.factor) +
                 (trial.q - position) * s.dilation(p, position))};
}
} // namespace tamp::fem

#endif
