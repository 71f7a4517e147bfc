// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_tangent_h
#define dem_tangent_h

#include <dem/tensors.h>

#include <Eigen/Core>

namespace tamp::dem
{
class UnitCell;

/// A linear map from strain to stress, in the order xx, yy, zz, yz, xz, xy;
/// strains are tensor components (not engineering shear): entry (k, l) is
/// d stress_k / d strain_l with strain_l alone in the symmetric tensor, that is
/// twice for l >= 3. [Pa]
using Tangent = Eigen::Matrix<double, 6, 6>;

/// Upper-bound stiffness of all grains following the strain without rotation:
/// 1/V sum d^2 [k_n nnnn + k_t (sym - nnnn)], both tangential directions, at
/// constant contact forces and geometry. k_n is the slope for further loading;
/// sliding contacts count with a tenth of k_t.
/// Source: Kruyt & Rothenburg (1998), J. Eng. Mech. 124:1; Luding (2004), Int.
/// J. Solids Struct. 41:5821.
Tangent voigt_stiffness(const UnitCell &cell);

/// What branches and volume add to d Cauchy stress / d strain when they follow
/// the strain: stress . strain - stress tr(strain) [Pa].
/// @param stress  Love-Weber stress, tension positive [Pa]
Tangent stress_transport(const Matrix3 &stress);

/// d Cauchy stress / d strain for h -> (I + strain) h: voigt_stiffness() and
/// the change of contact directions, branches and volume under stress.
Tangent voigt_tangent(const UnitCell &cell);
} // namespace tamp::dem

#endif
