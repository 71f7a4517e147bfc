// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_state_bytes_h
#define fem_state_bytes_h

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace tamp::fem
{
/// A value that is its bytes.
template <class Value>
concept Plain = std::is_trivially_copyable_v<Value>;

/// Appends a value as it stands in memory: for the same program to read, on a
/// machine of the same kind.
template <Plain Value>
void append_state(std::vector<char> &bytes, const Value &value)
{
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof value);
  std::memcpy(bytes.data() + end, &value, sizeof value);
}

/// The same for a vector, with its length.
template <Plain Value>
void append_state(std::vector<char> &bytes, const std::vector<Value> &values)
{
  append_state(bytes, static_cast<std::uint64_t>(values.size()));
  const std::size_t end = bytes.size(), more = values.size() * sizeof(Value);
  bytes.resize(end + more);
  if (more > 0)
    std::memcpy(bytes.data() + end, values.data(), more);
}

inline void append_state(std::vector<char> &bytes, const std::string &text)
{
  append_state(bytes, std::vector<char>(text.begin(), text.end()));
}

/// What append_state() wrote, read in the same order. All functions throw
/// std::runtime_error if the bytes end too soon.
class StateBytes
{
public:
  /// @param bytes  must outlive the object.
  explicit StateBytes(std::span<const char> bytes) : rest_(bytes) {}

  template <Plain Value>
  void take(Value &value)
  {
    std::memcpy(static_cast<void *>(&value),
                next(1, sizeof value).data(),
                sizeof value);
  }

  template <Plain Value>
  void take(std::vector<Value> &values)
  {
    std::uint64_t count = 0;
    take(count);
    const std::span<const char> from = next(count, sizeof(Value));
    values.resize(count);
    if (count > 0)
      std::memcpy(static_cast<void *>(values.data()), from.data(), from.size());
  }

  void take(std::string &text)
  {
    std::vector<char> letters;
    take(letters);
    text.assign(letters.begin(), letters.end());
  }

  /// What has not been read yet.
  std::span<const char> rest() const { return rest_; }
  bool empty() const { return rest_.empty(); }

private:
  std::span<const char> next(std::uint64_t count, std::size_t size)
  {
    if (count > rest_.size() / size)
      throw std::runtime_error("a stored state ends too soon");
    const auto result = rest_.first(count * size);
    rest_ = rest_.subspan(count * size);
    return result;
  }

  std::span<const char> rest_;
};
} // namespace tamp::fem

#endif
