// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/packing_library.h>
#include <coupling/unit_cell_points.h>
#include <fem/die_model.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <string>

namespace
{
using namespace tamp;

double processor_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

double wall_seconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

void report(const std::string &name, double value, const std::string &unit)
{
  std::cout << name << ',' << std::setprecision(6) << value << ',' << unit
            << std::endl;
}

std::vector<dem::UnitCell> granules(std::size_t grains, std::size_t count)
{
  dem::PackingRequest request;
  request.grain_count = grains;
  request.sizes.minimum_diameter = 450e-6;
  request.sizes.maximum_diameter = 650e-6;
  request.material = {3.5e9, 0.3, 2000, 50e6};
  request.contact.friction_coefficient = 0.35;
  request.goal.pressure = 0.5e6;
  return coupling::make_packings(request, count, false, 2);
}

/// Processor time of a load step per material point in a small die with wall
/// friction, all updates and the finite elements included.
void point_step(const std::string &name)
{
  constexpr unsigned steps = 20;
  fem::DieSettings settings;
  settings.geometry.radial_elements = 1;
  settings.geometry.axial_elements = 2;
  fem::Stage press;
  press.value = 0.75;
  settings.stages = {press};
  const fem::DieMesh mesh(settings.geometry);
  coupling::UnitCellPoints cells(granules(1000, mesh.number_of_points()), {});
  fem::DieModel die(settings, mesh, cells);
  const double start = processor_seconds();
  unsigned taken = 0;
  while (taken < steps && die.advance() == fem::Advance::stepped)
    ++taken;
  report(name,
         (processor_seconds() - start) /
             double(taken * mesh.number_of_points()),
         "s");
}

double time_of_evaluations(const std::vector<dem::UnitCell> &start_cells,
                           unsigned threads)
{
  coupling::CellPointsOptions options;
  options.threads = threads;
  options.warm = false;
  coupling::UnitCellPoints cells(start_cells, options);
  fem::Deformation press;
  press.relative_F[0][0] = press.relative_F[1][1] = 1;
  press.relative_F[2][2] = 1 - 5e-3;
  const std::vector<fem::Deformation> deformations(cells.size(), press);
  std::vector<fem::Response> responses(cells.size());
  const double start = wall_seconds();
  for (int step = 0; step < 8; ++step) {
    cells.evaluate(deformations, fem::Want::stress, responses);
    cells.commit();
  }
  return wall_seconds() - start;
}
} // namespace

int main(int argc, char **argv)
{
  const std::string filter = argc > 1 ? argv[1] : "";
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto wanted = [&](const std::string &name) {
    return name.find(filter) != std::string::npos;
  };
  if (const std::string name = "coupling.cpu_seconds_per_point_step.1000";
      wanted(name))
    point_step(name);
  if (const std::string name = "coupling.thread_efficiency.2"; wanted(name)) {
    // In turn and the best of each: a shared machine disturbs single runs.
    const std::vector<dem::UnitCell> cells = granules(200, 32);
    double one = 1e300, two = 1e300;
    for (int k = 0; k < 3; ++k) {
      one = std::min(one, time_of_evaluations(cells, 1));
      two = std::min(two, time_of_evaluations(cells, 2));
    }
    report(name, one / (2 * two), "-");
  }
}
