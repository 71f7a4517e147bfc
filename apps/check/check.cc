// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/check_sections.h>
#include <apps/commands.h>
#include <apps/input/input_purpose.h>
#include <apps/run/input_table.h>
#include <apps/run/run_material.h>
#include <fem/punch_area.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <memory>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
using coupling::MaterialKind;

// Updates of all cells a step: the example die_default takes 2.6 with Anderson
// acceleration; Newton's method more.
constexpr double updates_by_anderson = 2.6, updates_by_newton = 4;
// Of a point some of whose stresses are given: it iterates.
constexpr double updates_of_probe = 3;
constexpr double packing_increment = 5e-3;

// Of the powder, from edge to edge of the punches.
double height_of(const RunInput &input)
{
  if (input.die.geometry.mesh_file.empty())
    return input.die.geometry.fill_height;
  const fem::Mesh &mesh = input.mesh.mesh;
  const auto low_high = [&](fem::Tool tool) {
    const auto [low, high] =
        std::ranges::minmax(mesh.tools[tool].nodes, {}, [&](unsigned i) {
          return mesh.nodes[i][2];
        });
    return std::pair(mesh.nodes[low][2], mesh.nodes[high][2]);
  };
  return low_high(fem::upper_punch).second - low_high(fem::lower_punch).first;
}

bool controls_stress(const ProbePath &path)
{
  using Control = fem::ComponentTarget::Control;
  const auto given = [](const fem::ComponentTarget &target) {
    return target.control == Control::stress;
  };
  return std::ranges::any_of(path.stages, [&](const ProbeStage &probe) {
    return std::ranges::any_of(probe.stage.components, given);
  });
}

double largest_increment(const ProbePath &path)
{
  double largest = 1e-6;
  for (const ProbeStage &stage : path.stages)
    largest = std::max(largest, stage.stage.maximum_increment);
  return largest;
}

class Check
{
public:
  Check(const ParameterTable &table, unsigned threads, CheckReport &report)
      : table_(table), threads_(threads), report_(report),
        program_(resident_bytes())
  {
  }

  void look(Need need)
  {
    const RunInput input = read_input(table_, need);
    if (need == Need::contact) {
      say_pair(report_, input);
      report_.section("Expected time");
      report_.line("all", "less than 1 s");
    } else if (need == Need::die)
      look_at_die(input);
    else
      look_at_point(input, need);
  }

private:
  Workload workload(const RunInput &input, std::size_t points) const
  {
    Workload work;
    work.points = points;
    work.threads = threads_;
    if (input.material.packing_files.empty())
      work.packings = different_packings(input.material, points);
    return work;
  }

  void look_at_point(const RunInput &input, Need need)
  {
    const bool probe = need == Need::probe;
    Workload work = workload(input, probe ? 1 : input.replicas);
    work.increment = probe ? largest_increment(input.path) : packing_increment;
    coupling::MaterialChoice material = input.material;
    if (!probe)
      material.kind = MaterialKind::unit_cell;
    const MaterialTrial trial = try_material(material, work.increment);
    say_material(report_, material, trial);
    if (probe) {
      const auto stages = expected_stages(input.path);
      say_stages(report_, "Path", stages);
      work.steps = sum_of_steps(stages);
      if (controls_stress(input.path))
        work.updates_per_step = updates_of_probe;
    }
    say_memory(report_, input, trial, work, false, program_);
    say_time(report_, input, trial, work, nullptr);
  }

  void look_at_die(const RunInput &input)
  {
    const fem::SolverSettings &solver = input.die.solver;
    Workload work = workload(input, input.mesh.mesh.number_of_points());
    work.increment = input.die.steps.maximum;
    work.updates_per_step = solver.method == fem::NonlinearMethod::anderson
                                ? updates_by_anderson
                                : updates_by_newton;
    const MaterialTrial trial = try_material(input.material, work.increment);
    say_material(report_, input.material, trial);
    try {
      input.die.check_start(trial.states.front().relative_density);
    } catch (const std::invalid_argument &error) {
      table_.complain("Schedule/Stages", error.what());
    }
    say_die(report_, input);
    say_tools(report_, input);
    const auto stages = expected_stages(
        input.die,
        {height_of(input), fem::punch_area(input.mesh.mesh, fem::upper_punch)},
        trial);
    say_stages(report_, "Schedule", stages);
    work.steps = sum_of_steps(stages);
    work.relative_density =
        std::ranges::max(stages, {}, &ExpectedStage::relative_density)
            .relative_density;
    say_memory(report_, input, trial, work, true, program_);
    std::unique_ptr<DieTrial> die;
    // Cells cost so much more than finite elements that these are left out.
    if (input.material.kind != MaterialKind::unit_cell)
      die = std::make_unique<DieTrial>(try_die(input));
    say_time(report_, input, trial, work, die.get());
  }

  const ParameterTable &table_;
  unsigned threads_;
  CheckReport &report_;
  double program_;
};

// Works while MPI is up, which no exception may leave.
void with_mpi(const std::function<void()> &work)
{
  // PETSc must not see our command line.
  std::string name = "tamp";
  char *words[] = {name.data(), nullptr};
  char **arguments = words;
  int count = 1;
  std::exception_ptr problem;
  {
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(count, arguments, 1);
    try {
      work();
    } catch (...) {
      problem = std::current_exception();
    }
  }
  if (problem)
    std::rethrow_exception(problem);
}

void say_all(const ParameterTable &table,
             const RunOptions &options,
             CheckReport &report)
{
  const std::vector<Need> needs = purposes(table);
  const auto look = [&] {
    Check check(table, checked_threads(options.threads), report);
    for (const Need need : needs) {
      fmt::print("{}{}, an input for tamp {}\n",
                 need == needs.front() ? "" : "\n",
                 options.input.string(),
                 name_of(need));
      check.look(need);
    }
  };
  if (std::ranges::count(needs, Need::die))
    with_mpi(look);
  else
    look();
}
} // namespace

int check_input(const RunOptions &options)
{
  ParameterTable table;
  read_table(options, table);
  CheckReport report;
  try {
    say_all(table, options, report);
  } catch (const std::bad_alloc &) {
    report.failure("the memory does not suffice to look at this input");
  }
  if (report.failures() > 0) {
    fmt::print(stderr,
               "tamp: check failed: {} of what is said above cannot do\n",
               report.failures());
    return exit_check_failed;
  }
  fmt::print("\n{} can run{}\n",
             options.input.string(),
             report.doubts() == 0
                 ? ""
                 : fmt::format("; {} doubtful", report.doubts()));
  return exit_done;
}
} // namespace tamp::apps
