// SPDX-License-Identifier: BSD-3-Clause
#include <apps/cell_columns.h>
#include <apps/cell_remarks.h>
#include <apps/commands.h>
#include <apps/curve_writer.h>
#include <apps/interrupt.h>
#include <apps/plots.h>
#include <apps/probe_columns.h>
#include <apps/probe_replicas.h>
#include <apps/probe_scan.h>
#include <apps/run_material.h>
#include <apps/series_writer.h>
#include <apps/units.h>
#include <coupling/grain_output.h>
#include <fem/path_driver.h>

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

struct Interrupted {
};

class ProbeRun
{
public:
  ProbeRun(RunSession &session, const ProbeMember &member)
      : session_(session), member_(member), path_(session.input().path),
        material_(prepare_material(session, {0, 1}, 1)),
        curve_(session.folder().path() / "curve.csv", header(), remarks()),
        grains_(session.folder(), "grains.pvd"),
        scan_(session, material_, member.replica)
  {
    warn_of_history(session, material_.history);
    for (const ProbeStage &probe : path_.stages)
      stages_.push_back(probe.stage);
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
    session_.result("steps[-]", step_);
    session_.result("peak_axial_stress[Pa]", peak_);
    session_.result("strain_at_peak[-]", strain_at_peak_);
    session_.result("final_strain[-]", strain_);
    session_.result("final_axial_stress[Pa]", axial_);
    session_.result("final_lateral_stress[Pa]", lateral_);
    session_.result("final_relative_density[-]", density_);
    if (material_.cells) {
      session_.result("force_evaluations[-]", evaluations_);
      session_.result("worst_unbalance[-]", worst_unbalance_);
    }
    session_.result("doubtful_steps[-]", doubtful_);
    scan_.give();
    if (doubtful_ > 0)
      session_.warn(fmt::format(
          "the answers of {} steps were doubtful: grains did not settle within "
          "Cell/Maximum evaluations, or a law was asked beyond its tables",
          doubtful_));
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
    const auto observe = [this](const fem::PathRecord &record) {
      take(record);
      if (caught_signal())
        throw Interrupted();
    };
    fem::PathEnd end = fem::PathEnd::finished;
    try {
      end = path_.increments.empty()
                ? fem::drive_path(
                      *material_.points,
                      stages_,
                      [this](unsigned stage) { begin(stage); },
                      observe,
                      session_.input().stress_tolerance)
                : fem::drive_increments(
                      *material_.points, path_.increments, observe);
      if (end == fem::PathEnd::finished)
        return {};
    } catch (const Interrupted &) {
      return RunSession::interrupted(caught_signal());
    }
    const std::string problem =
        material_.cells ? material_.cells->report().problem : "";
    if (end == fem::PathEnd::not_reached)
      return {exit_not_converged,
              fmt::format("the stage did not meet its stress: after step {} "
                          "axial strain is {:.4g}, axial stress {:.4g} MPa",
                          step_,
                          strain_,
                          axial_ / 1e6)};
    return {exit_not_converged,
            fmt::format("the increment after step {} did not converge{}, at "
                        "axial strain {:.4g}, axial stress {:.4g} MPa, "
                        "lateral stress {:.4g} MPa",
                        step_,
                        problem.empty() ? "" : " (" + problem + ")",
                        strain_,
                        axial_ / 1e6,
                        lateral_ / 1e6)};
  }

  // A stage that ends at a share of the peak, or at a density, learns here what
  // has been reached so far.
  void begin(unsigned stage)
  {
    if (path_.stages[stage].peak_share > 0)
      stages_[stage].until_stress = -path_.stages[stage].peak_share * peak_;
    if (path_.stages[stage].density > 0)
      aim_at_density(path_.stages[stage], density_, stages_[stage]);
    if (!material_.cells)
      return;
    material_.cells->turn();
    const double diameter =
        session_.input().material.packing.sizes.mean_diameter;
    const bool unloading =
        stages_[stage].has_until && stages_[stage].until_above;
    material_.cells->set_force_floor(
        unloading ? 0.1 * peak_ * diameter * diameter : 0);
  }

