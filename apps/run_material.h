// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_material_h
#define apps_run_material_h

#include <apps/run_session.h>
#include <coupling/material_factory.h>

#include <stdexcept>
#include <string>

namespace tamp::apps
{
/// A packing that does not jam: the program ends with exit code 3.
class PackingError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Makes the material points of a run, and shows how far packing is. Throws
/// PackingError if grains do not jam.
coupling::Material prepare_material(RunSession &session, std::size_t count);

/// The same for points that take their states from a checkpoint: cells are all
/// alike, of one packing.
coupling::Material stand_ins(RunSession &session, std::size_t count);

/// The same for one point out of a run of many.
coupling::Material prepare_point(RunSession &session, std::size_t point);

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

/// Warns of a work of adhesion and a normal law that do not fit together.
void warn_of_contact_model(RunSession &session);
} // namespace tamp::apps

#endif
