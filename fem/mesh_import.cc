// SPDX-License-Identifier: BSD-3-Clause
#include <fem/gmsh_file.h>
#include <fem/mesh_defects.h>
#include <fem/mesh_faces.h>
#include <fem/mesh_import.h>
#include <fem/mesh_order.h>
#include <fem/mesh_quality.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace tamp::fem
{
namespace
{
/// Cells below this scaled Jacobian are refused, below the second remarked.
constexpr double refused_jacobian = 0.05, remarked_jacobian = 0.3;
/// Nodes this close to axis and planes of symmetry lie there, as a share of the
/// extent [-].
constexpr double snap = 1e-6;

/// The part of the boundary that a physical name stands for: a tool, or the
/// plane where a coordinate is zero and stays so.
struct Part {
  const char *name;
  std::optional<unsigned> tool;
  unsigned axis = 0;
};

std::vector<Part> parts_of(const Mesh &mesh)
{
  std::vector<Part> parts;
  for (unsigned tool = 0; tool < number_of_tools; ++tool)
    parts.push_back({tool_names[tool], tool});
  if (mesh.is_axisymmetric())
    parts.push_back({"axis", {}, 0});
  else {
    parts.push_back({"symmetry_x", {}, 0});
    parts.push_back({"symmetry_y", {}, 1});
  }
  return parts;
}

/// The numbers of the parts by physical number.
std::map<unsigned, Part> parts_by_id(const GmshFile &file)
{
  std::map<unsigned, Part> result;
  for (const Part &part : parts_of(file.mesh))
    for (const auto &[id, name] : file.names)
      if (name == part.name)
        result.emplace(id, part);
  return result;
}

/// Throws if a name that this kind of mesh needs is not there.
void check_names(const std::string &file, const GmshFile &read)
{
  const auto has = [&](const std::string &wanted) {
    return std::any_of(read.names.begin(),
                       read.names.end(),
                       [&](const auto &name) { return name.second == wanted; });
  };
  const bool flat = read.mesh.is_axisymmetric();
  const std::string kind = flat ? "curve" : "surface";
  std::string missing;
  std::vector<std::string> wanted{"die_wall", "punch_top", "punch_bottom"};
  if (flat && !has("core"))
    wanted.push_back("axis");
  for (const std::string &name : wanted)
    if (!has(name))
      missing += (missing.empty() ? "'" : ", '") + name + "'";
  if (!missing.empty())
    throw mesh_error(file,
                     "has no physical " + kind + " " + missing +
                         "; required are " +
                         "'die_wall', 'punch_top', 'punch_bottom'" +
                         (flat ? " and 'axis' (or 'core' for a ring)"
                               : "; 'core', and for a quarter 'symmetry_x' and "
                                 "'symmetry_y', may be there"));
  if (!flat && has("symmetry_x") != has("symmetry_y"))
    throw mesh_error(file,
                     "has only one of 'symmetry_x' and 'symmetry_y'; a "
                     "quarter has both, a full compact none");
}

/// Gives the boundary's faces to their parts; nodes on axis and planes are put
/// there exactly and held.
void find_parts(const std::string &file, double extent, GmshFile &read)
{
  Mesh &mesh = read.mesh;
  const std::map<unsigned, Part> parts = parts_by_id(read);
  std::map<unsigned, bool> used;
  std::map<std::pair<unsigned, unsigned>, bool> held;
  std::vector<MeshFace> bare;
  for (const MeshFace &face : boundary_faces(mesh)) {
    const unsigned id =
        read.face_ids.at(face_key(face.nodes, mesh.nodes_per_face()));
    const auto part = parts.find(id);
    if (part == parts.end()) {
      bare.push_back(face);
      continue;
    }
    used[id] = true;
    if (part->second.tool) {
      add_face(mesh, face, mesh.tools[*part->second.tool]);
      continue;
    }
    const unsigned axis = part->second.axis;
    for (unsigned v = 0; v < mesh.nodes_per_face(); ++v) {
      auto &node = mesh.nodes[face.nodes[v]];
      if (std::abs(node[axis]) > snap * extent)
        throw mesh_error(file,
                         std::string("'") + part->second.name + "' is not at " +
                             (mesh.is_axisymmetric() ? "r"
                              : axis == 0            ? "x"
                                                     : "y") +
                             " = 0: it has a node at " +
                             describe_place(mesh, node));
      node[axis] = 0;
      held[{face.nodes[v], axis}] = true;
    }
  }
  if (!bare.empty())
    throw mesh_error(file, describe_bare_faces(read, bare));
  for (const auto &[id, part] : parts)
    if (!used[id])
      throw mesh_error(file,
                       std::string("'") + part.name +
                           "' holds no face of the powder's boundary");
  for (const auto &entry : held)
    mesh.held.push_back({entry.first.first, entry.first.second});
  collect_nodes(mesh);
}

/// Throws if nodes lie beyond axis or planes of symmetry.
void check_side(const std::string &file, const Mesh &mesh, double extent)
{
  const unsigned axes = mesh.is_axisymmetric()             ? 1
                        : mesh.section == Section::quarter ? 2
                                                           : 0;
  for (const auto &node : mesh.nodes)
    for (unsigned axis = 0; axis < axes; ++axis)
      if (node[axis] < -snap * extent)
        throw mesh_error(
            file,
            std::string("has a node at negative ") +
                (mesh.is_axisymmetric() ? "r"
                 : axis == 0            ? "x"
                                        : "y") +
                ": " + describe_place(mesh, node) +
                "; draw the half section at x = r >= 0, a quarter at x >= 0, "
                "y >= 0");
}

void check_cells(const std::string &file, ImportedMesh &imported)
{
  const MeshQuality quality = mesh_quality(imported.mesh);
  std::ostringstream text;
  text.precision(2);
  text << "(scaled Jacobian " << quality.scaled_jacobian << ") at "
       << describe_place(imported.mesh, quality.worst_place);
  if (quality.scaled_jacobian <= 0)
    throw mesh_error(file, "has an inverted cell " + text.str());
  if (quality.scaled_jacobian < refused_jacobian)
    throw mesh_error(file,
                     "has a badly shaped cell " + text.str() +
                         "; 0.3 or more is good, 0.05 is the limit");
  if (quality.scaled_jacobian < remarked_jacobian)
    imported.remarks.push_back("The worst cell is poorly shaped " + text.str() +
                               "; 0.3 or more is good.");
}

/// Throws unless the defect is empty.
void refuse(const std::string &file, const std::string &defect)
{
  if (!defect.empty())
    throw mesh_error(file, defect);
}

/// Throws unless the upper punch stands above the lower one.
void check_punches(const std::string &file, const Mesh &mesh)
{
  const double upper = centre_of(mesh, mesh.tools[upper_punch].nodes)[2];
  const double lower = centre_of(mesh, mesh.tools[lower_punch].nodes)[2];
  if (upper <= lower)
    throw mesh_error(file,
                     "'punch_top' is not above 'punch_bottom'; z (y in a "
                     "file of quadrilaterals) is the pressing axis, upwards");
}

/// The largest dimension of the compact [m]; throws if it is flat.
double check_extent(const std::string &file, ImportedMesh &imported)
{
  const Mesh &mesh = imported.mesh;
  double largest = 0;
  for (const unsigned axis : {0u, 1u, 2u}) {
    if (axis == 1 && mesh.is_axisymmetric())
      continue;
    const auto [low, high] = std::minmax_element(
        mesh.nodes.begin(),
        mesh.nodes.end(),
        [&](const auto &a, const auto &b) { return a[axis] < b[axis]; });
    const double extent = (*high)[axis] - (*low)[axis];
    if (!(extent > 0))
      throw mesh_error(file,
                       mesh.is_axisymmetric()
                           ? "has no area in the xy plane; draw the half "
                             "section with x = r and y = z"
                           : "has no volume");
    largest = std::max(largest, extent);
  }
  if (largest > 1) {
    std::ostringstream text;
    text << "The compact is " << largest
         << " m large; if the mesh is in mm, write it in m "
            "(Mesh.ScalingFactor = 0.001).";
    imported.remarks.push_back(text.str());
  }
  return largest;
}
} // namespace

ImportedMesh import_mesh(const std::string &file)
{
  GmshFile read = read_gmsh_file(file);
  ImportedMesh imported;
  if (read.unused_nodes > 0)
    imported.remarks.push_back(
        "Nodes of the mesh file that belong to no cell were left out: " +
        std::to_string(read.unused_nodes) + ".");
  check_names(file, read);
  const bool quarter =
      std::any_of(read.names.begin(), read.names.end(), [](const auto &name) {
        return name.second == "symmetry_x";
      });
  if (!read.mesh.is_axisymmetric() && quarter)
    read.mesh.section = Section::quarter;
  imported.mesh = read.mesh;
  const double extent = check_extent(file, imported);
  check_side(file, read.mesh, extent);
  check_cells(file, imported);
  refuse(file, describe_joints(read.mesh));
  find_parts(file, extent, read);
  refuse(file, describe_islands(read.mesh));
  check_punches(file, read.mesh);
  renumber_from_below(read.mesh);
  imported.mesh = std::move(read.mesh);
  return imported;
}
} // namespace tamp::fem
