// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_return_h
#define fem_laws_cap_return_h

#include <fem/laws/drucker_prager_cap.h>

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
  bool converged = false;
};

/// The surface at a plastic volumetric strain, differentiable.
template <class Number>
CapSurface<Number> cap_surface(const DruckerPragerCapParameters &parameters,
                               const Number &compaction);

/// Backward Euler return of a trial state that is not inside its surface; says
/// `none` for one that is.
CapReturn return_to_surface(const DruckerPragerCapParameters &parameters,
                            const CapTrial<double> &trial);

/// The two equations of a return, zero at the solution, for unknowns
/// `compaction_change` and `position`. On the cap:
///   p_a + R_c A cos(t) - p = 0,
///   (q_trial - c A sin(t)) cos(t) - 3 G x R_c / c sin(t) = 0;
/// on shear and transition:
///   q - q_limit(p) = 0,
///   3 G x q / c^2 + (q_trial - q) (p_a - p) tan^2(beta) = 0,
/// with p = p_trial - K x and x the change of compaction.
template <class Number>
std::array<Number, 2>
return_residual(const DruckerPragerCapParameters &parameters,
                const CapTrial<Number> &trial,
                bool on_cap,
                const std::array<Number, 2> &unknowns);
} // namespace tamp::fem

#endif
