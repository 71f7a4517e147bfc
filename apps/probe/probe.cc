// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/input/units.h>
#include <apps/output/cell_columns.h>
#include <apps/output/curve_writer.h>
#include <apps/output/plots.h>
#include <apps/output/probe_columns.h>
#include <apps/probe/probe_replicas.h>
#include <apps/probe/probe_scan.h>
#include <apps/run/cell_remarks.h>
#include <apps/run/checkpoints.h>
#include <apps/run/interrupt.h>
#include <apps/run/run_material.h>
#include <apps/run/series_writer.h>
#include <apps/run/stored_run.h>
#include <coupling/grain_output.h>
#include <fem/path_walk.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <mutex>
#include <optional>

namespace tamp::apps
{
namespace
{
using SymmetricTensor = dealii::SymmetricTensor<2, 3>;

/// What of a path's past its later steps and its results need.
struct PathSoFar {
  unsigned step = 0;
  double strain = 0, axial = 0, lateral = 0, density = 0;
  double peak = 0, strain_at_peak = 0;
  double evaluations = 0, worst_unbalance = 0;
  unsigned doubtful = 0;
  /// Where the stage at hand began.
  struct Begin {
    unsigned stage;
    double peak, density;
  };
  std::optional<Begin> begin;
};

class ProbeRun
{
public:
  ProbeRun(RunSession &session, const ProbeMember &member)
      : session_(session), member_(member), path_(session.input().path),
        material_(prepare_material(session, {0, 1}, 1)),
        stages_(stages_of(path_)), walk_(
                                       *material_.points,
                                       stages_,
                                       [this](unsigned stage) { begin(stage); },
                                       session.input().stress_tolerance),
        grains_(session.folder(), "grains.pvd"),
        scan_(session, material_, member.replica), checkpoints_(session, alone_)
  {
    warn_of_history(session, material_.history);
    if (session.resumes())
      go_on();
    else
      curve_.emplace(
          session.folder().path() / "curve.csv", header(), remarks());
  }

  RunEnd work()
  {
    session_.log().begin("probing");
    RunEnd end;
    try {
      end = drive();
      session_.log().end();
      write_grains();
    } catch (...) {
      give(); // the results so far
      throw;
    }
    give();
    draw();
    return end;
  }

private:
  void give()
  {
    session_.result("steps[-]", now_.step);
    session_.result("peak_axial_stress[Pa]", now_.peak);
    session_.result("strain_at_peak[-]", now_.strain_at_peak);
    session_.result("final_strain[-]", now_.strain);
    session_.result("final_axial_stress[Pa]", now_.axial);
    session_.result("final_lateral_stress[Pa]", now_.lateral);
    session_.result("final_relative_density[-]", now_.density);
    if (material_.cells) {
      session_.result("force_evaluations[-]", now_.evaluations);
      session_.result("worst_unbalance[-]", now_.worst_unbalance);
    }
    session_.result("doubtful_steps[-]", now_.doubtful);
    scan_.give();
    if (now_.doubtful > 0)
      session_.warn(fmt::format(
          "doubtful answers in {} of the steps: {}",
          now_.doubtful,
          material_.cells
              ? "grains did not settle within Cell/Maximum evaluations"
              : "the law was asked beyond its tables"));
  }

  std::vector<std::string> header() const
  {
    std::vector<std::string> names = probe_header();
    if (material_.cells)
      std::ranges::copy(cell_header(driving().method == dem::Method::dynamics),
                        std::back_inserter(names));
    return names;
  }

  const dem::Driving &driving() const
  {
    return session_.input().material.driving;
  }

  std::vector<std::string> remarks() const
  {
    std::vector<std::string> lines{
        "compression is positive; strain is logarithmic, ln V"};
    for (std::size_t i = 0; i < path_.stages.size(); ++i)
      lines.push_back(
          fmt::format("stage {}: {}", i + 1, path_.stages[i].stage.name));
    return lines;
  }

