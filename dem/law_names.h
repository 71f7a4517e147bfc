// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_law_names_h
#define dem_law_names_h

#include <array>

namespace tamp::dem
{
/// Names of contact laws in inputs and files, in the order of the enumerations
/// NormalLaw, TangentialLaw and RollingLaw.
inline constexpr std::array normal_law_names{"hertz",
                                             "thornton-ning",
                                             "jkr",
                                             "thornton-ning-jkr",
                                             "storakers",
                                             "mdr",
                                             "thornton-ning-adjusted"};
inline constexpr std::array tangential_law_names{
    "none", "mindlin", "mindlin-deresiewicz"};
inline constexpr std::array rolling_law_names{"none", "epsd"};
} // namespace tamp::dem

#endif
