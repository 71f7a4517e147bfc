// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/tool_surface.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
using Kind = PunchFace::Kind;

/// Shape functions of a cell at a place in [-1, 1]^dim, or their derivatives
/// along an axis.
double shape(unsigned node,
             const Vector &place,
             unsigned dim,
             std::optional<unsigned> along = {})
{
  double value = 1;
  for (unsigned axis = 0; axis < dim; ++axis) {
    const double side = node & (1u << axis) ? 1 : -1;
    value *= along == axis ? 0.5 * side : 0.5 * (1 + side * place[axis]);
  }
  return value;
}

Vector corner(unsigned node, double scale)
{
  Vector place;
  for (unsigned axis = 0; axis < 3; ++axis)
    place[axis] = node & (1u << axis) ? scale : -scale;
  return place;
}

/// A press of cellulose (Drucker-Prager cap), step by step.
struct Compaction {
  DieSettings settings;
  Mesh mesh;
  ContinuumPoints<DruckerPragerCap> points;
  DieModel model;

  explicit Compaction(const DieSettings &chosen)
      : Compaction(chosen, die_mesh(chosen.geometry).mesh)
  {
  }
  Compaction(const DieSettings &chosen, const Mesh &given)
      : settings(chosen), mesh(given),
        points(DruckerPragerCap(), mesh.number_of_points()),
        model(settings, mesh, points)
  {
  }

  unsigned dim() const { return mesh.is_axisymmetric() ? 2 : 3; }

  /// Places of the nodes: the points of a cell fix them.
  std::vector<Vector> nodes() const
  {
    const auto places = model.point_positions();
    std::vector<Vector> result(mesh.nodes.size());
    const unsigned number = mesh.points_per_cell();
    for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
      for (unsigned node = 0; node < number; ++node) {
        Vector sum;
        for (unsigned point = 0; point < number; ++point)
          sum += shape(point, corner(node, std::sqrt(3.)), dim()) *
                 in_section(places[cell * number + point]);
        result[mesh.nodes_of_cell(cell)[node]] = in_space(sum);
      }
    return result;
  }

  /// Sum of relative density times volume over the points [m3].
  double mass() const
  {
    const auto places = nodes();
    double sum = 0;
    for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
      for (unsigned point = 0; point < mesh.points_per_cell(); ++point)
        sum += volume(places, cell, point) *
               model.responses()[cell * mesh.points_per_cell() + point]
                   .relative_density;
    return sum;
  }

  /// The deepest that a node is inside a tool; negative: none is [m].
  double penetration() const
  {
    const ToolSurfaces tools = make_tools(settings.geometry, mesh);
    const StepRecord &now = model.last_step();
    const auto places = nodes();
    double deepest = -1;
    for (unsigned tool = 0; tool < number_of_tools; ++tool) {
      Vector shift;
      if (tool == upper_punch)
        shift[2] = -now.upper_displacement;
      if (tool == lower_punch)
        shift[2] = now.lower_displacement;
      if (tools[tool])
        for (const unsigned node : mesh.tools[tool].nodes)
          if (tool != core_rod || !is_out(places[node])) // drawn without end
            deepest = std::max(
                deepest, -tools[tool]->nearest(places[node] - shift).distance);
    }
    return deepest;
  }

private:
  bool is_out(const Vector &place) const
  {
    return place[2] > settings.geometry.fill_height;
  }
  /// Axisymmetric cells have x = r and y = z of their own.
  Vector in_section(const Vector &place) const
  {
    return dim() == 3 ? place : Vector({place[0], place[2], 0});
  }
  Vector in_space(const Vector &place) const
  {
    return dim() == 3 ? place : Vector({place[0], 0, place[1]});
  }

  double volume(const std::vector<Vector> &places,
                std::size_t cell,
                unsigned point) const
  {
    dealii::Tensor<2, 3> jacobian;
    Vector at;
    for (unsigned node = 0; node < mesh.nodes_per_cell(); ++node) {
      const Vector x = in_section(places[mesh.nodes_of_cell(cell)[node]]);
      const Vector place = corner(point, 1 / std::sqrt(3.));
      at += shape(node, place, dim()) * x;
      for (unsigned axis = 0; axis < dim(); ++axis)
        for (unsigned i = 0; i < 3; ++i)
          jacobian[i][axis] += shape(node, place, dim(), axis) * x[i];
    }
    if (dim() == 3)
      return dealii::determinant(jacobian);
    return 2 * std::numbers::pi * at[0] *
           (jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0]);
  }
};

