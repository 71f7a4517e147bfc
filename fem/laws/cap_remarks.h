// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_remarks_h
#define fem_laws_cap_remarks_h

#include <fem/laws/drucker_prager_cap.h>

#include <string>
#include <vector>

namespace tamp::fem
{
/// Something about the constants of a law that its user should know although
/// it is allowed.
struct Remark {
  std::string found;  ///< what, with its value and the bound
  std::string effect; ///< what the law does about it
  std::string remedy; ///< what can be done; empty if nothing need be

  /// All as one sentence.
  std::string text() const;
};

/// All that is doubtful or easily overlooked about the constants: a start
/// density that is not that of a row of the hardening table or lies outside a
/// table, tables that end before full density, and properties that change with
/// density in a way that makes the powder weaker.
std::vector<Remark> remarks(const DruckerPragerCapParameters &parameters);
} // namespace tamp::fem

#endif
