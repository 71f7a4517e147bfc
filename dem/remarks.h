// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_remarks_h
#define dem_remarks_h

#include <dem/deform.h>
#include <dem/tensors.h>

#include <string>
#include <vector>

namespace tamp::dem
{
class UnitCell;

/// Something that a user should know about an answer.
struct Remark {
  enum class Kind {
    beyond_pair_laws,   ///< so dense that contacts feel each other
    not_quasi_static,   ///< inertia matters
    box_narrow,         ///< soon too narrow for nearest images
    yields_out_of_range ///< the pressure limit is beyond any small contact
  } kind;
  std::string text; ///< half a sentence with the value and the limit
  bool operator==(const Remark &) const = default;
};

/// All that is doubtful about a cell in a state of stress; empty if nothing is.
/// @param stress  Cauchy, tension positive [Pa]
std::vector<Remark>
judge(const UnitCell &cell, const Driving &driving, const Matrix3 &stress);
} // namespace tamp::dem

#endif