/// Pressing by a share of the fill height, unloading and ejection.
DieSettings settings_of(const DieGeometry &geometry, double travel)
{
  DieSettings settings;
  settings.geometry = geometry;
  settings.friction.fill(FrictionCoefficient(0.161));
  settings.solver.method = NonlinearMethod::newton;
  settings.solver.force_tolerance = 1e-8;
  settings.steps.maximum = 1e-2;
  settings.stages = {{StageKind::press, StageTarget::displacement, travel},
                     {StageKind::unload, StageTarget::nothing, 0},
                     {StageKind::eject, StageTarget::out, 0, 0}};
  return settings;
}

DieGeometry cylinder()
{
  DieGeometry die;
  die.radial_elements = 3;
  die.axial_elements = 4;
  return die;
}

DieGeometry with_faces(const PunchFace &face)
{
  DieGeometry die = cylinder();
  die.upper_face = die.lower_face = face;
  return die;
}

DieGeometry ring()
{
  DieGeometry die = cylinder();
  die.shape = DieShape::ring;
  return die;
}

DieGeometry square(double corner_radius)
{
  DieGeometry die;
  die.shape = DieShape::square;
  die.section = Section::quarter;
  die.corner_radius = corner_radius;
  die.radial_elements = 2;
  die.axial_elements = 2;
  return die;
}

DieGeometry from_file(const std::string &name)
{
  DieGeometry die;
  die.shape = DieShape::file;
  die.mesh_file = TAMP_MESHES "/" + name;
  return die;
}

struct Shape {
  const char *name;
  DieGeometry die;
  double travel;    ///< of the upper punch, after the lower one's [m]
  double lower = 0; ///< travel of the lower punch, with the upper one [m]
};

class Shapes : public testing::TestWithParam<Shape>
{
};
} // namespace

INSTANTIATE_TEST_SUITE_P(
    Die,
    Shapes,
    testing::Values(
        Shape{"DomedTablet", with_faces({Kind::concave, 12e-3, 0, 0}), 1.5e-3},
        Shape{"HollowTablet", with_faces({Kind::convex, 20e-3, 0, 0}), 1.5e-3},
        Shape{"Bevel", with_faces({Kind::bevel, 0, 2e-3, 0.5}), 1.5e-3},
        Shape{"Chamfer", with_faces({Kind::chamfer, 0, 2e-3, 0}), 1.5e-3},
        Shape{"Ring", ring(), 1.5e-3},
        Shape{"RoundedSquare", square(1e-3), 1.5e-3},
        Shape{"SharpSquare", square(0), 1.5e-3},
        Shape{"SquareOfAFile", from_file("square_die_quarter.msh"), 1.5e-3},
        Shape{"TabletOfAFile", from_file("tablet_axisymmetric.msh"), 1.5e-3},
        Shape{"Step",
              from_file("../apps/examples/stepped/stepped.msh"),
              1.75e-3,
              1.25e-3}),
    [](const auto &info) { return std::string(info.param.name); });

TEST_P(Shapes, ArePressedAndEjectedInBalanceOutsideTheToolsWithoutLoss)
{
  // A step converges to 1e-8 of the reactions, of which the wall's normal force
  // is the largest part.
  constexpr double balance = 1e-8;
  // Points and nodes are computed from each other, some 1e-16 of their places.
  constexpr double conserved = 1e-9;
  // The contact is exact to 1e-10 of the size, the contact's own measure.
  constexpr double inside = 1e-9;
  DieSettings settings = settings_of(GetParam().die, GetParam().travel);
  if (GetParam().lower > 0) {
    Stage both{StageKind::press, StageTarget::displacement, GetParam().lower};
    both.pressing = Pressing::both;
    settings.stages.insert(settings.stages.begin(), both);
  }
  Compaction run(settings);
  const double mass = run.mass();
  double size = 0, peak = 0, residual = 0, lost = 0, deepest = 0;
  for (const Vector &node : run.mesh.nodes)
    size = std::max(size, node.norm());
  Advance advance;
  while ((advance = run.model.advance()) == Advance::stepped) {
    const StepRecord &now = run.model.last_step();
    peak = std::max({peak, now.upper_force, now.wall_normal_force});
    residual = std::max(
        residual,
        std::abs(now.upper_force - now.lower_force - now.wall_friction_force));
    lost = std::max(lost, std::abs(run.mass() / mass - 1));
    deepest = std::max(deepest, run.penetration());
  }
  const StepRecord &end = run.model.last_step();
  EXPECT_EQ(advance, Advance::finished)
      << "after step " << end.step << ": " << run.model.failure().reason;
  EXPECT_GT(peak, 0);
  EXPECT_LT(residual, balance * peak);
  EXPECT_LT(lost, conserved);
  EXPECT_LT(deepest, inside * size);
  for (const double force :
       {end.upper_force, end.lower_force, end.wall_normal_force})
    EXPECT_LT(std::abs(force), balance * peak);
}

