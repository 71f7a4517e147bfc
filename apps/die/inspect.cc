// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/die/inspected_run.h>
#include <apps/output/cell_columns.h>
#include <apps/output/curve_writer.h>
#include <apps/output/plots.h>
#include <apps/output/probe_columns.h>
#include <apps/run/interrupt.h>
#include <apps/run/run_material.h>
#include <apps/run/series_writer.h>
#include <coupling/grain_output.h>
#include <coupling/unit_cell_points.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>

namespace tamp::apps
{
namespace
{
using Bits = std::array<std::uint64_t, sizeof(PointAnswer) / 8>;

// Of the stress, over the recorded one.
double relative_difference(const PointAnswer &now, const PointAnswer &then)
{
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < now.stress.size(); ++k) {
    difference += std::pow(now.stress[k] - then.stress[k], 2);
    size += std::pow(then.stress[k], 2);
  }
  return std::sqrt(difference / std::max(size, 1e-300));
}

class Inspection
{
public:
  Inspection(RunSession &session, InspectedRun &run)
      : session_(session), run_(run),
        material_(prepare_material(session, {run.point(), run.point() + 1}, 1)),
        cells_(*material_.cells),
        curve_(session.folder().path() / "curve.csv", header(), remarks()),
        grains_(session.folder(), "grains.pvd")
  {
    record_.F = dealii::unit_symmetric_tensor<3>();
  }

  RunEnd work()
  {
    session_.log().begin(fmt::format("replaying point {}", run_.point()));
    for (std::size_t number = 0; number < run_.steps(); ++number) {
      if (caught_signal())
        break;
      take(run_.step(number));
    }
    session_.log().end();
    give();
    if (caught_signal())
      return RunSession::interrupted(caught_signal());
    session_.draw(probe_plots(true));
    return end();
  }

private:
  const dem::Driving &driving() const
  {
    return session_.input().material.driving;
  }

  std::vector<std::string> header() const
  {
    std::vector<std::string> names = probe_header();
    std::ranges::copy(cell_header(driving().method == dem::Method::dynamics),
                      std::back_inserter(names));
    append_nine_names("relative_F_", names);
    return names;
  }

  std::vector<std::string> remarks() const
  {
    return {fmt::format(
                "point {}, of cell {} of the mesh", run_.point(), run_.cell()),
            "compression is positive; strain is logarithmic, ln V; in a "
            "half section x = r, y = hoop, z = axis"};
  }

  void take(const PointStep &step)
  {
    const fem::Response response = replay(step);
    compare(step, answer_of(response));
    if (step.step > 0 && !step.accepted) {
      tell_failed(step, response.status);
      return;
    }
    dealii::Tensor<2, 3> relative_F = dealii::unit_symmetric_tensor<3>();
    if (step.accepted) {
      cells_.commit();
      relative_F = step.trials.back().relative_F;
    }
    record_ = {step.step, step.stage, relative_F * record_.F, response};
    std::vector<double> values = probe_values(record_);
    std::ranges::copy(cell_values(cells_, 0, driving()),
                      std::back_inserter(values));
    append_nine(relative_F, values);
    curve_.write(values);
    doubtful_ += response.status == fem::Status::doubtful;
    report(step);
    if (run_.wants(step.step))
      write_grains(step.step);
  }

  fem::Response replay(const PointStep &step)
  {
    fem::Response response;
    auto trial = step.trials.begin();
    for (const PointEvent &event : step.events) {
      if (event.kind == PointEvent::turn) {
        cells_.turn();
        cells_.set_force_floor(event.force_floor);
      } else if (event.kind == PointEvent::attempt)
        cells_.begin_attempt();
      else
        cells_.evaluate({&*trial++, 1},
                        event.kind == PointEvent::stress
                            ? fem::Want::stress
                            : fem::Want::stress_and_tangent,
                        {&response, 1});
    }
    trials_ += step.trials.size();
    return response;
  }

