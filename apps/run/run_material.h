// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_run_material_h
#define apps_run_run_material_h

#include <apps/run/run_session.h>
#include <coupling/material_factory.h>
#include <fem/ranks.h>

#include <stdexcept>
#include <string>

namespace tamp::apps
{
/// A packing that does not jam: the program ends with exit code 3.
class PackingError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Makes the material points with these numbers of `all` points of a run, and
/// shows how far packing is. In a run that resumes, where a checkpoint has the
/// states, cells are all alike, of one packing. Throws PackingError if grains
/// do not jam. To be followed by warn_of_history().
coupling::Material prepare_material(RunSession &session,
                                    const fem::Share &points,
                                    std::size_t all);

/// To be called where an exception of making packings is handled: throws it as
/// what ends the run, OutputError for files, PackingError for grains that do
/// not jam; what is wrong with the input stays as it is.
[[noreturn]] void rethrow_of_packing();

/// How many different packings the points of a run need.
std::size_t different_packings(const coupling::MaterialChoice &choice,
                               std::size_t points);

/// "packing 3 x 1000 grains to 0.1 MPa", for the title of that work.
std::string packing_title(const coupling::MaterialChoice &choice,
                          std::size_t count);

/// Warns of a packing pressure at which cells may collapse when pressed.
void warn_of_loose_cells(RunSession &session);

/// Warns if stored packings are not as they were stored.
void warn_of_history(RunSession &session, coupling::History history);

/// Warns of what is easily overlooked in the tables of a continuum law.
void warn_of_law(RunSession &session);

/// What does not fit together in normal law and work of adhesion; else empty.
std::string adhesion_doubt(const dem::ContactModel &model);

/// What a limiting contact pressure that is adjusted to the density is, with
/// its values: a fit, no property of the grains. Empty for other normal laws.
std::string adjusted_pressure_doubt(const dem::PackingRequest &packing);

/// Warns of a work of adhesion and a normal law that do not fit together, and
/// of limiting contact pressures that are adjusted.
void warn_of_contact_model(RunSession &session);
} // namespace tamp::apps

#endif
