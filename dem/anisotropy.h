// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_anisotropy_h
#define dem_anisotropy_h

#include <dem/tensors.h>

#include <vector>

namespace tamp::dem
{
struct ContactForce;

/// How contacts and their forces depend on the direction n, to second order,
/// with f_0 the mean over directions of the mean normal force in a direction:
/// density of contacts (1 + contacts : nn) / (4 pi), mean normal force
/// f_0 (1 + normal : nn), mean tangential force of first on second
/// f_0 (tangential . n - (n . tangential . n) n).
/// For grains of about one size the deviator of the stress over the pressure,
/// both positive in compression, is to first order
/// 2/5 (contacts + normal + 3/2 tangential).
/// Source: Rothenburg & Bathurst (1989), Géotechnique 39:601; tensors: Guo &
/// Zhao (2013), Comput. Geotech. 47:1.
struct Anisotropies {
  Matrix3 contacts = Matrix3::Zero();   ///< a_r, trace 0 [-]
  Matrix3 normal = Matrix3::Zero();     ///< a_n, trace 0 [-]
  Matrix3 tangential = Matrix3::Zero(); ///< a_t, trace 0 [-]
};

/// All zero where there are no contacts or the forces cancel.
Anisotropies anisotropies(const std::vector<ContactForce> &contacts);
} // namespace tamp::dem

#endif
