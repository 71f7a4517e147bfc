// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_library_h
#define coupling_packing_library_h

#include <coupling/packing_adoption.h>
#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <filesystem>
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

/// The request of a run's packing number `number`: with the seed of that
/// number.
dem::PackingRequest sample_of(const dem::PackingRequest &request,
                              std::size_t number);

/// The materials of a request, one per species.
std::vector<dem::GrainMaterial>
materials_of(const dem::PackingRequest &request);

/// Stored packings for `count` points.
struct StoredPackings {
  std::vector<dem::UnitCell> cells;
  History history = History::kept; ///< of the packing that lost most
};

/// Reads `files`, which points take in turn: point i the file number first + i,
/// and puts them under the request's materials and contact model. Throws as
/// read_packing() and adopt_packing() do, naming the file.
StoredPackings read_packings(const std::vector<std::filesystem::path> &files,
                             const dem::PackingRequest &request,
                             std::size_t count,
                             std::size_t first = 0);
} // namespace tamp::coupling

#endif
