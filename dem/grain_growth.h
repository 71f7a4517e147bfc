// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grain_growth_h
#define dem_grain_growth_h

#include <dem/laws/mdr.h>
#include <dem/obstruction.h>

#include <span>
#include <vector>

namespace tamp::dem
{
/// A contact at the end of an increment, after its memory was written. A grain
/// may touch its own image: then both indices are the same.
struct GrownContact {
  Branch branch; ///< now; they overlap by R_i + R_j less its length
  double largest_overlap = 0; ///< ever [m]
};

/// Sizes of grains [m].
struct GrainRadii {
  std::span<const double> apparent; ///< R, now
  std::span<const double> initial;  ///< R_o, which gives the solid volume
};

/// What grow_grains() answers.
struct GrainGrowth {
  std::vector<double> radius;       ///< new apparent radii R [m]
  std::vector<double> free_surface; ///< psi, share of the surface without
                                    ///< contact, before the growth [-]
  std::vector<double> more;         ///< new memories, Mdr::more per contact
};

/// Couples the contacts of each grain, explicitly, at the end of an increment.
///
/// Volume: a grain has the volume of the sphere of radius R less the caps that
/// flats cut off it. What a flat displaces while it is at its largest overlap
/// and yielded makes R grow, so that
/// d(4/3 pi R^3 - sum of caps) = -d(sum N (R - delta)) / (3 kappa),
/// where the right side is the elastic change of volume of a body under surface
/// forces. The balance holds for increments of any size, from the yield of each
/// contact on. R never shrinks, stays below 1.5 R_o, and rests while psi is
/// below the onset.
///
/// Bulk: below the onset, psi < psi_b, all flats of the grain get the mean
/// displacement since the last call, sum(A_c d delta) / sum(A_c), as an
/// increment of delta_B, and N_bulk follows with kappa sum(A_c) / V. The bulk
/// part is given back in unloading even if psi has risen above the onset (in
/// the source it then stays).
///
/// Obstruction of the contacts, for the next increment, is found here, too.
///
/// Caps of one grain may intersect; they are counted as if they did not, as in
/// the source. Overlaps change by the growth: the forces of the next increment
/// are not those of this one, and the grains have to settle again. Growth
/// brings new pairs into contact: neighbours are to be found with the new
/// radii; grow() of cell_growth.h sees to it. What is explicit costs accuracy
/// of first order in the increment: cycles at full density of an elastic array
/// lose 0.2 to 0.7 % of their work with increments of 1e-3 in density, and the
/// energies of pairs no longer add up; see unstored_work().
///
/// In the source, too, a flat that moves less than the mean unloads its part at
/// the contact, steeply: in uniaxial compression of a cubic array the lateral
/// force falls after the onset before it rises.
///
/// Source: Zunker & Kamrin (2024), J. Mech. Phys. Solids 183:105493; Zunker et
/// al. (2025), Powder Technol., 120972. The balance in finite increments is
/// ours, its rate is theirs; it has the forces of the contacts, the source
/// those of the sides.
/// @param more        memories of the contacts, in their order
/// @param bulk_onset  psi_b [-]. The published 0.5 was found with grains of
///                    E / Y about 20. It is to be fitted: with E / Y = 700 a
///                    cubic array then locks up at a relative density of 0.8
///                    already, with 0.1 at 0.96.
GrainGrowth grow_grains(const Mdr &law,
                        const GrainRadii &radii,
                        std::span<const GrownContact> contacts,
                        std::span<const double> more,
                        double bulk_onset = 0.5);
} // namespace tamp::dem

#endif