  RunEnd drive()
  {
    while (true) {
      if (const auto end = walk_.advance())
        return *end == fem::PathEnd::finished
                   ? RunEnd()
                   : RunEnd{exit_not_converged, problem(*end)};
      take(walk_.last());
      const int signal = caught_signal();
      if (checkpoints_.due() || signal != 0)
        write_checkpoint();
      if (signal != 0)
        return RunSession::interrupted(signal);
    }
  }

  std::string problem(fem::PathEnd end) const
  {
    if (end == fem::PathEnd::not_reached)
      return fmt::format("the stage did not meet its stress: after step {} "
                         "axial strain is {:.4g}, axial stress {:.4g} MPa",
                         now_.step,
                         now_.strain,
                         now_.axial / 1e6);
    const std::string cell =
        material_.cells ? material_.cells->report().problem : "";
    return fmt::format("the increment after step {} did not converge{}, at "
                       "axial strain {:.4g}, axial stress {:.4g} MPa, "
                       "lateral stress {:.4g} MPa",
                       now_.step,
                       cell.empty() ? "" : " (" + cell + ")",
                       now_.strain,
                       now_.axial / 1e6,
                       now_.lateral / 1e6);
  }

  // The parts of the run in the order in which a checkpoint has them.
  void write_checkpoint()
  {
    std::vector<char> bytes;
    curve_->sync();
    fem::append_state(bytes, curve_->size());
    fem::append_state(bytes, now_);
    fem::append_state(bytes, grains_.entries());
    fem::append_state(bytes, written_);
    cell_remarks_.pack(bytes);
    scan_.pack(bytes);
    session_.pack(bytes);
    std::vector<char> state;
    fem::append_state(state, bytes);
    walk_.pack(state);
    checkpoints_.write(now_.step, state, *material_.points);
  }

  void go_on()
  {
    const StoredRun all(session_, alone_);
    coupling::unpack_points(session_.found(), *material_.points, alone_);
    fem::StateBytes stored(all.run), walk(all.model);
    std::uint64_t curve_size = 0;
    std::string grains;
    stored.take(curve_size);
    stored.take(now_);
    stored.take(grains);
    stored.take(written_);
    curve_.emplace(
        session_.folder().path() / "curve.csv", header().size(), curve_size);
    grains_.go_on(grains);
    grains_.remove_others("grains");
    cell_remarks_.go_on(stored);
    scan_.go_on(stored);
    session_.go_on(stored);
    aim();
    walk_.unpack(walk);
  }

  static std::vector<fem::PathStage> stages_of(const ProbePath &path)
  {
    std::vector<fem::PathStage> stages;
    for (const ProbeStage &probe : path.stages)
      stages.push_back(probe.stage);
    if (!path.increments.empty())
      stages.front().increments = path.increments;
    return stages;
  }

  void begin(unsigned stage)
  {
    if (!path_.increments.empty()) // a replay begins as it is
      return;
    now_.begin = {stage, now_.peak, now_.density};
    aim();
    if (material_.cells)
      material_.cells->turn();
  }

  // A stage that ends at a share of the peak, or at a density, learns here what
  // had been reached where it began.
  void aim()
  {
    if (!now_.begin)
      return;
    const auto [number, peak, density] = *now_.begin;
    const ProbeStage &probe = path_.stages[number];
    fem::PathStage &stage = stages_[number];
    if (probe.peak_share > 0)
      stage.until_stress = -probe.peak_share * peak;
    if (probe.density > 0)
      aim_at_density(probe, density, stage);
    if (!material_.cells)
      return;
    const double diameter =
        session_.input().material.packing.sizes.mean_diameter;
    const bool unloading = stage.has_until && stage.until_above;
    material_.cells->set_force_floor(
        unloading ? 0.1 * peak * diameter * diameter : 0);
  }

