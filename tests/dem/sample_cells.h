// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_sample_cells_h
#define tests_dem_sample_cells_h

#include <dem/deform.h>
#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tamp::dem::test
{
/// 200 alumina granules, 450-650 um, mu .35, p_y 50 MPa, packed at 0.5 MPa.
PackingRequest alumina_request();

/// The packing of alumina_request(), made once.
const UnitCell &alumina_cell();

/// The same grains without friction and plasticity, made once.
const UnitCell &smooth_elastic_cell();

/// Table I of Sheng et al. (2004) with E = 70 GPa: 1000 grains of 136-264 um,
/// mu .3, p_y 0.5 GPa, packed at 100 kPa.
PackingRequest table_one_request(std::uint64_t seed);

/// Grains at random places of a random triclinic box, many of them overlapping,
/// with a contact history as if they had been pushed there.
UnitCell random_cell(std::size_t count, std::uint64_t seed);

/// A face-centred cubic packing of equal grains of radius 100 um, 3 x 3 x 3
/// cubes, whose contacts overlap by `overlap` times the distance of centres.
UnitCell fcc_cell(double overlap, const ContactModel &contact);

/// Every normal law with every tangential law, without and with a rolling law;
/// adhesion and damping for the laws that know them.
std::vector<ContactModel> every_contact_model();

/// Gives every other grain a stiffer, harder and heavier material.
void mix_species(UnitCell &cell);

/// exp(log_strain) along y, nothing across.
Stretch uniaxial(double log_strain);

/// Takes the cell along equal parts of a uniaxial path; the last answer, with
/// the evaluations of all parts, and the worst outcome of the parts.
CellAnswer
compress(UnitCell &cell, double log_strain, int parts, const Driving &driving);

/// The message of the exception that `call` throws; "" if it throws none.
template <class Exception, class Call>
std::string message_of(Call &&call)
{
  try {
    call();
  } catch (const Exception &error) {
    return error.what();
  }
  return "";
}
} // namespace tamp::dem::test

#endif
