// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_cell_growth_h
#define dem_cell_growth_h

namespace tamp::dem
{
class UnitCell;

/// Whether the normal law lets the grains of a cell grow: mdr only.
bool grains_grow(const UnitCell &cell);

/// Couples the contacts of each grain by grow_grains(), which see: radii and
/// the numbers of the normal law are new then, and the list of neighbours knows
/// how much shorter its skin is. Does nothing to cells of other laws.
///
/// An increment begins with it. What the last one displaced is in the radii
/// only then, so that a cell at rest is in equilibrium, and its stress is that
/// of its contacts; and a trial that is not wanted takes its growth with it.
void grow(UnitCell &cell);

/// Work done on a cell so far less what is stored in its contacts, rubbed away
/// and damped away [J]. Grains that grow bring the energies of their contacts
/// out of any account of pairs; what this rises by is what they lost for good,
/// by plastic flow. The kinetic energy is taken off, too.
double unstored_work(const UnitCell &cell, double kinetic_energy = 0);
} // namespace tamp::dem

#endif
