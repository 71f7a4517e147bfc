// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/die/die_cells.h>
#include <apps/die/die_maps.h>
#include <apps/die/die_output.h>
#include <apps/die/die_plots.h>
#include <apps/die/die_results.h>
#include <apps/die/die_words.h>
#include <apps/die/recorded_points.h>
#include <apps/die/trial_recorder.h>
#include <apps/input/schedule.h>
#include <apps/input/units.h>
#include <apps/run/checkpoints.h>
#include <apps/run/interrupt.h>
#include <apps/run/mpi_run.h>
#include <apps/run/run_material.h>
#include <apps/run/stored_run.h>
#include <fem/die_model.h>
#include <fem/stop_watch.h>

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace tamp::apps
{
namespace
{
using fem::StageKind;

class DieRun
{
public:
  DieRun(RunSession &session, const fem::Ranks &ranks)
      : session_(session), ranks_(ranks), settings_(session.input().die),
        mesh_(session.input().mesh.mesh),
        material_(make_die_material(session, ranks)),
        points_(*material_.points, material_.cells), stored_(session, ranks),
        model_(
            settings_,
            mesh_,
            points_,
            [this](unsigned stage, double peak) { begin(stage, peak); },
            material_.model_ranks,
            stored_.model),
        cells_(session, model_, points_, material_.cells),
        output_(session, model_, points_, material_.cells),
        recorder_(session, mesh_, points_),
        results_(settings_.solver.least_reaction), checkpoints_(session, ranks)
  {
    if (session.resumes()) {
      go_on();
      return;
    }
    if (session.place().first())
      curve_ =
          std::make_unique<CurveWriter>(session.folder().path() / "curve.csv",
                                        die_header(),
                                        stage_remarks(settings_));
    output_.begin();
    recorder_.begin();
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
    if (!session_.resumes()) {
      take_step();
      write_output(0, true);
    }
    const RunEnd end = advance();
    log.end();
    cells_.end();
    recorder_.write(model_.last_step().step + 1, stage_, false);
    write_output(model_.last_step().step, true);
    return end;
  }

  RunEnd advance()
  {
    while (true) {
      // The ranks do not catch a signal in the same step.
      const auto signal = static_cast<int>(ranks_.largest(caught_signal()));
      if (checkpoints_.due() || signal != 0)
        write_checkpoint();
      if (signal != 0)
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

  // The parts of the run in the order in which a checkpoint has them.
  void write_checkpoint()
  {
    std::vector<char> bytes;
    if (curve_)
      curve_->sync();
    fem::append_state(bytes, curve_ ? curve_->size() : 0);
    fem::append_state(bytes, time_so_far());
    fem::append_state(bytes, time_output_);
    fem::append_state(bytes, stage_);
    fem::append_state(bytes, results_);
    output_.pack(bytes);
    recorder_.pack(bytes);
    cells_.pack(bytes);
    maps_.pack(bytes);
    session_.pack(bytes);
    std::vector<char> state;
    fem::append_state(state, bytes);
    model_.pack(state);
    checkpoints_.write(model_.last_step().step, state, material_.own());
  }

  void go_on()
  {
    coupling::unpack_points(session_.found(), material_.own(), ranks_);
    fem::StateBytes stored(stored_.run);
    std::uint64_t curve_size = 0;
    stored.take(curve_size);
    stored.take(time_before_);
    stored.take(time_output_);
    stored.take(stage_);
    stored.take(results_);
    if (session_.place().first())
      curve_ =
          std::make_unique<CurveWriter>(session_.folder().path() / "curve.csv",
                                        die_header().size(),
                                        curve_size);
    output_.go_on(stored);
    recorder_.go_on(stored);
    cells_.go_on(stored);
    maps_.go_on(stored);
    session_.go_on(stored);
  }

  void write_output(unsigned step, bool must)
  {
    const fem::StopWatch watch(time_output_);
    output_.write(step, must);
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
    effort.wall_time = time_so_far();
    cells_.measure(effort);
    if (curve_)
      curve_->write(die_values(record, effort));
    results_.take(record, stage_at(record.stage), effort);
    output_.write_point_lines();
    recorder_.write(record.step, record.stage, record.step > 0);
    cells_.judge(
        fmt::format("{} ({})", record.step, name_of(kind(record.stage))));
    if (results_.at_peak())
      maps_.take_peak(mesh_, model_);
    session_.log().step(share_done(settings_, record),
                        record.step,
                        "steps",
                        line(record, effort));
  }

  std::string line(const fem::StepRecord &record,
                   const StepEffort &effort) const
  {
    std::string text = step_line(
        record, kind(record.stage), material_.cells ? &effort : nullptr);
    const double share = share_done(settings_, record);
    if (share > 0.02)
      text += "  left " + duration(session_.log().progress().left(share));
    return text;
  }

  std::string describe(fem::Failure failure) const
  {
    failure.reason = reason(failure);
    return failure_words(failure,
                         model_.last_step().step,
                         kind(stage_),
                         material_.cells != nullptr);
  }

  std::string reason(const fem::Failure &failure) const
  {
    const std::string problem =
        failure.kind == fem::FailureKind::not_converged ? cells_.problem() : "";
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
    session_.draw(die_plots(facts));
  }

  // Of pressing, before and after a checkpoint [s].
  double time_so_far() const
  {
    return time_before_ + session_.log().progress().elapsed();
  }

  RunSession &session_;
  const fem::Ranks &ranks_;
  const fem::DieSettings &settings_;
  const fem::Mesh &mesh_;
  DieMaterial material_;
  RecordedPoints points_;
  const StoredRun stored_;
  fem::DieModel model_;
  DieCells cells_;
  DieOutput output_;
  TrialRecorder recorder_;
  std::unique_ptr<CurveWriter> curve_; ///< of the first rank
  unsigned stage_ = 0;
  DieResults results_;
  DieMaps maps_;
  Checkpoints checkpoints_;
  double time_before_ = 0; ///< of pressing, before the checkpoint [s]
  double time_output_ = 0, time_plots_ = 0; ///< [s]
};

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
  watch_checkpoint_signal(); // which would end the run while it packs
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
