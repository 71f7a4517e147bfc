// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_unit_cell_h
#define dem_unit_cell_h

#include <dem/contacts.h>
#include <dem/grain_material.h>
#include <dem/laws/pair_law.h>
#include <dem/neighbours.h>
#include <dem/periodic_box.h>
#include <dem/tensors.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tamp::dem
{
/// How the grains moved in the last increment: a guess for the next.
struct LastMotion {
  Matrix3 log_stretch = Matrix3::Zero(); ///< ln U of the increment [-]
  /// Per grain: non-affine displacement [m], radius x rotation [m].
  std::vector<double> motion;
  bool operator==(const LastMotion &) const = default;
};

/// Work and heat since the cell was made [J].
struct EnergyAccount {
  double work = 0; ///< done by the stress on the cell
  /// In the normal laws; where grains grow all else that is not stored.
  double plastic_dissipation = 0;
  double friction_dissipation = 0; ///< by sliding and rolling
  double damping_dissipation = 0;  ///< globally and in contacts; dynamics only
  double adhesion_dissipation = 0; ///< in jumps of the force, at touch and tear
  bool operator==(const EnergyAccount &) const = default;
};

/// A periodic sample of grains: all that its future depends on, as a value that
/// can be copied, compared and turned into bytes.
class UnitCell
{
public:
  std::vector<GrainMaterial> materials = std::vector<GrainMaterial>(1);
  std::vector<std::uint8_t> species; ///< material of each grain, as an index;
                                     ///< empty: all of the first
  ContactModel contact;
  PeriodicBox box;
  double reference_volume = 0; ///< V_0 of the box when the cell was made [m3]
  std::vector<double> radius;  ///< R, apparent where grains grow [m]
  std::vector<double> initial_radius; ///< R_o, which gives volume and mass;
                                      ///< empty: no grain has grown [m]
  std::vector<Vector3> place;         ///< fractional coordinates [-]
  std::vector<Vector3> velocity; ///< fluctuation [m/s]; empty unless dynamic
  std::vector<Vector3> spin;     ///< [rad/s]; empty unless dynamic
  std::vector<ContactMemory> contacts; ///< of touching pairs, sorted
  /// Numbers of the contact laws' own, as many per contact as they want, in the
  /// order of the contacts.
  std::vector<double> more_memory;
  Neighbours neighbours;
  LastMotion last;
  EnergyAccount energy;

  std::size_t size() const { return radius.size(); }
  const GrainMaterial &material_of(std::size_t grain) const
  {
    return materials[species.empty() ? 0 : species[grain]];
  }
  /// Whether limiting contact pressures are adjusted to the density.
  bool adjusts_pressures() const;
  /// The materials with the limiting contact pressures that hold at the present
  /// density, see GrainMaterial::at_density().
  std::vector<GrainMaterial> materials_now() const;
  double initial_radius_of(std::size_t grain) const
  {
    return initial_radius.empty() ? radius[grain] : initial_radius[grain];
  }
  double mass(std::size_t grain) const; ///< [kg]
  PairShape<double> shape(Pair pair) const;
  double largest_radius() const;
  double smallest_radius() const;
  double mean_radius() const;
  /// Volume of all grains by their R_o, overlaps not taken off [m3].
  double solid_volume() const;
  /// solid_volume() / volume of the box [-].
  double relative_density() const { return solid_volume() / box.volume(); }

  bool operator==(const UnitCell &) const = default;
};
} // namespace tamp::dem

#endif
