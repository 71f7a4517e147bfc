// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_pair_law_h
#define dem_laws_pair_law_h

#include <dem/laws/lane_math.h>

namespace tamp::dem
{
/// Two grains, as long as their sizes stay. V is double, or a pack of lanes.
template <class V>
struct PairShape {
  V radius_sum;        ///< R_i + R_j [m]
  V reduced_radius;    ///< R* = R_i R_j / (R_i + R_j) [m]
  V radius_difference; ///< R_j - R_i, second less first [m]
  V inverse_mass;      ///< 1/m* = 1/m_i + 1/m_j [1/kg]
};

/// What a normal law finds in the memory of a contact, and what it leaves.
template <class V>
struct NormalMemory {
  V largest_overlap; ///< in: ever before; out: this one included [m]
  V contact_radius;  ///< in: at the last commit, above 0 if the grains
                     ///< touched; left as it is [m]
  V *more = nullptr; ///< in and out: the law's own numbers, Law::more of them
};

/// What a normal law answers. A pair touches where the contact radius is
/// above zero, be the force positive or, with adhesion, negative.
template <class V>
struct NormalAnswer {
  V force;          ///< N, compression positive [N]
  V contact_radius; ///< a now; 0 where the grains do not touch [m]
  V pull_off;       ///< N_c, the force it takes to part them; 0 without
                    ///< adhesion [N]
};

/// Elastic energy and energy lost for good in a normal contact [J].
struct NormalEnergy {
  double elastic = 0;
  double dissipated = 0;
};

/// How the two surfaces of a contact moved since its memory was written.
template <class V>
struct ContactMotion {
  PairShape<V> pair;
  Triple<V> normal;     ///< n, unit vector from the first grain to the second
  Triple<V> slip;       ///< relative displacement of the surfaces, second less
                        ///< first [m]; its part along n is no slip
  V spin;               ///< rotation of the grains about n, the mean by radius
                        ///< [rad]
  V old_radius;         ///< a when the memory was written [m]
  NormalAnswer<V> push; ///< the normal contact now
};

/// What a tangential law answers.
template <class V>
struct TangentialAnswer {
  Triple<V> force; ///< T on the first grain [N]
  V lost_work;     ///< turned into heat since the memory was written [J]
};
} // namespace tamp::dem

#endif
