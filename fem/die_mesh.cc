// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_mesh.h>
#include <fem/mesh_template.h>

namespace tamp::fem
{
ImportedMesh die_mesh(const DieGeometry &geometry)
{
  const std::string &file = geometry.mesh_file;
  if (file.empty())
    return {build_mesh(geometry), {}};
  if (file.ends_with(".geo"))
    return import_geometry(file, geometry.mesh_parameters);
  return import_mesh(file);
}
} // namespace tamp::fem
