// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_contact_parameters_h
#define apps_input_contact_parameters_h

#include <dem/pair_body.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tamp::apps
{
class ParameterTable;

/// What the path of a pair prescribes: overlap and slip of the surfaces [m],
/// mean rotation about the normal and rotation of the first body relative to
/// the second [rad].
namespace coordinate
{
enum : std::size_t {
  overlap,
  slip_x,
  slip_y,
  spin,
  rotation_x,
  rotation_y,
  rotation_z,
  count
};
} // namespace coordinate
using PairPlace = std::array<double, coordinate::count>;

/// A part of a path: a straight line in equal steps.
struct PairStage {
  std::string text; ///< as the user wrote it
  PairPlace end;
  unsigned steps;
};

/// Reads stages divided by semicolons, each "COORDINATE to VALUE [COORDINATE to
/// VALUE ...] in N [steps]"; coordinates that are not named rest. Throws
/// InputError naming the stage and the word.
std::vector<PairStage> parse_pair_stages(const std::string &stages);

/// A grain and what it touches.
struct PairInput {
  dem::GrainMaterial material, partner;
  dem::Body first, second; ///< for an impact, with their velocities
  std::vector<PairStage> stages;
  bool impact = false;
  double time_steps = 4000; ///< in the time of an elastic contact
  unsigned record_interval = 10;
};

/// @name Section Contact
/// @{
void declare_contact(ParameterTable &table);
void read_contact(const ParameterTable &table, dem::ContactModel &contact);
/// The limiting contact pressures that are adjusted to the density of a cell;
/// none if it is constant. Throws InputError if they are no table, or if the
/// normal law takes the pressure for constant.
std::vector<dem::PressureAtDensity>
read_adjusted_pressures(const ParameterTable &table);
/// @}

/// @name Section Pair
/// @{
void declare_pair(ParameterTable &table);
/// @param material, model  of the grains, as read from Grains and Contact
PairInput read_pair(const ParameterTable &table,
                    const dem::GrainMaterial &material,
                    const dem::ContactModel &model);
/// @}
} // namespace tamp::apps

#endif