  void compare(const PointStep &step, const PointAnswer &now)
  {
    if (std::bit_cast<Bits>(now) == std::bit_cast<Bits>(step.answer))
      return;
    if (differing_steps_++ == 0)
      first_difference_ = step.step;
    difference_ = std::max(difference_, relative_difference(now, step.answer));
  }

  void tell_failed(const PointStep &step, fem::Status status)
  {
    const std::string problem = cells_.report().problem;
    session_.warn(fmt::format(
        "the run did not get over step {}; in its last trial the cell of this "
        "point {}{}",
        step.step,
        status == fem::Status::failed ? "failed"
        : status == fem::Status::doubtful
            ? "did not settle within Cell/Maximum evaluations"
            : "settled: look at other points, too",
        problem.empty() ? "" : " (" + problem + ")"));
  }

  void report(const PointStep &step)
  {
    const auto stress = -record_.response.stress;
    session_.log().step(
        static_cast<double>(step.step) / static_cast<double>(run_.steps()),
        step.step,
        "steps",
        fmt::format("step {:4d}  axial {:.4g} MPa  lateral {:.4g} MPa  "
                    "density {:.4f}  {} trials",
                    step.step,
                    stress[2][2] / 1e6,
                    0.5 * (stress[0][0] + stress[1][1]) / 1e6,
                    record_.response.relative_density,
                    step.trials.size()));
    peak_ = std::max(peak_, stress[2][2]);
  }

  void write_grains(unsigned step)
  {
    session_.folder().subfolder("grains");
    const std::string file = fmt::format("grains/step_{:04d}.vtp", step);
    coupling::write_grains(
        cells_.cell(0), cells_.rotation(0), session_.folder().path() / file);
    grains_.add(step, 0, file);
  }

  void give()
  {
    session_.result("cell[-]", static_cast<double>(run_.cell()));
    session_.result("point[-]", static_cast<double>(run_.point()));
    session_.result("steps[-]", record_.step);
    session_.result("trials[-]", static_cast<double>(trials_));
    session_.result("steps_with_other_bits[-]", differing_steps_);
    session_.result("largest_relative_difference[-]", difference_);
    session_.result("doubtful_steps[-]", doubtful_);
    session_.result("peak_axial_stress[Pa]", peak_);
    session_.result("final_axial_stress[Pa]", -record_.response.stress[2][2]);
    session_.result("final_relative_density[-]",
                    record_.response.relative_density);
  }

  RunEnd end() const
  {
    if (differing_steps_ == 0) {
      session_.log().say("The replay has the stresses of the run, to the bit.");
      return {};
    }
    return {exit_check_failed,
            fmt::format("the replay has other stresses than the run, first in "
                        "step {}, by up to {:.2g} of them: packings or size "
                        "tables that the input names have changed, or this "
                        "program or machine is another one (the run was made "
                        "with tamp {})",
                        first_difference_,
                        difference_,
                        run_.title().program)};
  }

  RunSession &session_;
  InspectedRun &run_;
  coupling::Material material_;
  coupling::UnitCellPoints &cells_;
  CurveWriter curve_;
  SeriesWriter grains_;
  fem::PathRecord record_; ///< of the last accepted step
  std::size_t trials_ = 0;
  unsigned differing_steps_ = 0, first_difference_ = 0, doubtful_ = 0;
  double difference_ = 0; ///< the largest one, relative
  double peak_ = 0;       ///< axial stress [Pa]
};
} // namespace

int inspect_point(const PointChoice &choice, RunOptions options)
{
  InspectedRun run(choice);
  options.input = run.input();
  options.threads = 1;
  if (options.output.empty())
    options.output = choice.folder / "inspect" /
                     fmt::format("cell_{}_point_{}", run.cell(), run.point());
  RunSession session("inspect", options, Need::point);
  watch_signals();
  return session.run([&]() -> RunEnd {
    try {
      return Inspection(session, run).work();
    } catch (const PackingError &error) {
      return {exit_not_converged, error.what()};
    }
  });
}
} // namespace tamp::apps
