// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_framed_file_h
#define coupling_framed_file_h

#include <coupling/whole_file.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace tamp::coupling
{
/// Writes a file of frames: a title in the first line, then pieces of bytes,
/// each with its number, its length and a checksum (CRC-32 of zlib), then an
/// end. In the byte order of the machine. It is a WholeFile and throws the
/// same.
class FramedFileWriter
{
public:
  FramedFileWriter(const std::filesystem::path &file, const std::string &title);
  void add(std::span<const char> bytes);
  void finish();
  /// Bytes of the file so far.
  std::uint64_t size() const { return size_; }

private:
  void append(std::span<const char> bytes);

  WholeFile file_;
  std::uint64_t number_ = 0, size_ = 0;
};

/// A frame as it stands in a file: for files that grow, which begin with a
/// title and have no end.
std::vector<char> framed(std::uint64_t number, std::span<const char> bytes);

/// How a file of frames ends: as FramedFileWriter ends it; or after any frame,
/// of which the last one may be cut off, as a process that was killed leaves a
/// file that grows. A cut frame is passed over.
enum class FramesEnd { marked, anywhere };

/// Reads what FramedFileWriter or framed() wrote.
class FramedFileReader
{
public:
  /// Reads all of the file once. Throws FileError if it cannot be read, and
  /// std::invalid_argument, in words that say what it has, if the title is
  /// another one or the file is not whole, to the bit.
  FramedFileReader(const std::filesystem::path &file,
                   const std::string &title,
                   FramesEnd end = FramesEnd::marked);

  std::size_t frames() const { return frames_.size(); }
  /// Throws the same: files may be damaged while they are read.
  std::vector<char> frame(std::size_t number);

private:
  struct Frame {
    std::uint64_t begin = 0, size = 0;
    std::uint32_t checksum = 0;
  };
  std::vector<char> read(const Frame &frame);

  std::filesystem::path name_;
  std::ifstream file_;
  std::vector<Frame> frames_;
};
} // namespace tamp::coupling

#endif
