// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_contact_body_h
#define tests_fem_contact_body_h

#include <fem/build_mesh.h>
#include <fem/tool_contact.h>

#include <random>
#include <string>

namespace tamp::fem::test
{
using Vector = dealii::Tensor<1, 3>;

inline constexpr double node_stiffness = 1e7; // [N/m]

struct Case {
  std::string name;
  DieGeometry geometry;
};

inline DieGeometry round_die(Section section)
{
  DieGeometry geometry;
  geometry.section = section;
  geometry.radial_elements = 3;
  geometry.axial_elements = 3;
  return geometry;
}

/// Flat, curved and conical tools in both kinds of section.
inline std::vector<Case> cases()
{
  std::vector<Case> result;
  for (const Section section : {Section::axisymmetric, Section::quarter}) {
    const std::string where = section == Section::quarter ? " 3-D" : " ring";
    DieGeometry flat = round_die(section);
    DieGeometry domed = flat, tapered = flat;
    domed.upper_face.kind = PunchFace::Kind::convex;
    domed.lower_face.kind = PunchFace::Kind::concave;
    domed.upper_face.radius = domed.lower_face.radius = 12e-3;
    tapered.exit_taper_angle = 0.1;
    tapered.exit_taper_length = 6e-3;
    result.push_back({"flat" + where, flat});
    result.push_back({"domed" + where, domed});
    result.push_back({"tapered" + where, tapered});
  }
  DieGeometry square = round_die(Section::quarter);
  square.shape = DieShape::square;
  square.corner_radius = 3e-3;
  result.push_back({"square", square});
  DieGeometry ring = round_die(Section::axisymmetric);
  ring.shape = DieShape::ring;
  result.push_back({"core", ring});
  return result;
}

/// mu = 0.4 falls to 0.1 with pressure: its slope matters.
inline FrictionCoefficient falling_with_pressure(double pressure)
{
  return {FrictionCoefficient::Of::pressure,
          DensityTable({{0, pressure}, {0.4, 0.1}}, "friction")};
}

inline Tools tools_of(const DieGeometry &geometry,
                      const Mesh &mesh,
                      const FrictionCoefficient &friction)
{
  Tools tools;
  tools.surfaces = make_tools(geometry, mesh);
  tools.friction.fill(friction);
  return tools;
}

/// Contact of a body whose nodes are where a test puts them.
struct Body {
  Mesh mesh;
  Tools tools;
  ToolContact contact;
  std::vector<double> stiffness, densities;
  NodePositions places;
  ToolPositions tool_places{};
  std::mt19937 engine{7};

  Body(const DieGeometry &geometry, const FrictionCoefficient &friction)
      : mesh(build_mesh(geometry)), tools(tools_of(geometry, mesh, friction)),
        contact(mesh, tools), stiffness(mesh.nodes.size(), node_stiffness),
        densities(mesh.nodes.size(), 0.5), places(mesh.nodes)
  {
  }

  double random()
  {
    return std::uniform_real_distribution<double>(-1, 1)(engine);
  }

  void begin() { contact.begin(stiffness, places, tool_places, densities); }
  std::vector<PairForce> forces() const
  {
    return contact.forces(places, tool_places);
  }
  SurfacePoint surface(std::size_t pair) const
  {
    const auto [node, tool, face] = contact.pairs()[pair];
    Vector place = places[node];
    place[2] -= tool_places[tool];
    return tools.surfaces[tool]->nearest(place, face);
  }

  /// Every node is moved by up to `slide` in any direction and then, along the
  /// normals, this far into the tools that it may touch.
  void push(double depth, double slide)
  {
    for (Vector &place : places)
      for (unsigned c = 0; c < mesh.components(); ++c)
        place[mesh.axis(c)] += slide * random();
    constexpr unsigned sweeps = 8; // for tools that meet
    for (unsigned sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t i = 0; i < contact.pairs().size(); ++i) {
        const SurfacePoint point = surface(i);
        places[contact.pairs()[i].node] -=
            (depth + point.distance) * point.normal;
      }
  }

  /// An accepted increment with some friction, and the next one begun.
  void settle(double depth)
  {
    begin();
    push(depth, depth);
    contact.accept(forces(), places);
    begin();
  }
};

} // namespace tamp::fem::test

#endif
