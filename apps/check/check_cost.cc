// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/check_sections.h>
#include <fem/kinematics.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace tamp::apps
{
namespace
{
constexpr double states = 2; // committed and trial
// Measured: 1.02 of cells at rest to 1.22 where they grow, for what lies unused
// between them.
constexpr double with_gaps = 1.15;
constexpr double numbers_of_guess = 6; // dem::WarmGuess, a grain
constexpr double most_of_memory = 0.8;

double page()
{
  return double(sysconf(_SC_PAGESIZE));
}

// What this machine, or the container the process is in, has [B].
double memory_of_machine()
{
  double bytes = double(sysconf(_SC_PHYS_PAGES)) * page();
  std::ifstream in("/sys/fs/cgroup/memory.max");
  if (double limit = 0; in >> limit)
    bytes = std::min(bytes, limit);
  return bytes;
}

// A cell of the run over the one that was tried.
double grains_ratio(const RunInput &input, const MaterialTrial &trial)
{
  return trial.grains == 0 || !input.material.packing_files.empty()
             ? 1
             : double(input.material.packing.grain_count) /
                   double(trial.grains);
}

// Of a material point: both states and, of a cell, the start of the next
// trial [B]. Grains touch more of each other the denser they are.
double bytes_of_states(const RunInput &input,
                       const MaterialTrial &trial,
                       const Workload &work)
{
  double bytes = states * trial.bytes_at(work.relative_density);
  if (trial.grains > 0 && input.material.warm)
    bytes += numbers_of_guess * sizeof(double) * double(trial.grains);
  return with_gaps * grains_ratio(input, trial) * bytes;
}

// What the finite elements keep for a material point [B].
constexpr double bytes_of_point =
    states * (sizeof(fem::Response) + sizeof(fem::PointGeometry)) +
    sizeof(fem::Deformation) + 2 * sizeof(dealii::Tensor<2, 3>);

// Matrices and factors or preconditioner of the linear systems, roughly [B].
double bytes_of_equations(const RunInput &input)
{
  const fem::Mesh &mesh = input.mesh.mesh;
  const double n = double(mesh.number_of_dofs());
  const double nodes = double(mesh.nodes.size());
  const double per_row = mesh.is_axisymmetric() ? 18 : 81;
  constexpr double copies = 4, entry = sizeof(double) + sizeof(int);
  const double matrices = copies * entry * per_row * n;
  if (solves_iteratively(input))
    return 1.5 * matrices;
  // Nested dissection of the nodes, both factors, with as much again to work:
  // A. George (1973), SIAM J. Numer. Anal. 10:345, in the plane
  // 31/4 N log2 N entries of a factor; in space of the order of N^(4/3).
  const double block = mesh.components() * mesh.components();
  const double factor = mesh.is_axisymmetric() ? 7.75 * nodes * std::log2(nodes)
                                               : 7 * std::pow(nodes, 4. / 3);
  return matrices + 2 * 2 * sizeof(double) * block * factor;
}

double seconds_of_cells(const RunInput &input,
                        const MaterialTrial &trial,
                        const Workload &work)
{
  const double threads =
      double(std::min<std::size_t>(work.threads, work.points));
  double seconds = trial.seconds_per_step;
  if (input.material.driving.method == dem::Method::dynamics)
    // As many time steps as the strain needs.
    seconds *= work.increment / trial.increment;
  return seconds * grains_ratio(input, trial) * work.steps *
         work.updates_per_step * double(work.points) / threads;
}

double seconds_of_packing(const RunInput &input,
                          const MaterialTrial &trial,
                          const Workload &work)
{
  if (trial.grains == 0)
    return 0;
  const double threads =
      std::max(1., double(std::min<std::size_t>(work.threads, work.packings)));
  return trial.packing_seconds * grains_ratio(input, trial) *
         double(work.packings) / threads;
}
// Of a die with a continuum law; the seconds of all its steps.
double say_steps(CheckReport &report,
                 const RunInput &input,
                 const Workload &work,
                 const DieTrial &die)
{
  if (die.steps == 0) {
    report.line("steps", "not known: none could be tried here");
    return 0;
  }
  const double step = seconds_per_step(die, input);
  report.line("steps",
              fmt::format("{}: {:.0f} x {:.2g} s",
                          about_seconds(step * work.steps),
                          work.steps,
                          step));
  report.line(
      "basis",
      fmt::format("{} first steps on {} unknowns here{}, {:.2g} updates "
                  "of all points a step",
                  die.steps,
                  die.unknowns,
                  die.own_mesh ? "" : ", on a coarser cylinder",
                  double(die.updates) / die.steps));
  return step * work.steps;
}

// Of unit cells, or of a single point.
double say_steps(CheckReport &report,
                 const RunInput &input,
                 const MaterialTrial &trial,
                 const Workload &work)
{
  const double seconds = seconds_of_cells(input, trial, work);
  report.line("steps",
              fmt::format("{}: {:.0f} steps x {:.2g} updates x {} points on {} "
                          "threads",
                          about_seconds(seconds),
                          work.steps,
                          work.updates_per_step,
                          work.points,
                          work.threads));
  report.line("basis",
              fmt::format("{:.2g} s an update{}, measured here",
                          trial.seconds_per_step,
                          trial.grains == 0
                              ? ""
                              : fmt::format(" of {} grains, {:.3g} force "
                                            "evaluations",
                                            trial.grains,
                                            trial.evaluations_per_step)));
  return seconds;
}
} // namespace

double resident_bytes()
{
  std::ifstream in("/proc/self/statm");
  double all = 0, resident = 0;
  return in >> all >> resident ? resident * page() : 0;
}

void say_memory(CheckReport &report,
                const RunInput &input,
                const MaterialTrial &trial,
                const Workload &work,
                bool with_die,
                double program)
{
  report.section("Memory");
  const double count = double(work.points);
  const double state = bytes_of_states(input, trial, work);
  double all = program;
  report.line("program", megabytes(program));
  report.line(trial.grains > 0 ? "unit cells" : "material points",
              fmt::format("{} x {:.0f} bytes (committed and trial): {}",
                          work.points,
                          state,
                          megabytes(state * count)));
  all += state * count;
  if (with_die) {
    const double equations = bytes_of_equations(input);
    report.line("finite elements",
                fmt::format("about {}, of which {} for linear systems",
                            megabytes(bytes_of_point * count + equations),
                            megabytes(equations)));
    all += bytes_of_point * count + equations;
    if (trial.grains > 0) // cells are shared out, all else every rank has
      report.line(
          "further ranks",
          fmt::format("about {} each; the cells are shared out",
                      megabytes(program + bytes_of_point * count + equations)));
  }
  const double machine = memory_of_machine();
  report.line(
      "all", fmt::format("about {} of {}", megabytes(all), megabytes(machine)));
  if (all > machine)
    report.failure(fmt::format("the run needs about {}, but this machine has "
                               "{}; use fewer elements or fewer grains",
                               megabytes(all),
                               megabytes(machine)));
  else if (all > most_of_memory * machine)
    report.doubt("the run needs nearly all of this machine's memory");
}

void say_time(CheckReport &report,
              const RunInput &input,
              const MaterialTrial &trial,
              const Workload &work,
              const DieTrial *die)
{
  report.section("Expected time");
  const double packing = seconds_of_packing(input, trial, work);
  double all = packing;
  if (trial.grains > 0 && work.packings > 0)
    report.line("packing",
                fmt::format("{}: {} x {:.2g} s on {} threads",
                            about_seconds(packing),
                            work.packings,
                            trial.packing_seconds * grains_ratio(input, trial),
                            work.threads));
  if (die)
    all += say_steps(report, input, work, *die);
  else if (work.steps > 0)
    all += say_steps(report, input, trial, work);
  if (die && !die->problem.empty())
    report.doubt("the first steps, tried here, did not end well: " +
                 die->problem);
  if (!die || die->steps > 0)
    report.line("all", about_seconds(all) + ", roughly");
}
} // namespace tamp::apps
