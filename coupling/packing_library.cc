// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/packing_file.h>
#include <coupling/packing_library.h>
#include <coupling/work_sharing.h>
#include <dem/random_numbers.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <stdexcept>

namespace tamp::coupling
{
std::vector<dem::UnitCell>
make_packings(std::span<const dem::PackingRequest> requests,
              unsigned threads,
              const std::function<void(std::size_t)> &made)
{
  std::vector<dem::UnitCell> cells(requests.size());
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mutex reporting;
  std::size_t done = 0;
  share_work(order, threads, [&](std::size_t i) {
    cells[i] = dem::make_packing(requests[i]);
    const std::lock_guard lock(reporting);
    ++done;
    if (made)
      made(done);
  });
  return cells;
}

dem::PackingRequest sample_of(const dem::PackingRequest &request,
                              std::size_t number)
{
  dem::PackingRequest sample = request;
  sample.seed = dem::seed_of(request.seed, number);
  return sample;
}

std::vector<dem::GrainMaterial> materials_of(const dem::PackingRequest &request)
{
  std::vector<dem::GrainMaterial> materials{request.material};
  for (const dem::GrainPopulation &other : request.others)
    materials.push_back(other.material);
  return materials;
}

StoredPackings read_packings(const std::vector<std::filesystem::path> &files,
                             const dem::PackingRequest &request,
                             std::span<const std::size_t> numbers)
{
  StoredPackings stored;
  const auto materials = materials_of(request);
  for (const std::size_t number : numbers) {
    const auto &file = files[number % files.size()];
    stored.cells.push_back(read_packing(file));
    try {
      stored.history = std::max(
          stored.history,
          adopt_packing(stored.cells.back(), materials, request.contact));
    } catch (const std::invalid_argument &error) {
      throw std::invalid_argument(file.string() + ": " + error.what());
    } catch (const std::runtime_error &error) {
      throw std::runtime_error(file.string() + ": " + error.what());
    }
  }
  return stored;
}
} // namespace tamp::coupling
