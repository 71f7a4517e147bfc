// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_text_h
#define coupling_packing_text_h

#include <dem/unit_cell.h>

#include <string>

namespace tamp::coupling
{
/// A packing as text, see write_packing_text().
std::string packing_to_text(const dem::UnitCell &cell);

/// The packing of a text; `name` is that of its file, for messages. Throws
/// std::invalid_argument, "NAME:LINE: ...".
dem::UnitCell packing_from_text(const std::string &text,
                                const std::string &name);
} // namespace tamp::coupling

#endif
