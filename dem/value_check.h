// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_value_check_h
#define dem_value_check_h

#include <sstream>
#include <stdexcept>
#include <string>

namespace tamp::dem
{
/// Throws std::invalid_argument: "NAME = VALUE: must be EXPECTED".
[[noreturn]] inline void
refuse(const std::string &name, double value, const std::string &expected)
{
  std::ostringstream text;
  text << name << " = " << value << ": must be " << expected;
  throw std::invalid_argument(text.str());
}

/// Refuses what is not a positive number.
struct Positive {
  void operator()(double value, const char *name) const
  {
    if (!(value > 0))
      refuse(name, value, "positive");
  }
};
} // namespace tamp::dem

#endif
