// SPDX-License-Identifier: BSD-3-Clause
#include <fem/gmsh_file.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace tamp::fem
{
namespace
{
/// Throws if the file is not ASCII msh 2.2 or 4.1; the major version.
int check_format(const std::string &file, const std::string &content)
{
  std::istringstream lines(content);
  std::string line, version;
  int binary = 0;
  if (!std::getline(lines, line) || line.rfind("$MeshFormat", 0) != 0 ||
      !(lines >> version >> binary))
    throw mesh_error(file,
                     "is no gmsh mesh ($MeshFormat is missing); write it "
                     "with gmsh -format msh41");
  if (binary != 0)
    throw mesh_error(file, "is binary; write it as ASCII: gmsh -bin 0");
  if (version != "2.2" && version != "4.1")
    throw mesh_error(file,
                     "has the format " + version +
                         "; write it with gmsh -format msh41 or msh22");
  return version[0] - '0';
}

/// The text behind the line that opens a section.
std::istringstream open_section(const std::string &content,
                                const std::string &name)
{
  const std::size_t start = content.find("\n$" + name);
  std::istringstream section(
      start == std::string::npos ? "" : content.substr(start + 1));
  std::string line;
  std::getline(section, line);
  return section;
}

/// How many elements of each of gmsh's types the file has.
std::map<int, std::size_t> count_types(const std::string &content, int version)
{
  std::map<int, std::size_t> counts;
  std::istringstream section = open_section(content, "Elements");
  std::string rest;
  std::size_t lines = 0, number = 0;
  section >> lines;
  std::getline(section, rest);
  for (std::size_t i = 0; i < lines; ++i) {
    int type = 0;
    if (version == 2) { // number type ...
      if (!(section >> number >> type))
        break;
      std::getline(section, rest);
      ++counts[type];
    } else { // dimension entity type count, then the elements
      int dimension = 0, entity = 0;
      if (!(section >> dimension >> entity >> type >> number))
        break;
      std::getline(section, rest);
      for (std::size_t e = 0; e < number && std::getline(section, rest); ++e)
        ++counts[type];
    }
  }
  return counts;
}

constexpr int line_type = 1, quadrilateral = 3, hexahedron = 5, point_type = 15;

/// Throws unless the file has cells, and of one kind. True if hexahedra.
bool check_types(const std::string &file,
                 const std::map<int, std::size_t> &counts)
{
  const std::map<int, const char *> names{
      {2, "triangles"}, {4, "tetrahedra"}, {6, "prisms"}, {7, "pyramids"}};
  const char *recombine = "; recombine them (Recombine Surface, and layers "
                          "with Recombine in an Extrude)";
  for (const auto &[type, count] : counts) {
    if (names.count(type) != 0)
      throw mesh_error(
          file,
          std::string("has ") + names.at(type) + " (" + std::to_string(count) +
              ") where quadrilaterals or hexahedra are expected" + recombine);
    if (type != line_type && type != quadrilateral && type != hexahedron &&
        type != point_type)
      throw mesh_error(file,
                       "has " + std::to_string(count) +
                           " elements of gmsh's type " + std::to_string(type) +
                           "; only elements of first order are read: "
                           "Mesh.ElementOrder = 1");
  }
  if (counts.count(quadrilateral) + counts.count(hexahedron) == 0)
    throw mesh_error(file,
                     "has no quadrilaterals and no hexahedra; give the "
                     "powder a physical name: Physical Surface(\"powder\") or "
                     "Physical Volume(\"powder\")");
  return counts.count(hexahedron) > 0;
}

/// Physical names of things of a dimension in the section $PhysicalNames.
std::map<unsigned, std::string> read_names(const std::string &content,
                                           unsigned wanted)
{
  std::map<unsigned, std::string> names;
  std::istringstream section = open_section(content, "PhysicalNames");
  std::string line;
  std::size_t count = 0;
  section >> count;
  for (std::size_t i = 0; i < count; ++i) {
    unsigned dimension = 0, tag = 0;
    if (!(section >> dimension >> tag) || !std::getline(section, line))
      break;
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (dimension == wanted && first < last)
      names[tag] = line.substr(first + 1, last - first - 1);
  }
  return names;
}

/// deal.II's own words, without the banner around them.
std::string reason(const std::exception &error)
{
  const std::string text = error.what();
  if (text.find("CannotBeBoundary") != std::string::npos ||
      text.find("internal face") != std::string::npos)
    return "a named curve or surface lies inside the powder; only its "
           "boundary may have names";
  const std::string mark = "Additional information:";
  const std::size_t start = text.find(mark);
  std::istringstream words(
      start == std::string::npos ? text : text.substr(start + mark.size()));
  std::string word, result;
  while (words >> word && word.rfind("-----", 0) != 0)
    result += (result.empty() ? "" : " ") + word;
  return result;
}

/// Position in the file to position of the compact.
dealii::Tensor<1, 3> place(const dealii::Point<2> &vertex)
{
  return dealii::Tensor<1, 3>({vertex[0], 0, vertex[1]});
}

dealii::Tensor<1, 3> place(const dealii::Point<3> &vertex)
{
  return vertex;
}

template <int dim>
void read_cells(const std::string &file,
                const std::string &content,
                GmshFile &result)
{
  dealii::Triangulation<dim> grid;
  std::istringstream stream(content);
  try {
    dealii::GridIn<dim> reader;
    reader.attach_triangulation(grid);
    reader.read_msh(stream);
  } catch (const std::exception &error) {
    throw mesh_error(file, "cannot be read: " + reason(error));
  }
  for (const auto &vertex : grid.get_vertices())
    result.mesh.nodes.push_back(place(vertex));
  for (const auto &cell : grid.active_cell_iterators()) {
    for (const unsigned v : cell->vertex_indices())
      result.mesh.cells.push_back(cell->vertex_index(v));
    for (const auto &face : cell->face_iterators()) {
      if (!face->at_boundary())
        continue;
      FaceKey key{};
      for (const unsigned v : face->vertex_indices())
        key[v] = face->vertex_index(v);
      result.face_ids[face_key(key, face->n_vertices())] = face->boundary_id();
    }
  }
}

std::size_t count_nodes(const std::string &content, int version)
{
  std::istringstream section = open_section(content, "Nodes");
  std::size_t first = 0, second = 0;
  section >> first >> second; // 2.2: nodes; 4.1: blocks nodes
  return version == 2 ? first : second;
}
} // namespace

std::runtime_error mesh_error(const std::string &file, const std::string &what)
{
  return std::runtime_error("mesh file '" + file + "': " + what);
}

GmshFile read_gmsh_file(const std::string &file)
{
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error("cannot open mesh file '" + file + "'");
  std::stringstream whole;
  whole << stream.rdbuf();
  const std::string content = whole.str();
  const int version = check_format(file, content);
  const bool solid = check_types(file, count_types(content, version));
  GmshFile result;
  result.mesh.section = solid ? Section::full : Section::axisymmetric;
  result.names = read_names(content, solid ? 2 : 1);
  if (solid)
    read_cells<3>(file, content, result);
  else
    read_cells<2>(file, content, result);
  result.unused_nodes =
      count_nodes(content, version) - result.mesh.nodes.size();
  return result;
}
} // namespace tamp::fem
