// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_library_h
#define coupling_packing_library_h

#include <coupling/packing_adoption.h>
#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace tamp::coupling
{
/// A packing for each of the requests, see sample_of().
/// @param made  called after each packing with the number done so far, from any
///              thread, never from two at once. May be empty.
std::vector<dem::UnitCell>
make_packings(std::span<const dem::PackingRequest> requests,
              unsigned threads,
              const std::function<void(std::size_t)> &made = {});

/// The request of a run's packing number `number`: with the seed
/// dem::seed_of(request.seed, number), so that a packing depends on the run's
/// seed and its number only.
dem::PackingRequest sample_of(const dem::PackingRequest &request,
                              std::size_t number);

/// The materials of a request, one per species.
std::vector<dem::GrainMaterial>
materials_of(const dem::PackingRequest &request);

/// Stored packings.
struct StoredPackings {
  std::vector<dem::UnitCell> cells;
  History history = History::kept; ///< of the packing that lost most
};

/// Reads the run's packings with these numbers, number i from the file number
/// i, or i modulo their number if there are fewer; and puts them under the
/// request's materials and contact model. Throws as read_packing() and
/// adopt_packing() do, naming the file.
StoredPackings read_packings(const std::vector<std::filesystem::path> &files,
                             const dem::PackingRequest &request,
                             std::span<const std::size_t> numbers);
} // namespace tamp::coupling

#endif
