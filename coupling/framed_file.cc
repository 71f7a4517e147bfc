// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/framed_file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <zlib.h>

namespace tamp::coupling
{
namespace
{
/// What stands before the bytes of a frame.
struct Head {
  std::uint64_t number = 0, size = 0;
  std::uint32_t checksum = 0; ///< of the bytes
  std::uint32_t own = 0;      ///< of this head up to here
};
/// The head at the end of a file has this size, and no bytes.
constexpr std::uint64_t ending = std::numeric_limits<std::uint64_t>::max();

std::span<const char> bytes_of(const Head &head)
{
  return {reinterpret_cast<const char *>(&head), sizeof head};
}

std::uint32_t checksum(std::span<const char> bytes)
{
  return static_cast<std::uint32_t>(crc32_z(
      0, reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size()));
}

Head head_of(std::uint64_t number, std::uint64_t size, std::uint32_t sum)
{
  Head head{number, size, sum, 0};
  head.own = checksum(bytes_of(head).first(offsetof(Head, own)));
  return head;
}

[[noreturn]] void damaged()
{
  throw std::invalid_argument("it is damaged or incomplete");
}

/// The first line, as far as it may be shown.
std::string shown(std::string line)
{
  constexpr std::size_t most = 60;
  line.resize(std::min(line.size(), most));
  const bool text = std::ranges::all_of(
      line, [](char letter) { return letter >= ' ' && letter <= '~'; });
  return text ? "'" + line + "'" : "no text";
}
} // namespace

FramedFileWriter::FramedFileWriter(const std::filesystem::path &file,
                                   const std::string &title)
    : file_(file)
{
  append(title + '\n');
}

void FramedFileWriter::append(std::span<const char> bytes)
{
  file_.append(bytes);
  size_ += bytes.size();
}

void FramedFileWriter::add(std::span<const char> bytes)
{
  append(bytes_of(head_of(number_++, bytes.size(), checksum(bytes))));
  append(bytes);
}

void FramedFileWriter::finish()
{
  append(bytes_of(head_of(number_, ending, 0)));
  file_.finish();
}

std::vector<char> framed(std::uint64_t number, std::span<const char> bytes)
{
  const Head head = head_of(number, bytes.size(), checksum(bytes));
  const auto begin = bytes_of(head);
  std::vector<char> result(begin.begin(), begin.end());
  result.insert(result.end(), bytes.begin(), bytes.end());
  return result;
}

FramedFileReader::FramedFileReader(const std::filesystem::path &file,
                                   const std::string &title,
                                   FramesEnd end)
    : name_(file), file_(file, std::ios::binary)
{
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (!file_ || error)
    throw FileError("cannot read '" + file.string() +
                    "': " + (error ? error.message() : std::strerror(errno)));
  std::string line(std::min<std::uint64_t>(size, title.size() + 1), ' ');
  file_.read(line.data(), static_cast<std::streamsize>(line.size()));
  if (line != title + '\n')
    throw std::invalid_argument("it begins with " +
                                shown(line.substr(0, line.find('\n'))) +
                                ", not with '" + title + "'");
  for (std::uint64_t place = line.size();;) {
    Head head;
    const bool grows = end == FramesEnd::anywhere;
    if (size - place < sizeof head && grows)
      return;
    if (size - place < sizeof head)
      damaged();
    file_.seekg(static_cast<std::streamoff>(place));
    file_.read(reinterpret_cast<char *>(&head), sizeof head);
    place += sizeof head;
    const Head wanted = head_of(frames_.size(), head.size, head.checksum);
    if (!file_ || head.number != wanted.number || head.own != wanted.own)
      damaged();
    if (head.size == ending && !grows) {
      if (place != size)
        damaged();
      return;
    }
    if (head.size > size - place && grows)
      return;
    if (head.size > size - place)
      damaged();
    frames_.push_back({place, head.size, head.checksum});
    read(frames_.back());
    place += head.size;
  }
}

std::vector<char> FramedFileReader::read(const Frame &frame)
{
  std::vector<char> bytes(frame.size);
  file_.seekg(static_cast<std::streamoff>(frame.begin));
  file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_ || checksum(bytes) != frame.checksum)
    damaged();
  return bytes;
}

std::vector<char> FramedFileReader::frame(std::size_t number)
{
  if (number >= frames_.size())
    damaged();
  return read(frames_[number]);
}
} // namespace tamp::coupling
