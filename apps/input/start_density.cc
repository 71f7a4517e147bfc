// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/start_density.h>

namespace tamp::apps
{
std::optional<double> start_density(const coupling::MaterialChoice &material)
{
  switch (material.kind) {
  case coupling::MaterialKind::unit_cell:
    return {};
  case coupling::MaterialKind::elastic:
    return material.elastic.initial_relative_density;
  case coupling::MaterialKind::drucker_prager_cap:
    return material.cap.initial_relative_density;
  case coupling::MaterialKind::modified_cam_clay:
    return material.cam_clay.initial_relative_density;
  case coupling::MaterialKind::fkm_gurson:
    return material.fkm_gurson.initial_relative_density;
  }
  return {};
}
} // namespace tamp::apps
