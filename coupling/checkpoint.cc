// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/checkpoint.h>
#include <fem/state_bytes.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

namespace tamp::coupling
{
namespace
{
namespace fs = std::filesystem;

/// The number is that of the format: what the frames are.
const std::string first_line = "tamp checkpoint, format 1";
const std::string begin = "step_", suffix = ".tamp";
/// Frames before those of the points: title and state.
constexpr std::size_t frames_before_points = 2;

std::string name_of(unsigned step)
{
  std::ostringstream name;
  name << begin << std::setw(4) << std::setfill('0') << step << suffix;
  return name.str();
}

/// Checkpoints of a folder by their steps.
std::map<unsigned, fs::path> checkpoints_in(const fs::path &folder)
{
  std::map<unsigned, fs::path> found;
  std::error_code error;
  for (const auto &entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(begin) || !name.ends_with(suffix))
      continue;
    const char *end = name.data() + name.size() - suffix.size();
    unsigned step = 0;
    const auto read = std::from_chars(name.data() + begin.size(), end, step);
    if (read.ec == std::errc() && read.ptr == end)
      found.emplace(step, entry.path());
  }
  return found;
}

/// Also what a run that was killed was about to write. What cannot be removed
/// stays.
void remove_all_but(unsigned step, const fs::path &folder)
{
  std::error_code ignored;
  std::vector<fs::path> parts;
  for (const auto &entry : fs::directory_iterator(folder, ignored))
    if (const std::string name = entry.path().filename();
        name.starts_with(begin) && name.ends_with(suffix + ".part"))
      parts.push_back(entry.path());
  for (const fs::path &part : parts)
    fs::remove(part, ignored);
  const auto all = checkpoints_in(folder);
  const auto now = all.find(step);
  for (auto entry = all.begin(); entry != all.end(); ++entry)
    if (entry != now && std::next(entry) != now)
      fs::remove(entry->second, ignored);
}

std::vector<char> bytes_of(const CheckpointTitle &title)
{
  std::vector<char> bytes;
  fem::append_state(bytes, title.program);
  fem::append_state(bytes, title.input);
  fem::append_state(bytes, title.step);
  return bytes;
}

CheckpointTitle title_of(const std::vector<char> &bytes)
{
  CheckpointTitle title;
  fem::StateBytes in(bytes);
  in.take(title.program);
  in.take(title.input);
  in.take(title.step);
  return title;
}

/// How many points each rank has, on the first one; on another one, its own
/// number only.
std::vector<std::uint64_t> point_counts(const fem::MaterialPoints &points,
                                        const fem::Ranks &ranks)
{
  std::vector<std::uint64_t> counts;
  for (unsigned rank = 0; rank < ranks.size(); ++rank) {
    std::vector<char> bytes;
    fem::append_state(bytes, static_cast<std::uint64_t>(points.size()));
    ranks.move(bytes, rank, 0);
    fem::StateBytes(bytes).take(counts.emplace_back());
  }
  return counts;
}

FoundCheckpoint open(const fs::path &file, const std::string &program)
{
  FoundCheckpoint found{file, {}, FramedFileReader(file, first_line), {}};
  found.title = title_of(found.frames.frame(0));
  if (found.title.program != program)
    throw std::invalid_argument("it was written by tamp " +
                                found.title.program + ", this is tamp " +
                                program);
  return found;
}
} // namespace

std::uint64_t write_checkpoint(const fs::path &folder,
                               const CheckpointTitle &title,
                               std::span<const char> state,
                               const fem::MaterialPoints &points,
                               const fem::Ranks &ranks)
{
  // If the first rank fails to write, the others still send what they have.
  const fs::path file = folder / name_of(title.step);
  std::optional<FramedFileWriter> out;
  std::exception_ptr problem;
  const auto attempt = [&](const auto &deed) {
    if (ranks.rank() != 0 || problem)
      return;
    try {
      deed();
    } catch (const FileError &) {
      problem = std::current_exception();
    }
  };
  attempt([&] {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      throw FileError("cannot make the folder '" + folder.string() +
                      "': " + error.message());
    out.emplace(file, first_line);
    out->add(bytes_of(title));
    out->add(state);
  });
  const std::vector<std::uint64_t> counts = point_counts(points, ranks);
  for (unsigned rank = 0; rank < ranks.size(); ++rank)
    for (std::size_t i = 0; i < counts[rank]; ++i) {
      std::vector<char> bytes;
      if (rank == ranks.rank())
        points.pack(i, bytes);
      ranks.move(bytes, rank, 0);
      attempt([&] { out->add(bytes); });
    }
  attempt([&] {
    // One of this name is from before a run went back.
    std::error_code ignored;
    fs::remove(file, ignored);
    out->finish();
    remove_all_but(title.step, folder);
  });
  if (problem)
    std::rethrow_exception(problem);
  return out ? out->size() : 0;
}

std::optional<FoundCheckpoint> find_checkpoint(const fs::path &folder,
                                               const std::string &program)
{
  const auto all = checkpoints_in(folder);
  std::vector<std::string> passed_over;
  for (auto entry = all.rbegin(); entry != all.rend(); ++entry)
    try {
      FoundCheckpoint found = open(entry->second, program);
      found.passed_over = std::move(passed_over);
      return found;
    } catch (const std::exception &error) {
      passed_over.push_back("the checkpoint '" + entry->second.string() +
                            "' cannot be used: " + error.what());
    }
  if (all.empty())
    return {};
  std::string reasons;
  for (const std::string &reason : passed_over)
    reasons += (reasons.empty() ? "" : "; ") + reason;
  throw FileError(reasons);
}

std::vector<char> stored_state(FoundCheckpoint *found, const fem::Ranks &ranks)
{
  std::vector<char> state;
  if (found)
    state = found->frames.frame(1);
  ranks.spread(state);
  return state;
}

void unpack_points(FoundCheckpoint *found,
                   fem::MaterialPoints &points,
                   const fem::Ranks &ranks)
{
  const std::vector<std::uint64_t> counts = point_counts(points, ranks);
  std::size_t next = frames_before_points;
  for (unsigned rank = 0; rank < ranks.size(); ++rank)
    for (std::size_t i = 0; i < counts[rank]; ++i) {
      std::vector<char> bytes;
      if (found)
        bytes = found->frames.frame(next++);
      ranks.move(bytes, 0, rank);
      if (rank == ranks.rank())
        points.unpack(i, bytes);
    }
  if (found && next != found->frames.frames())
    throw std::runtime_error("the checkpoint '" + found->file.string() +
                             "' has another number of points");
}
} // namespace tamp::coupling
