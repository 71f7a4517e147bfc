// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_template.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
namespace files = std::filesystem;

/// A new folder among the temporary files, gone with its owner.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    const files::path parent = files::temp_directory_path();
    for (unsigned i = 0; i < 100000; ++i) {
      path_ = parent / ("tamp_mesh_" + std::to_string(i));
      // Only one process can create it.
      if (files::create_directory(path_))
        return;
    }
    throw std::runtime_error("no room for temporary folders in '" +
                             parent.string() + "'; remove its tamp_mesh_*");
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    files::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  std::string file(const std::string &name) const { return path_ / name; }

private:
  files::path path_;
};

std::string read_all(const std::string &file)
{
  std::ifstream stream(file);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

/// An argument that a shell leaves as it is.
std::string quoted(const std::string &text)
{
  std::string result(1, '\'');
  for (const char c : text)
    if (c == '\'')
      result.append("'\\''");
    else
      result.push_back(c);
  result.push_back('\'');
  return result;
}

/// "R = 6e-3, nr = 8" as names and values.
std::map<std::string, std::string> parse(const std::string &parameters)
{
  const std::regex pair(
      R"(\s*([A-Za-z]\w*)\s*=\s*([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)\s*)");
  std::map<std::string, std::string> values;
  std::istringstream stream(parameters);
  std::string part;
  while (std::getline(stream, part, ',')) {
    std::smatch match;
    if (part.find_first_not_of(" \t") == std::string::npos)
      continue;
    if (!std::regex_match(part, match, pair))
      throw std::invalid_argument("mesh parameters: '" + part +
                                  "' is not of the form name = number; "
                                  "'R = 6e-3, nr = 8' is");
    if (!values.emplace(match[1], match[2]).second)
      throw std::invalid_argument("mesh parameters: '" + match[1].str() +
                                  "' is given twice");
  }
  return values;
}

/// Names that the geometry declares in its DefineConstant[...].
std::set<std::string> declared_names(const std::string &geometry)
{
  const std::regex block(R"(DefineConstant\s*\[([^\]]*)\])");
  const std::regex name(R"((?:^|,)\s*([A-Za-z]\w*)\s*=)");
  // Texts may hold braces, so they go before the values in braces.
  const std::regex text(R"("[^"]*")"), value(R"(\{[^}]*\})");
  std::set<std::string> names;
  const std::string bare = std::regex_replace(geometry, text, "0");
  for (std::sregex_iterator it(bare.begin(), bare.end(), block), end; it != end;
       ++it) {
    const std::string inner = std::regex_replace((*it)[1].str(), value, "0");
    for (std::sregex_iterator n(inner.begin(), inner.end(), name); n != end;
         ++n)
      names.insert((*n)[1]);
  }
  return names;
}

void check_declared(const std::string &file,
                    const std::map<std::string, std::string> &values)
{
  const std::set<std::string> declared = declared_names(read_all(file));
  std::string list;
  for (const std::string &name : declared)
    list += (list.empty() ? "" : ", ") + name;
  for (const auto &[name, value] : values)
    if (declared.count(name) == 0)
      throw std::invalid_argument(
          "mesh parameters: '" + name + "' is none of '" + file +
          "', which declares " +
          (list.empty() ? "none (DefineConstant[...])" : list));
}

/// gmsh's lines of a kind ("Error", "Warning"), joined.
std::string lines_of(const std::string &log, const std::string &kind)
{
  const std::regex line(kind + R"(\s*:\s*([^\n]*))");
  std::string result;
  unsigned count = 0;
  for (std::sregex_iterator it(log.begin(), log.end(), line), end;
       it != end && count < 3;
       ++it, ++count)
    result += (result.empty() ? "" : "; ") + (*it)[1].str();
  return result;
}

std::string
replaced(std::string text, const std::string &old, const std::string &now)
{
  const std::size_t at = text.find(old);
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}
} // namespace

bool has_gmsh()
{
  return std::system("command -v gmsh > /dev/null 2>&1") == 0;
}

ImportedMesh import_geometry(const std::string &file,
                             const std::string &parameters)
{
  if (!std::ifstream(file))
    throw std::runtime_error("cannot open geometry file '" + file + "'");
  const std::map<std::string, std::string> values = parse(parameters);
  check_declared(file, values);
  if (!has_gmsh())
    throw std::runtime_error("'" + file +
                             "' needs the program gmsh, which is not "
                             "installed (package gmsh); or give a mesh (.msh)");
  const TemporaryFolder folder;
  const std::string mesh = folder.file("mesh.msh");
  std::string command = "gmsh -3 -format msh41 -setnumber Mesh.Binary 0";
  for (const auto &[name, value] : values)
    command += " -setnumber " + name + " " + value;
  command.append(" ").append(quoted(files::absolute(file).string()));
  command.append(" -o ").append(quoted(mesh));
  command.append(" > ").append(quoted(folder.file("log"))).append(" 2>&1");
  const int status = std::system(command.c_str());
  const std::string log = read_all(folder.file("log"));
  const std::string errors = lines_of(log, "Error");
  if (status != 0 || !errors.empty() || !files::exists(mesh))
    throw std::runtime_error("gmsh cannot mesh '" + file + "': " +
                             (errors.empty() ? "it stopped early" : errors));
  try {
    ImportedMesh imported = import_mesh(mesh);
    const std::string warnings = lines_of(log, "Warning");
    if (!warnings.empty())
      imported.remarks.push_back("gmsh warns: " + warnings);
    return imported;
  } catch (const std::runtime_error &error) {
    throw std::runtime_error(replaced(error.what(), mesh, file));
  }
}
} // namespace tamp::fem
