// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_strain_derivative_h
#define fem_laws_strain_derivative_h

#include <fem/laws/density_table.h>

#include <Sacado.hpp>

namespace tamp::fem
{
/// A value and its derivatives by the six components of a strain.
using StrainDerivative = Sacado::Fad::SFad<double, 6>;

inline double value_of(const double number)
{
  return number;
}
template <int size>
double value_of(const Sacado::Fad::SFad<double, size> &number)
{
  return number.val();
}

/// A table's value with the derivative of its argument carried on.
template <class Number>
Number read(const DensityTable &table, const Number &x)
{
  const auto reading = table.read(value_of(x));
  return Number(reading.value + reading.slope * (x - value_of(x)));
}
} // namespace tamp::fem

#endif
