// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_point_h
#define fem_laws_cap_point_h

#include <fem/laws/cap_return.h>

#include <array>
#include <cmath>
#include <type_traits>

namespace tamp::fem
{
using Six = std::array<double, 6>; ///< a tensor, order of SymmetricTensor

/// All that an isotropic law can take from a strain: the derivatives are by
/// v = -tr(strain), w = s_0 : e and u = e : e, where s_0 is the deviator of the
/// old stress and e that of the strain.
using ByInvariants = Sacado::Fad::SFad<double, 3>;

inline double contract(const Six &a, const Six &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] +
         2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

inline Six entries(const dealii::SymmetricTensor<2, 3> &tensor)
{
  Six result;
  for (unsigned k = 0; k < 6; ++k)
    result[k] = tensor.access_raw_entry(k);
  return result;
}

/// What changes during an increment. The deviator of stress stays in the plane
/// of s_0 and e: s = old_share s_0 + strain_share e.
template <class Number>
struct CapPoint {
  Number old_share;    ///< [-]
  Number strain_share; ///< [Pa]
  Number p;            ///< compression positive [Pa]
  Number compaction;   ///< eps [-]
  double plastic_shear = 0;
  DruckerPragerCap::Surface surface = DruckerPragerCap::Surface::none;
  CapSurface<ByCompaction> at; ///< the surface at eps
};

/// The unknown change of compaction with its derivatives, from the implicit
/// function theorem.
template <class Number>
Number lift(const CapTrial<Number> &trial, const CapReturn &found)
{
  Number x = found.compaction_change;
  if constexpr (!std::is_same_v<Number, double>) {
    const auto residual = return_residual<Number>(
        carry(found.at, trial.compaction),
        trial,
        found.surface == DruckerPragerCap::Surface::cap,
        {Number(found.compaction_change), Number(found.position)});
    const auto &inverse = found.inverse_jacobian[0];
    for (unsigned k = 0; k < 3; ++k)
      x.fastAccessDx(k) =
          -inverse[0] * residual[0].dx(k) - inverse[1] * residual[1].dx(k);
  }
  return x;
}

/// q / q_trial from the flow rule, in the form that is regular at q_trial = 0
/// where that is possible.
template <class Number>
Number deviator_ratio(const bool on_cap,
                      const CapSurface<Number> &s,
                      const CapTrial<Number> &trial,
                      const Number &p,
                      const Number &x)
{
  using std::sqrt;
  const Number stiffness = 3. * trial.shear * x / (s.factor * s.factor);
  if (on_cap) {
    const Number off = p - s.centre;
    if (value_of(off) > 0.7 * value_of(s.radius()))
      return Number(1. /
                    (1. + stiffness * s.eccentricity * s.eccentricity / off));
    const Number place = off / s.radius();
    return Number(s.top() * sqrt(1. - place * place) / trial.q);
  }
  const Number q = s.shear_limit(p);
  if (2 * value_of(p) < value_of(Number(s.centre + s.apex())))
    return Number(1. / (1. - stiffness / s.dilation(p, q)));
  return Number(q / trial.q);
}
} // namespace tamp::fem

#endif
