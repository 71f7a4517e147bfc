// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/check_sections.h>
#include <fem/mesh_quality.h>
#include <fem/punch_area.h>
#include <fem/tool_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tamp::apps
{
namespace
{
// Packings made below this pressure may collapse in the first steps.
constexpr double safe_start_pressure = 0.5e6;
constexpr double poor_shape = 0.3; // scaled Jacobian
constexpr double poor_aspect = 10; // longest over shortest edge
// Shares of the shortest edge.
constexpr double touching = 1e-3, deep = 0.1;

constexpr std::array<const char *, fem::number_of_tools> names{
    "upper punch", "lower punch", "die wall", "core rod"};

std::string name_of(const fem::DieGeometry &geometry)
{
  switch (geometry.shape) {
  case fem::DieShape::cylinder:
    return "cylinder";
  case fem::DieShape::ring:
    return "ring";
  case fem::DieShape::square:
    return "square";
  case fem::DieShape::file:
    return "mesh " + geometry.mesh_file;
  }
  return {};
}

std::string name_of(fem::Section section)
{
  return section == fem::Section::axisymmetric ? "axisymmetric"
         : section == fem::Section::quarter    ? "a quarter in three dimensions"
                                               : "all in three dimensions";
}

std::string friction_of(const fem::FrictionCoefficient &friction)
{
  const double least = friction.table.smallest();
  const double most = friction.table.largest();
  if (least == most)
    return fmt::format("{:.3g}", most);
  return fmt::format("{:.3g} to {:.3g}", least, most);
}

struct Gaps {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  std::size_t nodes = 0, inside = 0;
  unsigned deepest = 0;
};

// Of the nodes that touch the tool, and of all that are inside it.
Gaps gaps_of(const fem::ToolSurface &tool,
             const fem::Mesh &mesh,
             const fem::Mesh::Contact &contact,
             double edge)
{
  Gaps gaps;
  for (unsigned node = 0; node < mesh.nodes.size(); ++node) {
    const double distance = tool.nearest(mesh.nodes[node]).distance;
    const bool touches = std::ranges::binary_search(contact.nodes, node);
    if (distance < -touching * edge)
      ++gaps.inside;
    if (!touches && distance >= 0)
      continue;
    if (distance < gaps.least) {
      gaps.least = distance;
      gaps.deepest = node;
    }
    if (touches) {
      gaps.most = std::max(gaps.most, distance);
      ++gaps.nodes;
    }
  }
  return gaps;
}

void judge(CheckReport &report,
           const std::string &name,
           const Gaps &gaps,
           const fem::Mesh &mesh,
           double edge)
{
  const std::string place = fem::describe_place(mesh, mesh.nodes[gaps.deepest]);
  if (gaps.least < -deep * edge)
    report.failure(fmt::format(
        "{} nodes are inside the {}, the one at {} by {:.3g} mm; expected a "
        "mesh between the tools, to {:.2g} of its shortest edge",
        gaps.inside,
        name,
        place,
        -1e3 * gaps.least,
        deep));
  else if (gaps.inside > 0)
    report.doubt(fmt::format("{} nodes are inside the {}, the one at {} by "
                             "{:.3g} mm: the first step pushes them out",
                             gaps.inside,
                             name,
                             place,
                             -1e3 * gaps.least));
  if (gaps.most > deep * edge)
    report.doubt(fmt::format("faces of the {} are up to {:.3g} mm away from "
                             "it; expected them to touch",
                             name,
                             1e3 * gaps.most));
}
} // namespace

void say_die(CheckReport &report, const RunInput &input)
{
  const fem::Mesh &mesh = input.mesh.mesh;
  const fem::MeshQuality quality = fem::mesh_quality(mesh);
  report.section("Die");
  report.line("shape",
              fmt::format("{}, {}",
                          name_of(input.die.geometry),
                          name_of(mesh.section)));
  report.line("powder",
              fmt::format("{:.4g} mm3 below a punch of {:.4g} mm2",
                          1e9 * mesh.multiplicity() * fem::mesh_volume(mesh),
                          1e6 * fem::punch_area(mesh, fem::upper_punch)));
  report.line("mesh", fem::describe(quality));
  report.line("points, unknowns",
              fmt::format("{} material points, {} unknowns",
                          mesh.number_of_points(),
                          mesh.number_of_dofs()));
  report.line("worst cell", fem::describe_place(mesh, quality.worst_place));
  for (const std::string &remark : input.mesh.remarks)
    report.doubt(remark);
  const dem::PackingRequest &packing = input.material.packing;
  if (input.material.kind == coupling::MaterialKind::unit_cell &&
      input.material.packing_files.empty() &&
      packing.goal.target == dem::CompressionTarget::pressure &&
      packing.goal.pressure < safe_start_pressure)
    report.doubt(fmt::format("Packing/Pressure = {:.3g} MPa: packings this "
                             "loose may collapse in the first steps; 0.5 MPa "
                             "or more is safe",
                             packing.goal.pressure / 1e6));
  if (quality.scaled_jacobian < poor_shape)
    report.doubt(fmt::format("the smallest scaled Jacobian is {:.3g}, below "
                             "{:.3g}: cells this skew may invert as the powder "
                             "is pressed",
                             quality.scaled_jacobian,
                             poor_shape));
  if (quality.aspect_ratio > poor_aspect)
    report.doubt(fmt::format("the largest aspect ratio is {:.3g}, above {:.3g}",
                             quality.aspect_ratio,
                             poor_aspect));
}

void say_tools(CheckReport &report, const RunInput &input)
{
  const fem::Mesh &mesh = input.mesh.mesh;
  const double edge = fem::mesh_quality(mesh).shortest_edge;
  const fem::ToolSurfaces tools = fem::make_tools(input.die.geometry, mesh);
  report.section("Tools");
  for (unsigned tool = 0; tool < fem::number_of_tools; ++tool) {
    if (!tools[tool])
      continue;
    const Gaps gaps = gaps_of(*tools[tool], mesh, mesh.tools[tool], edge);
    report.line(names[tool],
                fmt::format("{} nodes touch it, gaps {:.2g} to {:.2g} um, "
                            "friction {}",
                            gaps.nodes,
                            // Nobody wants to read -0.
                            1e6 * gaps.least + 0,
                            1e6 * gaps.most + 0,
                            friction_of(input.die.friction[tool])));
    judge(report, names[tool], gaps, mesh, edge);
  }
  if (input.die.floating_die)
    report.line("die", "floating: friction alone carries it");
}

void say_stages(CheckReport &report,
                const std::string &title,
                const std::vector<ExpectedStage> &stages)
{
  report.section(title);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    report.line(
        fmt::format("stage {}", i + 1),
        fmt::format("{}; about {:.0f} steps", stages[i].text, stages[i].steps));
    if (!stages[i].doubt.empty())
      report.doubt(fmt::format("stage {}: {}", i + 1, stages[i].doubt));
  }
}
} // namespace tamp::apps
