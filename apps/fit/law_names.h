// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_law_names_h
#define apps_fit_law_names_h

#include <coupling/material_factory.h>

#include <algorithm>
#include <array>

namespace tamp::apps
{
/// A law that can be fitted: as --law names it, as Material/Type does, and its
/// subsection.
struct LawNames {
  const char *law, *type, *subsection;
  coupling::MaterialKind kind;
};

inline constexpr std::array<LawNames, 3> law_names{
    LawNames{"drucker-prager-cap",
             "drucker-prager cap",
             "Drucker-Prager cap",
             coupling::MaterialKind::drucker_prager_cap},
    LawNames{"modified-cam-clay",
             "modified cam-clay",
             "Modified Cam-Clay",
             coupling::MaterialKind::modified_cam_clay},
    LawNames{"fkm-gurson",
             "fkm-gurson",
             "FKM-Gurson",
             coupling::MaterialKind::fkm_gurson}};

/// @param kind  one of those above.
inline const LawNames &names_of(coupling::MaterialKind kind)
{
  return *std::ranges::find(law_names, kind, &LawNames::kind);
}
} // namespace tamp::apps

#endif
