// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/input_sections.h>
#include <apps/input/parameter_table.h>
#include <fem/laws/density_table.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
using fem::FrictionCoefficient;
using fem::PunchFace;

// Order as in fem::DieShape and fem::Section.
const std::vector<std::string> shapes{"cylinder", "ring", "square", "file"};
const std::vector<std::string> sections{"axisymmetric", "quarter", "full"};

constexpr Range an_angle{0, std::numbers::pi / 2, false, true};

void declare_punches(ParameterTable &table)
{
  const std::string faces =
      "Its face: flat; convex R or concave R (a dome that stands out, a cup; "
      "radius of curvature); chamfer W (a rim of width W that stands out at 45 "
      "degrees); bevel W ANGLE. For example: concave 8 mm, or bevel 0.4 mm 30 "
      "deg";
  table.text("Upper punch", "flat", faces);
  table.text("Lower punch", "flat", faces);
}

void declare_friction(ParameterTable &table)
{
  const std::string how =
      ": a constant, or a table: of density 0.3: 0.92, 0.5: 0.19, 0.9: 0.16, "
      "or of pressure 1 MPa: 0.4, 100 MPa: 0.2; straight between the entries, "
      "constant beyond";
  table.text("Wall friction coefficient",
             "0.2",
             "mu between powder and die wall, also core rod" + how);
  table.text("Punch friction coefficient",
             "0",
             "mu between powder and both punches" + how);
}

void declare_lengths(ParameterTable &table)
{
  table.quantity("Radius",
                 "6 mm",
                 dimension::length,
                 positive,
                 "Of the bore, cylinder and ring");
  table.quantity("Core radius",
                 "2 mm",
                 dimension::length,
                 positive,
                 "Of the core rod, ring; it moves with the die");
  table.quantity(
      "Side", "12 mm", dimension::length, positive, "Of a square die");
  table.quantity("Corner radius",
                 "1 mm",
                 dimension::length,
                 not_negative,
                 "Of the vertical edges of a square die");
  table.quantity(
      "Fill height",
      "7 mm",
      dimension::length,
      positive,
      "Of the powder at the start, from edge to edge of the punches; "
      "the die's rim is there");
  table.text(
      "Initial density",
      "",
      "Relative density at the start where the die is filled unevenly: a "
      "formula of x, y, z and r in m, for example 0.36 - 2*z + if(r < "
      "0.002, 0.01, 0); a half section has x = r. Unit cells are packed "
      "to it, at the pressure that this takes; empty: as Packing or the "
      "law say");
  table.text(
      "Initial density file",
      "",
      "The same from a table: CSV with a header r[mm], z[mm], "
      "relative_density[-], or x[mm], y[mm], z[mm], relative_density[-], and a "
      "line for every place of a rectilinear grid that covers the powder; "
      "linear in between; the path starts at the input's folder");
  table.quantity("Exit taper angle",
                 "0 deg",
                 dimension::angle,
                 an_angle,
                 "At which the bore widens towards its rim, against the "
                 "pressing axis; eases ejection");
  table.quantity("Exit taper length",
                 "0 mm",
                 dimension::length,
                 not_negative,
                 "Of the taper, from the rim down");
}

std::vector<std::string_view> split(std::string_view text, char at)
{
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos)
      return parts;
    text.remove_prefix(end + 1);
  }
}

// Splits "0.4 mm 30 deg" after its first unit.
std::pair<std::string, std::string> two_quantities(const std::string &text)
{
  const std::size_t first = text.find_first_not_of("0123456789.eE+- ");
  const std::size_t space = text.find(' ', std::min(first, text.size()));
  if (space == std::string::npos)
    return {text, ""};
  return {text.substr(0, space), text.substr(space + 1)};
}

/// parse_quantity() that says what it expected.
double expect_quantity(std::string_view text, const Dimension &dimension)
{
  try {
    return parse_quantity(text, dimension);
  } catch (const InputError &error) {
    throw InputError(
        fmt::format("{}; expected {}", error.what(), described(dimension)));
  }
}

PunchFace parse_face(const std::string &text)
{
  using Kind = PunchFace::Kind;
  PunchFace face;
  const std::size_t space = text.find(' ');
  const std::string kind = text.substr(0, space);
  const std::string rest(
      trimmed(space == std::string::npos ? "" : text.substr(space)));
  if (kind == "flat") {
    if (!rest.empty())
      throw InputError("a flat face takes no number");
    return face;
  }
  if (kind != "convex" && kind != "concave" && kind != "chamfer" &&
      kind != "bevel")
    throw InputError("expected flat, convex R, concave R, chamfer W or bevel W "
                     "ANGLE");
  if (rest.empty())
    throw InputError(
        fmt::format("expected a length after '{}', for example {} {}",
                    kind,
                    kind,
                    kind == "bevel" ? "0.4 mm 30 deg" : "8 mm"));
  if (kind == "bevel") {
    const auto [width, angle] = two_quantities(rest);
    if (angle.empty())
      throw InputError("expected a width and an angle after 'bevel', for "
                       "example bevel 0.4 mm 30 deg");
    face.kind = Kind::bevel;
    face.width = expect_quantity(width, dimension::length);
    face.angle = expect_quantity(angle, dimension::angle);
    return face;
  }
  const double length = expect_quantity(rest, dimension::length);
  if (kind == "chamfer") {
    face.kind = Kind::chamfer;
    face.width = length;
  } else {
    face.kind = kind == "convex" ? Kind::convex : Kind::concave;
    face.radius = length;
  }
  return face;
}

