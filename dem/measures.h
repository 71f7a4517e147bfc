// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_measures_h
#define dem_measures_h

#include <dem/anisotropy.h>
#include <dem/backbone.h>
#include <dem/tensors.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tamp::dem
{
/// A force-carrying contact of a cell, for measures and pictures.
struct ContactForce {
  Pair pair{};
  Vector3 branch = Vector3::Zero();           ///< from first to second [m]
  double normal_force = 0;                    ///< N, compression positive [N]
  Vector3 tangential_force = Vector3::Zero(); ///< on the first grain [N]
  double overlap = 0;                         ///< [m]
  bool plastic = false, sliding = false;
};

/// What all contacts of a cell say, in one pass over them.
struct ContactSurvey {
  std::vector<ContactForce> forces; ///< of those that touch, in the order of
                                    ///< the cell's memory
  double elastic_energy = 0;        ///< stored in all [J]
  /// What the normal laws have turned into heat in the contacts that there are
  /// [J].
  double plastic_loss = 0;
};

ContactSurvey survey_contacts(const UnitCell &cell);
std::vector<ContactForce> contact_forces(const UnitCell &cell);

/// Cauchy stress of the contact forces, tension positive, not symmetrised [Pa]:
/// sigma = -1/V sum f (x) l, f the force of first on second.
/// Source: Love (1927); Weber (1966); Christoffersen et al. (1981), J. Appl.
/// Mech. 48:339.
/// @param volume  of the cell [m3]
Matrix3 love_weber_stress(std::span<const ContactForce> forces, double volume);
Matrix3 love_weber_stress(const UnitCell &cell);

/// What is worth knowing of a packing.
struct CellMeasures {
  Matrix3 stress = Matrix3::Zero(); ///< symmetric part, tension positive [Pa]
  double asymmetry = 0;             ///< |skw stress| / |stress| [-]
  Matrix3 fabric = Matrix3::Zero(); ///< mean of n (x) n, trace 1 [-]
  Anisotropies anisotropy;
  std::size_t contacts = 0; ///< C, that touch
  std::size_t plastic_contacts = 0, sliding_contacts = 0;
  double mean_normal_force = 0; ///< over all contacts [N]
  Backbone backbone;
  std::size_t rattlers = 0;       ///< those of find_backbone()
  double coordination_number = 0; ///< Z = 2 C / N
  /// Z_m = (2 C - N_1) / (N - N_0 - N_1).
  /// Source: Thornton & Antony (2000), Powder Technol. 109:179.
  double mechanical_coordination_number = 0;
  double relative_density = 0; ///< [-]
  double elastic_energy = 0;   ///< in all contacts [J]
};

CellMeasures measure(const UnitCell &cell);
} // namespace tamp::dem

#endif
