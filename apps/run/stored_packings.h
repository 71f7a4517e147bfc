// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_stored_packings_h
#define apps_run_stored_packings_h

#include <apps/run/run_session.h>

#include <filesystem>
#include <vector>

namespace tamp::apps
{
/// Makes `count` packings of the session's input, from number Packing/Sample
/// on, and stores them in a folder, where runs with Packing/Source = file find
/// each as the packing that the input itself makes. Those that are there are
/// kept. Throws OutputError, and PackingError if grains do not jam.
void store_packings(RunSession &session,
                    std::size_t count,
                    const std::filesystem::path &folder);
} // namespace tamp::apps

#endif