FrictionCoefficient parse_friction(const std::string &text)
{
  using Of = FrictionCoefficient::Of;
  std::string_view rest = trimmed(text);
  if (rest.rfind("of ", 0) != 0) {
    const double mu = expect_quantity(rest, dimension::number);
    if (mu < 0)
      throw InputError("expected a coefficient that is not negative");
    return FrictionCoefficient(mu);
  }
  rest = trimmed(rest.substr(3));
  const bool pressure = rest.rfind("pressure ", 0) == 0;
  if (!pressure && rest.rfind("density ", 0) != 0)
    throw InputError("expected 'of density' or 'of pressure'");
  rest = rest.substr(pressure ? 9 : 8);
  fem::TableRows rows;
  for (const std::string_view entry : split(rest, ',')) {
    const auto parts = split(entry, ':');
    if (parts.size() != 2)
      throw InputError(fmt::format(
          "expected entries 'place: mu' divided by commas, found '{}'", entry));
    rows.x.push_back(expect_quantity(
        parts[0], pressure ? dimension::pressure : dimension::number));
    rows.y.push_back(expect_quantity(parts[1], dimension::number));
    if (rows.y.back() < 0)
      throw InputError(fmt::format(
          "expected coefficients that are not negative, found '{}'", entry));
  }
  return {pressure ? Of::pressure : Of::density,
          fem::DensityTable(std::move(rows), "friction coefficient")};
}

/// Reads an entry with one of the parsers above.
template <class Parser>
auto parsed(const ParameterTable &table,
            const std::string &path,
            const Parser &parse)
{
  try {
    return parse(table.word(path));
  } catch (const InputError &error) {
    table.complain(path, error.what());
  } catch (const std::invalid_argument &error) {
    table.complain(path, error.what());
  }
}

void read_elements(const ParameterTable &table, fem::DieGeometry &geometry)
{
  const auto elements = table.indices("Die/Elements");
  if (elements.size() != 2 || elements[0] == 0 || elements[1] == 0)
    table.complain("Die/Elements",
                   "expected two whole numbers > 0, along the radius and "
                   "along the height, for example 4, 7");
  geometry.radial_elements = static_cast<unsigned>(elements[0]);
  geometry.axial_elements = static_cast<unsigned>(elements[1]);
}

void read_mesh_file(const ParameterTable &table, fem::DieGeometry &geometry)
{
  const std::string mesh = table.word("Die/Mesh file");
  const bool from_file = geometry.shape == fem::DieShape::file;
  if (mesh.empty() && from_file)
    table.complain("Die/Shape", "expected Die/Mesh file to name a mesh");
  if (mesh.empty())
    return;
  const auto path = table.folder("Die/Mesh file") / mesh;
  if (!std::filesystem::is_regular_file(path))
    table.complain("Die/Mesh file",
                   "there is no file '" + path.string() +
                       "'; expected a gmsh mesh (.msh) or geometry (.geo)");
  if (!from_file)
    table.complain("Die/Mesh file",
                   "it needs Die/Shape = file, which is " +
                       table.word("Die/Shape"));
  geometry.mesh_file = path.string();
  geometry.mesh_parameters = table.word("Die/Mesh parameters");
}
} // namespace

void declare_die_shape(ParameterTable &table)
{
  table.enter("Die");
  table.choice("Shape",
               "cylinder",
               shapes,
               "cylinder: Radius; ring: Radius and Core radius; square: Side "
               "and Corner radius; file: as the mesh of the powder has it");
  table.choice("Symmetry",
               "axisymmetric",
               sections,
               "What is computed of the compact: half a section with ring "
               "elements, a quarter or all of it in three dimensions");
  declare_lengths(table);
  declare_punches(table);
  table.text("Mesh file",
             "",
             "A gmsh mesh (.msh) of quadrilaterals (x = r, y = z) or hexahedra "
             "with the physical names punch_top, punch_bottom, die_wall and "
             "axis, core, symmetry_x, symmetry_y where there are such; or a "
             "geometry (.geo) that gmsh meshes; the path starts at the input's "
             "folder");
  table.text("Mesh parameters",
             "",
             "Numbers for a .geo file, for example R = 6e-3, nr = 8");
  table.integers("Elements",
                 "4, 7",
                 "Elements along the radius (half the side) and along the "
                 "height; each has four material points, in three dimensions "
                 "eight");
  declare_friction(table);
  table.leave();
}

void read_die_shape(const ParameterTable &table, fem::DieSettings &die)
{
  fem::DieGeometry &geometry = die.geometry;
  geometry.shape = chosen<fem::DieShape>(table, "Die/Shape", shapes);
  geometry.section = chosen<fem::Section>(table, "Die/Symmetry", sections);
  if (geometry.shape == fem::DieShape::square &&
      geometry.section == fem::Section::axisymmetric)
    table.complain("Die/Symmetry",
                   "a square is not axisymmetric; expected quarter or full");
  geometry.radius = table.number("Die/Radius");
  geometry.core_radius = table.number("Die/Core radius");
  geometry.side = table.number("Die/Side");
  geometry.corner_radius = table.number("Die/Corner radius");
  geometry.fill_height = table.number("Die/Fill height");
  geometry.exit_taper_angle = table.number("Die/Exit taper angle");
  geometry.exit_taper_length = table.number("Die/Exit taper length");
  geometry.upper_face = parsed(table, "Die/Upper punch", parse_face);
  geometry.lower_face = parsed(table, "Die/Lower punch", parse_face);
  read_elements(table, geometry);
  read_mesh_file(table, geometry);
  const auto wall =
      parsed(table, "Die/Wall friction coefficient", parse_friction);
  const auto punch =
      parsed(table, "Die/Punch friction coefficient", parse_friction);
  die.friction = {punch, punch, wall, wall};
}
} // namespace tamp::apps
