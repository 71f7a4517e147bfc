// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/whole_file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace tamp::coupling
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string &deed, const fs::path &file, int error)
{
  throw FileError("cannot " + deed + " '" + file.string() +
                  "': " + std::strerror(error));
}

/// A file descriptor that is closed at the end.
class Descriptor
{
public:
  Descriptor(const fs::path &file, int flags)
      : number_(::open(file.c_str(), flags | O_CLOEXEC, 0666))
  {
  }
  ~Descriptor()
  {
    if (number_ >= 0)
      ::close(number_);
  }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;

  operator int() const { return number_; }

private:
  int number_;
};

bool write_all(int descriptor, std::span<const char> bytes)
{
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR)
      continue;
    if (done < 0)
      return false;
    bytes = bytes.subspan(std::size_t(done));
  }
  return true;
}
/// Gives a file a name that is not taken; 0 or what went wrong.
int move_to_new(const fs::path &from, const fs::path &to)
{
  if (::renameat2(
          AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
    return 0;
  if (errno != EINVAL && errno != ENOSYS)
    return errno;
  // The file system cannot do both at once.
  std::error_code ignored;
  if (fs::exists(to, ignored))
    return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}
} // namespace

std::vector<char> read_whole_file(const fs::path &file)
{
  const Descriptor in(file, O_RDONLY);
  if (in < 0)
    fail("read", file, errno);
  std::vector<char> bytes;
  for (std::size_t size = 0;;) {
    bytes.resize(size + (1 << 16));
    const ssize_t got = ::read(in, &bytes[size], bytes.size() - size);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      fail("read", file, errno);
    size += std::size_t(got);
    if (got == 0) {
      bytes.resize(size);
      return bytes;
    }
  }
}

WholeFile::WholeFile(fs::path file)
    : file_(std::move(file)), part_(file_.string() + ".part")
{
  ::unlink(part_.c_str()); // of a run that was cut off
  descriptor_ =
      ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    fail(errno);
}

WholeFile::~WholeFile()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (!part_.empty())
    ::unlink(part_.c_str());
}

void WholeFile::fail(int error) const
{
  coupling::fail("write", file_, error);
}

void WholeFile::append(std::span<const char> bytes)
{
  constexpr std::size_t many = 1 << 20;
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  if (waiting_.size() >= many)
    flush();
}

void WholeFile::flush()
{
  if (!write_all(descriptor_, waiting_))
    fail(errno);
  waiting_.clear();
}

void WholeFile::finish()
{
  flush();
  const int descriptor = std::exchange(descriptor_, -1);
  const bool synced = ::fsync(descriptor) == 0;
  const int error = synced ? 0 : errno;
  if (::close(descriptor) != 0 || !synced)
    fail(synced ? errno : error);
  if (const int problem = move_to_new(part_, file_); problem != 0)
    fail(problem);
  part_.clear();
  const fs::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
  if (const Descriptor entries(folder, O_RDONLY | O_DIRECTORY); entries >= 0)
    ::fsync(entries);
}

void write_whole_file(const fs::path &file, std::span<const char> bytes)
{
  WholeFile out(file);
  out.append(bytes);
  out.finish();
}
} // namespace tamp::coupling
