// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_run_resume_h
#define apps_run_run_resume_h

#include <coupling/checkpoint.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// All that a run is told: its parameters in SI, and a hash of each file that
/// they name.
std::string whole_input(const std::string &echo,
                        const std::vector<std::filesystem::path> &files);

/// The entries of such an input that have an effect on the results, one a line:
/// differences() reads them as it reads the input itself.
std::string effective_input(const std::string &input);

/// What differs between two such inputs, entry by entry, "Section/Name = now,
/// was then"; empty if they give the same run: when checkpoints are written and
/// plots are drawn does not matter.
std::string differences(const std::string &now, const std::string &then);

/// The newest good checkpoint in the folder of a run. Touches nothing. Throws
/// InputError if the folder is not one of a run or has no checkpoint, or if the
/// input is another one; OutputError if no checkpoint can be used.
coupling::FoundCheckpoint find_to_resume(const std::filesystem::path &folder,
                                         const std::string &input);
} // namespace tamp::apps

#endif
