// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_expect_value_h
#define fem_laws_expect_value_h

#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
/// Throws std::invalid_argument unless `good`: name, value, what was expected.
inline void expect_value(const bool good,
                         const char *name,
                         const double value,
                         const char *expected)
{
  if (good)
    return;
  std::ostringstream text;
  text << name << ' ' << value << ": expected " << expected;
  throw std::invalid_argument(text.str());
}
} // namespace tamp::fem

#endif
