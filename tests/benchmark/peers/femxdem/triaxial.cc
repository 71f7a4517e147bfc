// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/unit_cell_points.h>
#include <fem/build_mesh.h>
#include <fem/equilibrium.h>
#include <tests/benchmark/peers/peer_cell.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tamp::speed
{
namespace
{
/// The case; the script gives the same to the peer.
struct Case {
  std::string start;            ///< packing of all points
  double friction = 0.3;        ///< of the grains [-]
  double width = 0, height = 0; ///< of the block [m]
  double pressure = 0;          ///< on its sides [Pa]
  double increment = 0;         ///< of axial strain in a load step [-]
  double tolerance = 0;         ///< of the force residual [-]
  unsigned steps = 0;
};

/// Material points under a pressure on the free sides of their body: to a
/// stress of that size across the axis belong the forces of that pressure, at
/// right angles to the axis, on the sides as they stand, and none on its ends.
class Confined final : public fem::MaterialPoints
{
public:
  Confined(fem::MaterialPoints &points, double pressure)
      : points_(points), pressure_(pressure)
  {
  }

  std::size_t size() const override { return points_.size(); }
  void begin_attempt() override { points_.begin_attempt(); }
  void evaluate(std::span<const fem::Deformation> deformations,
                fem::Want want,
                std::span<fem::Response> responses) override
  {
    points_.evaluate(deformations, want, responses);
    for (fem::Response &response : responses) {
      response.stress[0][0] += pressure_;
      response.stress[1][1] += pressure_;
    }
  }
  void commit() override { points_.commit(); }
  void pack(std::size_t point, std::vector<char> &bytes) const override
  {
    points_.pack(point, bytes);
  }
  void unpack(std::size_t point, std::span<const char> bytes) override
  {
    points_.unpack(point, bytes);
  }
  double cost(std::size_t point) const override { return points_.cost(point); }

private:
  fem::MaterialPoints &points_;
  double pressure_;
};

fem::DieGeometry geometry_of(const Case &wanted)
{
  fem::DieGeometry geometry;
  geometry.shape = fem::DieShape::square;
  geometry.section = fem::Section::full;
  geometry.side = wanted.width;
  geometry.corner_radius = 0;
  geometry.fill_height = wanted.height;
  geometry.radial_elements = 1;
  geometry.axial_elements = 2;
  return geometry;
}

/// Eight hexahedra whose ends cannot move sideways and whose sides are free.
fem::Mesh block(const Case &wanted)
{
  fem::Mesh mesh = fem::build_mesh(geometry_of(wanted));
  mesh.tools[fem::die_wall] = {};
  mesh.held.clear();
  for (const fem::Tool end : {fem::upper_punch, fem::lower_punch})
    for (const unsigned node : mesh.tools[end].nodes)
      for (const unsigned axis : {0u, 1u})
        mesh.held.push_back({node, axis});
  return mesh;
}

/// The plane punches at both ends and nothing else.
fem::Tools ends(const Case &wanted, const fem::Mesh &mesh)
{
  fem::Tools tools;
  tools.surfaces = fem::make_tools(geometry_of(wanted), mesh);
  tools.surfaces[fem::die_wall].reset();
  return tools;
}

double cpu_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// Lines "step tamp STEP UPDATES CPU_PER_POINT FORCE_RESIDUAL TOP_FORCE".
void compress(const Case &wanted)
{
  const fem::Mesh mesh = block(wanted);
  dem::UnitCell cell = read_peer_cell(wanted.start, wanted.friction);
  deform(cell, dem::Stretch::Identity(), {});
  coupling::UnitCellPoints cells(
      std::vector<dem::UnitCell>(mesh.number_of_points(), cell), {});
  Confined points(cells, wanted.pressure);
  fem::SolverSettings settings;
  settings.force_tolerance = wanted.tolerance;
  fem::Press press(mesh, ends(wanted, mesh), points, settings, fem::Ranks());
  fem::Equilibrium equilibrium(press, settings, 0.2);
  fem::Motion motion;
  motion[fem::upper_punch].displacement = -wanted.increment * wanted.height;
  fem::Increment guess(fem::number_of_unknowns(mesh), 0.);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    guess[mesh.axial_dof(node)] = -wanted.increment * mesh.nodes[node][2];
  for (unsigned step = 1; step <= wanted.steps; ++step) {
    const double before = cpu_seconds();
    const fem::Attempt attempt = equilibrium.attempt(motion, guess);
    if (!attempt.converged)
      throw std::runtime_error("step " + std::to_string(step) + ": " +
                               attempt.reason);
    equilibrium.accept();
    guess = equilibrium.increment();
    const double seconds = cpu_seconds() - before;
    std::cout << "step tamp " << step << ' ' << attempt.iterations << ' '
              << std::setprecision(9) << seconds / double(points.size()) << ' '
              << attempt.force_residual << ' '
              << attempt.forces[fem::upper_punch].force[2] << std::endl;
  }
}

Case read_case(std::span<char *const> words)
{
  if (words.size() != 9)
    throw std::invalid_argument("usage: femxdem_case START FRICTION WIDTH "
                                "HEIGHT PRESSURE INCREMENT TOLERANCE STEPS");
  Case result;
  result.start = words[1];
  result.friction = number(words[2]);
  result.width = number(words[3]);
  result.height = number(words[4]);
  result.pressure = number(words[5]);
  result.increment = number(words[6]);
  result.tolerance = number(words[7]);
  result.steps = unsigned(number(words[8]));
  return result;
}
} // namespace
} // namespace tamp::speed

/// Triaxial compression of a block between rough ends, by tamp.
int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try {
    tamp::speed::compress(tamp::speed::read_case({argv, std::size_t(argc)}));
  } catch (const std::exception &error) {
    std::cerr << "femxdem_case: " << error.what() << std::endl;
    return 2;
  }
}
