// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_plastic_point_h
#define fem_laws_plastic_point_h

#include <fem/laws/corotation.h>
#include <fem/laws/strain_derivative.h>

#include <array>
#include <cmath>

namespace tamp::fem
{
/// The components of a symmetric tensor in the order of dealii's
/// SymmetricTensor: xx, yy, zz, xy, xz, yz.
template <class Number>
using Components = std::array<Number, 6>;

/// What changes during an increment of an isotropic law with one hardening
/// variable, in the frame that does not turn.
template <class Number>
struct PlasticPoint {
  Components<Number> deviator;   ///< of the stress, tension positive [Pa]
  Number p;                      ///< pressure, compression positive [Pa]
  Number hardening;              ///< the law's own variable [-]
  Number compaction;             ///< -ln(det dF) since the increment began [-]
  double plastic_compaction = 0; ///< [-]
  double plastic_shear = 0;      ///< sum of sqrt(2/3 de:de), e deviatoric [-]
  bool yielding = false;         ///< the last part was plastic
};

/// sqrt(3/2 s : s); zero without derivatives where s is zero.
template <class Number>
Number equivalent_stress(const Components<Number> &deviator)
{
  using std::sqrt;
  Number square = 0.;
  for (unsigned k = 0; k < 6; ++k)
    square += (k < 3 ? 1.5 : 3.) * deviator[k] * deviator[k];
  return value_of(square) <= 0 ? Number(0.) : Number(sqrt(square));
}

/// -tr(strain).
template <class Number>
Number compaction_of(const Components<Number> &strain)
{
  return Number(-(strain[0] + strain[1] + strain[2]));
}

template <class Number>
Components<Number> deviator_of(Components<Number> strain)
{
  const Number mean = (strain[0] + strain[1] + strain[2]) / 3.;
  for (unsigned k = 0; k < 3; ++k)
    strain[k] -= mean;
  return strain;
}

/// The components of a strain, with themselves as derivatives if Number has
/// any.
template <class Number>
Components<Number> independent(const dealii::SymmetricTensor<2, 3> &strain)
{
  Components<Number> result;
  for (unsigned k = 0; k < 6; ++k)
    if constexpr (std::is_same_v<Number, double>)
      result[k] = strain.access_raw_entry(k);
    else
      result[k] = Number(6, k, strain.access_raw_entry(k));
  return result;
}

/// Stress and pressure of a stress tensor as the start of an increment.
template <class Number>
PlasticPoint<Number> start_from(const dealii::SymmetricTensor<2, 3> &stress)
{
  PlasticPoint<Number> point;
  const auto s = deviator(stress);
  for (unsigned k = 0; k < 6; ++k)
    point.deviator[k] = s.access_raw_entry(k);
  point.p = -trace(stress) / 3;
  point.hardening = 0.;
  point.compaction = 0.;
  return point;
}

/// The stress of a point and its derivatives by the strain, as far as Number
/// carries them.
template <class Number>
CorotatedStress corotated_stress(const PlasticPoint<Number> &point)
{
  using dealii::SymmetricTensor;
  CorotatedStress answer;
  for (unsigned m = 0; m < 6; ++m) {
    const Number entry =
        m < 3 ? Number(point.deviator[m] - point.p) : point.deviator[m];
    answer.stress.access_raw_entry(m) = value_of(entry);
    if constexpr (!std::is_same_v<Number, double>)
      for (unsigned k = 0; k < 6; ++k) {
        const auto ij = SymmetricTensor<2, 3>::unrolled_to_component_indices(m);
        const auto ab = SymmetricTensor<2, 3>::unrolled_to_component_indices(k);
        // A shear component stands for two entries of the strain.
        answer.by_log_stretch[ij[0]][ij[1]][ab[0]][ab[1]] =
            k < 3 ? entry.dx(k) : entry.dx(k) / 2;
      }
  }
  return answer;
}
} // namespace tamp::fem

#endif
