// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_checkpoint_h
#define coupling_checkpoint_h

#include <coupling/framed_file.h>
#include <fem/material_points.h>
#include <fem/ranks.h>

#include <optional>
#include <string>
#include <vector>

namespace tamp::coupling
{
/// What a checkpoint is of.
struct CheckpointTitle {
  std::string program; ///< its version: states are as it has them in memory
  std::string input;   ///< all that the run was told
  unsigned step = 0;
};

/// Makes the folder if need be and writes `folder`/step_NNNN.tamp: the title,
/// `state` of the first rank, then the committed state of every point, in the
/// order of the ranks. Of older checkpoints the newest one is kept, the others
/// are removed; so are those of later steps, from before a run went back.
/// Collective; the first rank writes. There it throws FileError if that is not
/// possible, in which case the older ones are as they were. @return bytes
/// written, on the first rank.
std::uint64_t write_checkpoint(const std::filesystem::path &folder,
                               const CheckpointTitle &title,
                               std::span<const char> state,
                               const fem::MaterialPoints &points,
                               const fem::Ranks &ranks);

/// A checkpoint that was read and found whole.
struct FoundCheckpoint {
  std::filesystem::path file;
  CheckpointTitle title;
  FramedFileReader frames;
  /// Newer ones that cannot be used, each with the reason, in a sentence.
  std::vector<std::string> passed_over;
};

/// The newest checkpoint in a folder that is good and of this program; none if
/// there are no checkpoints at all. Throws FileError, with the reason for each,
/// if there are but none can be used.
std::optional<FoundCheckpoint>
find_checkpoint(const std::filesystem::path &folder,
                const std::string &program);

/// The state that was handed to write_checkpoint(), on all ranks. Collective.
/// @param found  on the first rank; null on the others.
std::vector<char> stored_state(FoundCheckpoint *found, const fem::Ranks &ranks);

/// Gives the points their states, on any number of ranks. Throws
/// std::runtime_error if their number is another or a state is none.
/// Collective.
void unpack_points(FoundCheckpoint *found,
                   fem::MaterialPoints &points,
                   const fem::Ranks &ranks);
} // namespace tamp::coupling

#endif
