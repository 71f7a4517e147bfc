// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_whole_file_h
#define coupling_whole_file_h

#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace tamp::coupling
{
/// A file that cannot be read or written, whatever is in it.
class FileError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// All bytes of a file. Throws FileError naming the file and the reason.
std::vector<char> read_whole_file(const std::filesystem::path &file);

/// A new file, which is there with all its bytes, on the disk, or not there at
/// all: it has another name until finish(). All functions throw FileError
/// naming the file and the reason.
class WholeFile
{
public:
  explicit WholeFile(std::filesystem::path file);
  /// Leaves nothing behind if finish() was not called or threw.
  ~WholeFile();
  WholeFile(const WholeFile &) = delete;
  WholeFile &operator=(const WholeFile &) = delete;

  void append(std::span<const char> bytes);
  /// Throws, too, if a file of this name exists: it is not touched.
  void finish();

private:
  void flush();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path file_, part_;
  std::vector<char> waiting_; ///< not written yet
  int descriptor_ = -1;
};

/// Writes a new file as a WholeFile. Throws FileError if it cannot be written
/// or exists already; an existing file is not touched.
void write_whole_file(const std::filesystem::path &file,
                      std::span<const char> bytes);
} // namespace tamp::coupling

#endif