  void take(const fem::PathRecord &record)
  {
    const SymmetricTensor stress = -record.response.stress;
    const SymmetricTensor strain = compressive_strain(record.F);
    now_.density = record.response.relative_density;
    std::vector<double> values = probe_values(record);
    if (material_.cells)
      std::ranges::copy(cell_values(*material_.cells, 0, driving()),
                        std::back_inserter(values));
    curve_->write(values);
    remember(record, strain, stress);
    if (material_.cells)
      cell_remarks_.take(
          0,
          dem::judge(material_.cells->cell(0), driving(), trace(stress) / 3),
          [&] { return place(record); });
    scan_.take(record);
    report(record);
    if (now_.step % session_.input().output.grain_interval == 0)
      write_grains();
  }

  void remember(const fem::PathRecord &record,
                const SymmetricTensor &strain,
                const SymmetricTensor &stress)
  {
    now_.step = record.step;
    // Nobody wants to read -0.
    now_.strain = strain[2][2] + 0.0;
    now_.axial = stress[2][2] + 0.0;
    now_.lateral = 0.5 * (stress[0][0] + stress[1][1]) + 0.0;
    if (now_.axial > now_.peak) {
      now_.peak = now_.axial;
      now_.strain_at_peak = now_.strain;
    }
    if (material_.cells) {
      now_.evaluations += material_.cells->report().mean_evaluations();
      now_.worst_unbalance = std::max(
          now_.worst_unbalance, material_.cells->report().worst_unbalance);
    }
    now_.doubtful += record.response.status == fem::Status::doubtful;
  }

  std::string place(const fem::PathRecord &record) const
  {
    return fmt::format("step {} ({}), axial strain {:.4g}",
                       record.step,
                       stages_[record.stage].name,
                       now_.strain);
  }

  void report(const fem::PathRecord &record)
  {
    const double stages = std::max<double>(1, stages_.size());
    session_.log().step(
        record.stage / stages,
        record.step,
        "steps",
        fmt::format("step {:4d}  {:<12} strain {:.5f}  axial {:.4g} MPa  "
                    "lateral {:.4g} MPa  density {:.4f}",
                    record.step,
                    stages_[record.stage].name,
                    now_.strain,
                    now_.axial / 1e6,
                    now_.lateral / 1e6,
                    now_.density));
  }

  void write_grains()
  {
    if (!material_.cells ||
        session_.input().output.grain_output == GrainOutput::none ||
        written_ == now_.step)
      return;
    std::unique_lock<std::mutex> lock;
    if (member_.writing)
      lock = std::unique_lock(*member_.writing);
    session_.folder().subfolder("grains");
    const std::string file = fmt::format("grains/step_{:04d}.vtp", now_.step);
    coupling::write_grains(material_.cells->cell(0),
                           material_.cells->rotation(0),
                           session_.folder().path() / file);
    grains_.add(now_.step, 0, file);
    written_ = now_.step;
  }

  void draw()
  {
    std::vector<Plot> plots = probe_plots(material_.cells != nullptr);
    if (scan_.found())
      std::ranges::move(scan_plots(), std::back_inserter(plots));
    session_.draw(plots);
  }

  RunSession &session_;
  ProbeMember member_;
  const fem::Ranks alone_;
  const ProbePath &path_;
  coupling::Material material_;
  std::vector<fem::PathStage> stages_;
  PathSoFar now_;
  fem::PathWalk walk_;
  std::optional<CurveWriter> curve_;
  SeriesWriter grains_;
  ProbeScan scan_;
  CellRemarks cell_remarks_{session_, "cell", 1};
  Checkpoints checkpoints_;
  std::optional<unsigned> written_; ///< step of the last grains
};
} // namespace

int run_member(const RunOptions &options, const ProbeMember &member)
{
  RunSession session("probe", options, Need::probe);
  return session.run([&]() -> RunEnd {
    try {
      ProbeRun run(session, member);
      return run.work();
    } catch (const PackingError &error) {
      return {exit_not_converged, error.what()};
    }
  });
}

int run_probe(const RunOptions &options)
{
  watch_signals();
  watch_checkpoint_signal();
  return run_member(options, {});
}
} // namespace tamp::apps
