// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/whole_file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

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
  ~Descriptor() { close(); }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;

  operator int() const { return number_; }
  bool close()
  {
    const int number = number_;
    number_ = -1;
    return number < 0 || ::close(number) == 0;
  }

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

void write_whole_file(const fs::path &file, std::span<const char> bytes)
{
  const fs::path part = file.string() + ".part";
  ::unlink(part.c_str()); // of a run that was cut off
  Descriptor out(part, O_WRONLY | O_CREAT | O_EXCL);
  if (out < 0)
    fail("write", file, errno);
  int error = 0;
  if (!write_all(out, bytes) || ::fsync(out) != 0 || !out.close())
    error = errno;
  else
    error = move_to_new(part, file);
  ::unlink(part.c_str());
  if (error != 0)
    fail("write", file, error);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (const Descriptor entries(folder, O_RDONLY | O_DIRECTORY); entries >= 0)
    ::fsync(entries);
}
} // namespace tamp::coupling
