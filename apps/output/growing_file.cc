// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/growing_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace tamp::apps
{
GrowingFile::GrowingFile(const std::filesystem::path &file) : file_(file)
{
  open(O_CREAT | O_TRUNC);
}

GrowingFile::GrowingFile(const std::filesystem::path &file, std::uint64_t size)
    : file_(file)
{
  open(O_APPEND);
  complete_ = static_cast<off_t>(size);
  const off_t there = ::lseek(descriptor_, 0, SEEK_END);
  if (there < complete_ || ::ftruncate(descriptor_, complete_) != 0) {
    const std::string problem =
        there < complete_
            ? fmt::format(
                  "it has {} bytes, at the checkpoint it had {}", there, size)
            : std::strerror(errno);
    ::close(descriptor_);
    throw OutputError(
        fmt::format("'{}' cannot be continued: {}", file.string(), problem));
  }
}

void GrowingFile::open(int flags)
{
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC | flags, 0644);
  if (descriptor_ < 0)
    throw OutputError(fmt::format(
        "'{}' cannot be written: {}", file_.string(), std::strerror(errno)));
}

void GrowingFile::sync() const
{
  ::fsync(descriptor_); // pipes and the like cannot, and need not
}

GrowingFile::~GrowingFile()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

void GrowingFile::append(std::span<const char> piece)
{
  const char *rest = piece.data();
  std::size_t left = piece.size();
  while (left > 0) {
    const ssize_t written = ::write(descriptor_, rest, left);
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0) {
      const int error = errno;
      // Nothing remains of a piece that was cut; where even this fails, the
      // file is no regular one.
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, complete_);
      throw OutputError(fmt::format(
          "'{}' cannot be written: {}", file_.string(), std::strerror(error)));
    }
    rest += written;
    left -= static_cast<std::size_t>(written);
  }
  complete_ += static_cast<off_t>(piece.size());
}
} // namespace tamp::apps