TEST(CurvedShapes, AreTheSameFromTheirMeshAsBuiltIn)
{
  // A hollow and a domed tablet: the same mesh between tools that are built in,
  // and between those that are read off the mesh.
  for (const PunchFace &face : {PunchFace{Kind::convex, 20e-3, 0, 0},
                                PunchFace{Kind::concave, 8e-3, 0, 0}}) {
    DieSettings settings = settings_of(with_faces(face), 1.5e-3);
    Compaction built_in(settings);
    settings.geometry = from_file("any, for the mesh is there");
    Compaction read(settings, built_in.mesh);
    unsigned iterations = 0, iterations_read = 0;
    while (built_in.model.advance() == Advance::stepped) {
      ASSERT_EQ(read.model.advance(), Advance::stepped)
          << read.model.failure().reason;
      const StepRecord &one = built_in.model.last_step();
      const StepRecord &other = read.model.last_step();
      // Tools differ by rounding; steps are converged to 1e-8 of the forces, of
      // which differences add up.
      const double tolerance = 1e-6 * (100 + one.upper_force);
      EXPECT_NEAR(other.upper_force, one.upper_force, tolerance);
      EXPECT_NEAR(other.lower_force, one.lower_force, tolerance);
      EXPECT_NEAR(other.wall_normal_force, one.wall_normal_force, tolerance);
      iterations += one.iterations;
      iterations_read += other.iterations;
    }
    EXPECT_EQ(read.model.advance(), Advance::finished);
    // Rounding decides whether a step that is almost good is one.
    EXPECT_NEAR(iterations_read, iterations, 0.05 * iterations);
  }
}

TEST(ShapesInSpace, ASquareIsPressedAlikeAlongBothSides)
{
  Compaction run(settings_of(square(1e-3), 1.5e-3));
  while (run.model.advance() == Advance::stepped)
    ;
  // Each step is converged to 1e-8; a hundred steps add up.
  constexpr double tolerance = 1e-6;
  const auto places = run.model.point_positions();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector mirrored({places[i][1], places[i][0], places[i][2]});
    const auto other = std::min_element(
        places.begin(), places.end(), [&](const Vector &a, const Vector &b) {
          return (a - mirrored).norm() < (b - mirrored).norm();
        });
    EXPECT_LT((*other - mirrored).norm(),
              tolerance * run.settings.geometry.side);
    EXPECT_NEAR(run.model.responses()[other - places.begin()].relative_density,
                run.model.responses()[i].relative_density,
                tolerance);
  }
}

TEST(ShapesInSpace, ACylinderIsThatOfAnAxisymmetricMesh)
{
  // Three elements along the radius: the wall's polygon and the friction layer
  // are coarse.
  constexpr double tolerance = 0.04;
  DieGeometry die = cylinder();
  die.axial_elements = 3;
  std::vector<StepRecord> ends;
  for (const Section section : {Section::axisymmetric, Section::quarter}) {
    die.section = section;
    DieSettings settings = settings_of(die, 1.5e-3);
    settings.stages.resize(1);
    Compaction run(settings);
    while (run.model.advance() == Advance::stepped)
      ;
    ends.push_back(run.model.last_step());
  }
  EXPECT_NEAR(ends[1].upper_force / ends[0].upper_force, 1, tolerance);
  EXPECT_NEAR(ends[1].lower_force / ends[0].lower_force, 1, tolerance);
  EXPECT_NEAR(
      ends[1].wall_normal_force / ends[0].wall_normal_force, 1, tolerance);
  EXPECT_NEAR(ends[1].wall_friction_force / ends[0].wall_friction_force,
              1,
              2 * tolerance); // a difference of large forces
}
} // namespace tamp::fem
