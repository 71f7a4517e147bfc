// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_relattice_h
#define dem_relattice_h

#include <dem/tensors.h>

namespace tamp::dem
{
class UnitCell;

/// Integers U with det U = 1 such that the edges h U span the lattice of h and
/// are short and nearly orthogonal: no edge gets shorter by adding or taking
/// off others. The identity for a lattice that is so already.
/// Source: Semaev (2001), Cryptography and Lattices, LNCS 2146:181 (reduction
/// in three dimensions).
Matrix3 reduction(const Matrix3 &h);

/// Whether an edge leans over another by more than half of the shorter one.
bool is_oblique(const Matrix3 &h);

/// Describes the same grains by shorter edges if the box has become oblique:
/// h -> h U, s -> U^-1 s. Nothing physical changes: nearest images, contacts,
/// their memory and the list of neighbours are the same, but the box is wider,
/// so that it can be sheared without end. Returns whether it did so.
bool relattice(UnitCell &cell);
} // namespace tamp::dem

#endif
