// SPDX-License-Identifier: BSD-3-Clause
#include <apps/curve_writer.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace tamp::apps
{
CurveWriter::CurveWriter(const std::filesystem::path &file,
                         const std::vector<std::string> &header,
                         const std::vector<std::string> &remarks)
    : file_(file), columns_(header.size())
{
  open(O_CREAT | O_TRUNC);
  for (const std::string &remark : remarks)
    append("# " + remark + "\n");
  append(fmt::format("{}\n", fmt::join(header, ",")));
}

CurveWriter::CurveWriter(const std::filesystem::path &file,
                         std::size_t columns,
                         std::uint64_t size)
    : file_(file), columns_(columns)
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

void CurveWriter::open(int flags)
{
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC | flags, 0644);
  if (descriptor_ < 0)
    throw OutputError(fmt::format(
        "'{}' cannot be written: {}", file_.string(), std::strerror(errno)));
}

void CurveWriter::sync() const
{
  ::fsync(descriptor_); // pipes and the like cannot, and need not
}

CurveWriter::~CurveWriter()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

void CurveWriter::append(const std::string &line)
{
  const char *rest = line.data();
  std::size_t left = line.size();
  while (left > 0) {
    const ssize_t written = ::write(descriptor_, rest, left);
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0) {
      const int error = errno;
      // Nothing remains of a line that was cut; where even this fails, the
      // file is no regular one.
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, complete_);
      throw OutputError(fmt::format(
          "'{}' cannot be written: {}", file_.string(), std::strerror(error)));
    }
    rest += written;
    left -= static_cast<std::size_t>(written);
  }
  complete_ += static_cast<off_t>(line.size());
}

void CurveWriter::write(std::span<const double> values)
{
  assert(values.size() == columns_);
  append(fmt::format("{}\n", fmt::join(values, ",")));
}
} // namespace tamp::apps
