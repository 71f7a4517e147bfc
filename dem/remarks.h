// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_remarks_h
#define dem_remarks_h

#include <dem/deform.h>
#include <dem/grain_material.h>

#include <string>
#include <vector>

namespace tamp::dem
{
class UnitCell;

/// Something that a user should know about an answer.
struct Remark {
  enum class Kind {
    // Of a state: they come and go along a path.
    beyond_pair_laws, ///< so dense that contacts feel each other
    not_quasi_static, ///< inertia matters
    box_narrow,       ///< soon too narrow for nearest images
    // Of the grains and their laws: true from the start.
    yields_out_of_range, ///< the pressure limit is beyond any small contact
    adhesion_flattens    ///< adhesion alone makes contacts that are not small
  } kind;
  double value;          ///< what was found, in the unit of the bound
  double bound;          ///< what it should not pass
  std::string text = {}; ///< value, bound, what they mean and what can be done
  bool operator==(const Remark &) const = default;
};

/// Whether remarks of a kind are about a state, so that they have a place.
bool about_a_state(Remark::Kind kind);

/// Whether the first of two remarks of a kind is farther beyond the bound.
bool worse(const Remark &first, const Remark &second);

/// All that is doubtful about a cell; empty if nothing is.
/// @param pressure  mean compressive stress of the cell [Pa]
std::vector<Remark>
judge(const UnitCell &cell, const Driving &driving, double pressure);

/// All that is doubtful about the laws of the contacts of a pair.
/// @param reduced_radius  R* of the pair [m]
/// @param name            what the text calls the contacts
std::vector<Remark> judge_contacts(const ContactModel &model,
                                   const PairMaterial &pair,
                                   double reduced_radius,
                                   const std::string &name = "contacts");
} // namespace tamp::dem

#endif
