// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_growing_file_h
#define apps_output_growing_file_h

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <sys/types.h>

namespace tamp::apps
{
/// A file or folder that cannot be written: the program ends with exit code 4.
class OutputError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file that grows piece by piece while a run goes on. A piece is on disk as
/// a whole or not at all, unless the process is killed while it writes. All
/// functions throw OutputError naming the file and the reason.
class GrowingFile
{
public:
  /// A new file, in place of one of this name.
  explicit GrowingFile(const std::filesystem::path &file);
  /// Goes on with a file: what stands in it after `size` bytes is removed.
  /// Throws, too, if it has fewer.
  GrowingFile(const std::filesystem::path &file, std::uint64_t size);
  ~GrowingFile();
  GrowingFile(const GrowingFile &) = delete;
  GrowingFile &operator=(const GrowingFile &) = delete;

  void append(std::span<const char> piece);

  /// Bytes of all pieces so far.
  std::uint64_t size() const { return static_cast<std::uint64_t>(complete_); }
  /// Has all pieces on the disk, as far as the system can tell.
  void sync() const;

private:
  void open(int flags);

  std::filesystem::path file_;
  int descriptor_ = -1;
  off_t complete_ = 0; // bytes of all pieces so far
};
} // namespace tamp::apps

#endif
