// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_library_h
#define coupling_packing_library_h

#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace tamp::coupling
{
/// A packing for each of `count` points. Point i gets the seed
/// dem::seed_of(request.seed, first + i), so a packing depends on the run's
/// seed and its number only; or all points share the first packing if `same` is
/// set.
/// @param made  called after each packing with the number done so far, from any
///              thread, never from two at once. May be empty.
std::vector<dem::UnitCell>
make_packings(const dem::PackingRequest &request,
              std::size_t count,
              bool same,
              unsigned threads,
              const std::function<void(std::size_t)> &made = {},
              std::size_t first = 0);
} // namespace tamp::coupling

#endif
