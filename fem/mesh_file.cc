// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_file.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Names = std::map<std::string, unsigned>;

[[noreturn]] void refuse(const std::string &file, const std::string &what)
{
  throw std::runtime_error("mesh file '" + file + "': " + what);
}

/// Throws if the file is not ASCII msh 2.2 or 4.1.
void check_format(const std::string &file, const std::string &content)
{
  std::istringstream lines(content);
  std::string line, version;
  int binary = 0;
  if (!std::getline(lines, line) || line.rfind("$MeshFormat", 0) != 0 ||
      !(lines >> version >> binary))
    refuse(file, "is not a gmsh file ($MeshFormat is missing)");
  if (binary != 0)
    refuse(file, "is binary; write it as ASCII");
  if (version.rfind("2", 0) != 0 && version.rfind("4", 0) != 0)
    refuse(file, "has the format " + version + "; 2.2 or 4.1 is expected");
}

/// Physical names of curves in the section $PhysicalNames.
Names names_of_curves(const std::string &content)
{
  Names names;
  const std::size_t start = content.find("$PhysicalNames");
  if (start == std::string::npos)
    return names;
  std::istringstream lines(content.substr(start));
  std::string line;
  std::getline(lines, line);
  std::size_t count = 0;
  lines >> count;
  for (std::size_t i = 0; i < count; ++i) {
    unsigned dimension = 0, tag = 0;
    if (!(lines >> dimension >> tag) || !std::getline(lines, line))
      break;
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (dimension == 1 && first < last)
      names[line.substr(first + 1, last - first - 1)] = tag;
  }
  return names;
}

ToolIds tool_ids(const std::string &file, const Names &names)
{
  std::string missing;
  for (const char *name : {"axis", "die_wall", "punch_top", "punch_bottom"})
    if (names.count(name) == 0)
      missing += (missing.empty() ? "'" : ", '") + std::string(name) + "'";
  if (!missing.empty())
    refuse(file,
           "has no physical curve " + missing +
               "; required are 'axis', 'die_wall', 'punch_top' and "
               "'punch_bottom'");
  return {names.at("axis"),
          names.at("die_wall"),
          names.at("punch_bottom"),
          names.at("punch_top")};
}
} // namespace

ToolIds read_mesh_file(const std::string &file,
                       dealii::Triangulation<2, 2> &triangulation)
{
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error("cannot open mesh file '" + file + "'");
  std::stringstream content;
  content << stream.rdbuf();
  check_format(file, content.str());
  const ToolIds ids = tool_ids(file, names_of_curves(content.str()));
  try {
    dealii::GridIn<2> reader;
    reader.attach_triangulation(triangulation);
    reader.read_msh(content);
  } catch (const std::exception &error) {
    refuse(file, std::string("cannot be read: ") + error.what());
  }
  for (const auto &cell : triangulation.active_cell_iterators())
    if (!cell->reference_cell().is_hyper_cube())
      refuse(file, "has cells that are not quadrilaterals; recombine them");
  return ids;
}
} // namespace tamp::fem
