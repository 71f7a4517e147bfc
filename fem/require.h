// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_require_h
#define fem_require_h

#include <sstream>
#include <stdexcept>
#include <string>

namespace tamp::fem
{
/// Throws std::invalid_argument naming the parameter, its value and what was
/// expected, unless the value is possible.
template <class Value>
void require(bool possible,
             const std::string &name,
             const Value &value,
             const std::string &expected)
{
  if (possible)
    return;
  std::ostringstream message;
  message << name << " is " << value << "; expected " << expected;
  throw std::invalid_argument(message.str());
}
} // namespace tamp::fem

#endif