  void take(const fem::PathRecord &record)
  {
    const SymmetricTensor stress = -record.response.stress;
    const SymmetricTensor strain = compressive_strain(record.F);
    density_ = record.response.relative_density;
    std::vector<double> values = probe_values(record);
    if (material_.cells)
      std::ranges::copy(cell_values(*material_.cells, 0, driving()),
                        std::back_inserter(values));
    curve_.write(values);
    remember(record, strain, stress);
    if (material_.cells)
      cell_remarks_.take(
          0,
          dem::judge(material_.cells->cell(0), driving(), trace(stress) / 3),
          [&] { return place(record); });
    scan_.take(record);
    report(record);
    if (step_ % session_.input().output.grain_interval == 0)
      write_grains();
  }

  void remember(const fem::PathRecord &record,
                const SymmetricTensor &strain,
                const SymmetricTensor &stress)
  {
    step_ = record.step;
    // Nobody wants to read -0.
    strain_ = strain[2][2] + 0.0;
    axial_ = stress[2][2] + 0.0;
    lateral_ = 0.5 * (stress[0][0] + stress[1][1]) + 0.0;
    if (axial_ > peak_) {
      peak_ = axial_;
      strain_at_peak_ = strain_;
    }
    if (material_.cells) {
      evaluations_ += material_.cells->report().mean_evaluations();
      worst_unbalance_ =
          std::max(worst_unbalance_, material_.cells->report().worst_unbalance);
    }
    doubtful_ += record.response.status == fem::Status::doubtful;
  }

  std::string place(const fem::PathRecord &record) const
  {
    return fmt::format("step {} ({}), axial strain {:.4g}",
                       record.step,
                       stages_[record.stage].name,
                       strain_);
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
                    strain_,
                    axial_ / 1e6,
                    lateral_ / 1e6,
                    density_));
  }

  void write_grains()
  {
    if (!material_.cells ||
        session_.input().output.grain_output == GrainOutput::none ||
        written_ == step_)
      return;
    std::unique_lock<std::mutex> lock;
    if (member_.writing)
      lock = std::unique_lock(*member_.writing);
    session_.folder().subfolder("grains");
    const std::string file = fmt::format("grains/step_{:04d}.vtp", step_);
    coupling::write_grains(material_.cells->cell(0),
                           material_.cells->rotation(0),
                           session_.folder().path() / file);
    grains_.add(step_, 0, file);
    written_ = step_;
  }

  void draw()
  {
    if (!session_.plots())
      return;
    std::vector<Plot> plots = probe_plots(material_.cells != nullptr);
    if (scan_.found())
      std::ranges::move(scan_plots(), std::back_inserter(plots));
    const std::string problem =
        draw_plots(session_.folder().subfolder("plots"),
                   plots,
                   session_.input().output.plot_formats);
    if (!problem.empty())
      session_.log().warn(problem);
  }

  RunSession &session_;
  ProbeMember member_;
  const ProbePath &path_;
  coupling::Material material_;
  CurveWriter curve_;
  SeriesWriter grains_;
  ProbeScan scan_;
  CellRemarks cell_remarks_{session_, "cell", 1};
  std::vector<fem::PathStage> stages_;
  unsigned step_ = 0;
  std::optional<unsigned> written_;
  double strain_ = 0, axial_ = 0, lateral_ = 0, density_ = 0;
  double peak_ = 0, strain_at_peak_ = 0;
  double evaluations_ = 0, worst_unbalance_ = 0;
  unsigned doubtful_ = 0;
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
  if (options.resume)
    throw InputError("--resume: a single probe begins anew, with --force; "
                     "those of --replicas and --sizes go on");
  watch_signals();
  return run_member(options, {});
}
} // namespace tamp::apps
