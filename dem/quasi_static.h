// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_quasi_static_h
#define dem_quasi_static_h

#include <dem/deform.h>

namespace tamp::dem
{
/// The quasi-static map: contact memory stays frozen at the start of the
/// increment, the affine motion and a predictor are applied, the grains relax
/// to static equilibrium under the total slip and overlap of the increment, and
/// only then is the memory written. Like a return mapping in plasticity it has
/// no rate, and an increment that is not wanted leaves nothing behind.
/// Arguments as those of deform().
CellAnswer deform_quasi_static(UnitCell &cell,
                               const Stretch &stretch,
                               const QuasiStatic &settings,
                               const Arithmetic &arithmetic,
                               WarmGuess *guess);
} // namespace tamp::dem

#endif
