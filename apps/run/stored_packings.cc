// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/run_material.h>
#include <apps/run/stored_packings.h>
#include <coupling/packing_file.h>
#include <coupling/packing_library.h>

#include <fmt/format.h>

namespace tamp::apps
{
void store_packings(RunSession &session,
                    std::size_t count,
                    const std::filesystem::path &folder)
{
  const coupling::MaterialChoice &choice = session.input().material;
  // Number i is taken from the file number i, modulo the number of files.
  std::vector<dem::PackingRequest> requests;
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t number = choice.first_packing + i;
    const auto file =
        folder / fmt::format("packing_{:04d}.h5", number % count + 1);
    if (std::filesystem::exists(file))
      continue;
    requests.push_back(coupling::sample_of(choice.packing, number));
    files.push_back(file);
  }
  RunLog &log = session.log();
  log.begin(packing_title(choice, count));
  try {
    const auto cells = coupling::make_packings(
        requests, session.threads(), [&](std::size_t made) {
          log.step(static_cast<double>(made) /
                       static_cast<double>(requests.size()),
                   static_cast<double>(made),
                   "packings",
                   "");
        });
    for (std::size_t i = 0; i < files.size(); ++i)
      coupling::write_packing(cells[i], files[i]);
  } catch (...) {
    rethrow_of_packing();
  }
  log.end();
}
} // namespace tamp::apps
