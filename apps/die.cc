// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/die_cells.h>
#include <apps/die_maps.h>
#include <apps/die_output.h>
#include <apps/die_plots.h>
#include <apps/die_results.h>
#include <apps/interrupt.h>
#include <apps/mpi_run.h>
#include <apps/recorded_points.h>
#include <apps/run_material.h>
#include <apps/schedule.h>
#include <apps/units.h>
#include <fem/die_model.h>
#include <fem/stop_watch.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace tamp::apps
{
namespace
{
using fem::StageKind;

// Cells packed below this pressure may collapse in the first steps.
constexpr double safe_start_pressure = 0.5e6;

// Steps that each stage will need, roughly: for the time left.
std::vector<double> expected_steps(const fem::DieSettings &die)
{
  std::vector<double> steps;
  for (const fem::Stage &stage : die.stages) {
    double guess = 30;
    if (stage.kind == StageKind::press)
      guess = 0.35 / die.steps.maximum;
    if (stage.kind == StageKind::hold)
      guess = stage.steps;
    steps.push_back(std::max(guess, 1.));
  }
  return steps;
}

class DieRun
{
public:
  DieRun(RunSession &session, const fem::Ranks &ranks)
      : session_(session), ranks_(ranks), settings_(session.input().die),
        mesh_(session.input().mesh.mesh),
        material_(make_die_material(session, ranks)),
        points_(*material_.points),
        model_(
            settings_,
            mesh_,
            points_,
            [this](unsigned stage, double peak) { begin(stage, peak); },
            material_.model_ranks),
        cells_(session, model_, material_.cells),
        output_(session, model_, points_, material_.cells),
        steps_(expected_steps(settings_))
  {
    if (session.place().first())
      curve_ = std::make_unique<CurveWriter>(
          session.folder().path() / "curve.csv", die_header(), remarks());
  }

  RunEnd work()
  {
    RunEnd end;
    try {
      end = press();
    } catch (...) {
      give(); // the results so far
      throw;
    }
    give();
    {
      const fem::StopWatch watch(time_plots_);
      draw();
    }
    session_.result("time_plots[s]", time_plots_);
    return end;
  }

private:
  RunEnd press()
  {
    RunLog &log = session_.log();
    log.begin(fmt::format(
        "pressing {} points, {} stages{}",
        mesh_.number_of_points(),
        settings_.stages.size(),
        ranks_.size() > 1 ? fmt::format(", on {} ranks", ranks_.size()) : ""));
    take_step();
    write_output(0, true);
    const RunEnd end = advance();
    log.end();
    write_output(model_.last_step().step, true);
    return end;
  }

  RunEnd advance()
  {
    while (true) {
      // The ranks do not catch a signal in the same step.
      if (const auto signal = static_cast<int>(ranks_.largest(caught_signal()));
          signal != 0)
        return RunSession::interrupted(signal);
      switch (model_.advance()) {
      case fem::Advance::finished:
        return {};
      case fem::Advance::failed:
        return {exit_not_converged, describe(model_.failure())};
      case fem::Advance::stepped:
        take_step();
        write_output(model_.last_step().step,
                     model_.last_step().stage_progress >= 1);
      }
    }
  }

  void write_output(unsigned step, bool must)
  {
    const fem::StopWatch watch(time_output_);
    output_.write(step, must);
  }

  std::vector<std::string> remarks() const
  {
    std::vector<std::string> lines{"compression is positive"};
    for (std::size_t i = 0; i < settings_.stages.size(); ++i)
      lines.push_back(fmt::format(
          "stage {}: {}", i + 1, name_of(settings_.stages[i].kind)));
    return lines;
  }

  const fem::Stage &stage_at(unsigned number) const
  {
    return settings_
        .stages[std::min<std::size_t>(number, settings_.stages.size() - 1)];
  }
  StageKind kind(unsigned number) const { return stage_at(number).kind; }

  void begin(unsigned stage, double peak_pressure)
  {
    stage_ = stage;
    session_.log().detail(fmt::format("stage {}: {}, peak so far {:.4g} MPa",
                                      stage + 1,
                                      name_of(kind(stage)),
                                      peak_pressure / 1e6));
    cells_.begin_stage(kind(stage), peak_pressure);
  }

  void take_step()
  {
    const fem::StepRecord &record = model_.last_step();
    StepEffort effort;
    effort.wall_time = session_.log().progress().elapsed();
    cells_.measure(effort);
    if (curve_)
      curve_->write(die_values(record, effort));
    results_.take(record, stage_at(record.stage), effort);
    output_.write_point_lines();
    cells_.judge(
        fmt::format("{} ({})", record.step, name_of(kind(record.stage))));
    if (results_.at_peak())
      maps_.take_peak(mesh_, model_);
    session_.log().step(
        share(record), record.step, "steps", line(record, effort));
  }

  double share(const fem::StepRecord &record) const
  {
    double done = 0, all = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      all += steps_[i];
      if (i < record.stage)
        done += steps_[i];
      if (i == record.stage)
        done += steps_[i] * std::clamp(record.stage_progress, 0., 1.);
    }
    return done / all;
  }

  std::string line(const fem::StepRecord &record,
                   const StepEffort &effort) const
  {
    const auto mega = [](double force, double area) {
      return area > 0 ? force / area / 1e6 + 0. : 0;
    };
    std::string text = fmt::format(
        "step {:4d}  {:<6} density {:.4f}  upper {:.4g}  lower {:.4g}  wall "
        "{:.4g} MPa  iterations {}  updates {}  residual {:.1e}",
        record.step,
        name_of(kind(record.stage)),
        record.mean_relative_density,
        mega(record.upper_force, record.punch_area),
        mega(record.lower_force, record.punch_area),
        mega(record.wall_normal_force, record.wall_area),
        record.iterations,
        record.material_updates,
        record.force_residual);
    if (material_.cells)
      text += fmt::format("  evaluations {:.0f}  unbalance {:.1e}",
                          effort.evaluations,
                          effort.worst_unbalance);
    if (record.cuts > 0)
      text += fmt::format("  cuts {}", record.cuts);
    if (record.doubtful_points > 0)
      text += fmt::format("  doubtful points {}", record.doubtful_points);
    if (share(record) > 0.02)
      text +=
          "  left " + duration(session_.log().progress().left(share(record)));
    return text;
  }

  std::string describe(const fem::Failure &failure) const
  {
    if (failure.kind == fem::FailureKind::impossible)
      return failure.reason;
    const auto &stress = failure.stress;
    return fmt::format(
        "the step after step {} ({}) did not converge: {}. Worst is point {} "
        "at r = {:.4g} mm, z = {:.4g} mm with stress rr {:.4g}, tt {:.4g}, zz "
        "{:.4g}, rz {:.4g} MPa (compression positive). {} may help",
        model_.last_step().step,
        name_of(kind(stage_)),
        reason(failure),
        failure.point,
        1e3 * failure.position[0],
        1e3 * failure.position[2],
        (0 - stress[0][0]) / 1e6,
        (0 - stress[1][1]) / 1e6,
        (0 - stress[2][2]) / 1e6,
        (0 - stress[0][2]) / 1e6,
        material_.cells ? "Smaller steps (Solver/Maximum step), a higher "
                          "Packing/Pressure or more grains"
                        : "Smaller steps (Solver/Maximum step)");
  }

  std::string reason(const fem::Failure &failure) const
  {
    const std::string problem = cells_.problem();
    return problem.empty() ? failure.reason
                           : failure.reason + " (" + problem + ")";
  }

  void give()
  {
    results_.give(session_);
    cells_.give();
    session_.heading("Time, share of the run");
    const fem::ModelTimes times = model_.times();
    session_.result("time_material[s]", times.material);
    session_.result("time_assembly[s]", times.assembly);
    session_.result("time_contact[s]", times.contact);
    session_.result("time_linear_solver[s]", times.linear_solver);
    session_.result("time_model[s]", times.total);
    session_.result("time_output[s]", time_output_);
  }

  void draw()
  {
    maps_.take_end(mesh_, model_);
    if (!session_.plots())
      return;
    const auto folder = session_.folder().subfolder("plots");
    if (!maps_.empty())
      maps_.write(folder);
    DiePlotFacts facts =
        plot_facts(settings_, results_.peak(), model_.last_step());
    facts.maps = !maps_.empty();
    const std::string problem = draw_plots(
        folder, die_plots(facts), session_.input().output.plot_formats);
    if (!problem.empty())
      session_.log().warn(problem);
  }

  RunSession &session_;
  const fem::Ranks &ranks_;
  const fem::DieSettings &settings_;
  const fem::Mesh &mesh_;
  DieMaterial material_;
  RecordedPoints points_;
  fem::DieModel model_;
  DieCells cells_;
  DieOutput output_;
  std::unique_ptr<CurveWriter> curve_; ///< of the first rank
  std::vector<double> steps_;
  unsigned stage_ = 0;
  DieResults results_;
  DieMaps maps_;
  double time_output_ = 0, time_plots_ = 0; ///< [s]
};

void warn_of_loose_cells(RunSession &session)
{
  const auto &material = session.input().material;
  if (material.kind == coupling::MaterialKind::unit_cell &&
      material.packing_files.empty() &&
      material.packing.goal.target == dem::CompressionTarget::pressure &&
      material.packing.goal.pressure < safe_start_pressure)
    session.warn(fmt::format(
        "Packing/Pressure = {:.3g} MPa: packings this loose may collapse in "
        "the first steps; 0.5 MPa or more is safe",
        material.packing.goal.pressure / 1e6));
}

// What lives until all ranks have ended: taking a model down needs them all.
struct Job {
  std::optional<RunSession> session;
  std::optional<DieRun> run;
};

RunEnd press(Job &job, const fem::Ranks &ranks)
{
  try {
    warn_of_loose_cells(*job.session);
    job.run.emplace(*job.session, ranks);
    return job.run->work();
  } catch (const PackingError &error) {
    return {exit_not_converged, error.what()};
  }
}
} // namespace

int run_die(const RunOptions &options)
{
  return run_under_mpi(
      [&options, job = std::make_shared<Job>()](const fem::Ranks &ranks) {
        RunSession &session = job->session.emplace(
            "die",
            options,
            Need::die,
            RankPlace{ranks.rank(), ranks.size(), ranks_on_these_cores(ranks)});
        return session.run([&] { return press(*job, ranks); });
      });
}
} // namespace tamp::apps
