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

/// Writes a new file, which is there with all its bytes, on the disk, or not
/// there at all. Throws FileError if it cannot be written or exists already;
/// an existing file is not touched.
void write_whole_file(const std::filesystem::path &file,
                      std::span<const char> bytes);
} // namespace tamp::coupling

#endif
