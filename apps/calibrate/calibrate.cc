// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/calibrate.h>
#include <apps/calibrate/calibration.h>
#include <apps/calibrate/calibration_report.h>
#include <apps/calibrate/fit_confidence.h>
#include <apps/calibrate/measured_curve.h>
#include <apps/calibrate/packing_fit.h>
#include <apps/run/build_facts.h>
#include <apps/run/input_table.h>
#include <apps/run/interrupt.h>
#include <apps/run/mpi_run.h>
#include <apps/run/run_material.h>
#include <apps/run/run_resume.h>
#include <apps/run/stored_packings.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <sstream>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t most_points = 50; // of loading, and of unloading
constexpr std::size_t runs_per_parameter = 20;
constexpr double poor_misfit = 0.05;
// Unloading ends below the last measured place, to be met in between.
constexpr double unload_further = 0.95;
constexpr const char *packings = "packings";

double quantity_of(const std::string &option,
                   const std::string &text,
                   const Dimension &dimension)
{
  if (text.empty())
    return 0;
  try {
    return parse_quantity(text, dimension);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{} \"{}\": {}", option, text, error.what()));
  }
}

CurveReference reference_of(const CalibrationChoice &choice,
                            const RunOptions &options)
{
  constexpr Dimension area{2, 0, 0, 0};
  ParameterTable table;
  read_table(options, table);
  return {quantity_of(
              "--density-at-start", choice.density_at_start, dimension::number),
          quantity_of(
              "--height-at-start", choice.height_at_start, dimension::length),
          quantity_of("--area", choice.area, area),
          table.number("Grains/Density")};
}

/// A calibration from what a user says to its folder.
class Calibration
{
public:
  /// Reads and checks all before anything is written.
  Calibration(const CalibrationChoice &choice, const RunOptions &options)
      : choice_(choice),
        simulator_(choice.model == "die" ? CurveSimulator::Model::die
                                         : CurveSimulator::Model::probe)
  {
    input_.options = options;
    input_.need = choice.model == "die" ? Need::die : Need::probe;
    input_.parameters = read_fit_parameters(choice.fits, options);
    const MeasuredCurve measured =
        read_measured_curve(choice.data, reference_of(choice, options));
    refuse_to_remove(folder_of(options), options.force);
    measured_ = thinned(measured.curve, most_points);
    read_ = fmt::format("{} lines of {} in {}",
                        measured.rows,
                        measured.columns,
                        choice.data.filename().string());
    file_.emplace(options.resume
                      ? existing(folder_of(options)) / "calibration.csv"
                      : fs::path(),
                  remarks(),
                  input_.parameters);
  }

  RunEnd work(RunSession &session)
  {
    if (!input_.options.resume)
      file_.emplace(session.folder().path() / "calibration.csv",
                    remarks(),
                    input_.parameters);
    session.log().say(fmt::format(
        "{}: {} points of loading, {} of unloading{}",
        read_,
        measured_.loading.size(),
        measured_.unloading.size(),
        file_->stored() > 0
            ? fmt::format("; going on after run {}", file_->stored())
            : ""));
    pack(session);
    const std::vector<double> starts = start_densities();
    const double start = std::ranges::max(starts);
    const CurveTargets targets(measured_, start);
    if (targets.left_out() > 0)
      session.log().say(fmt::format(
          "{} measured places are left out: they lie below the relative "
          "density {:.4g} at which simulations start, or below 5 % of the peak "
          "in unloading",
          targets.left_out(),
          start));
    take_path(targets, starts);
    return search(session, targets);
  }

private:
  static fs::path folder_of(const RunOptions &options)
  {
    return options.output.empty() ? "results" / options.input.stem()
                                  : options.output;
  }

  /// The folder of an earlier run is no place for data.
  void refuse_to_remove(const fs::path &folder, bool force) const
  {
    if (force && fs::weakly_canonical(choice_.data).parent_path() ==
                     fs::weakly_canonical(folder))
      throw InputError(fmt::format(
          "--force would remove results from the folder of '{}', which this "
          "run reads. Nothing was changed; move the file, or choose another "
          "folder with --output",
          choice_.data.string()));
  }

  fs::path existing(const fs::path &folder) const
  {
    if (RunFolder::existing(folder).command() != "calibrate")
      throw InputError(fmt::format(
          "--resume: the run in '{}' is no calibration", folder.string()));
    return folder;
  }

  /// What makes a calibration another one.
  std::vector<std::string> remarks() const
  {
    ParameterTable table;
    read_table(input_.options, table);
    const RunInput input = read_input(table, input_.need);
    name_files_in_full(table);
    std::ostringstream echo;
    table.echo(echo);
    std::vector<fs::path> files = input.files;
    files.push_back(choice_.data);
    std::vector<std::string> lines{
        fmt::format("calibration with tamp {}: input and data {}",
                    build_facts().version,
                    text_hash(effective_input(whole_input(echo.str(), files)))),
        fmt::format("simulated with a {}, {} packings; displacement 0 is "
                    "relative density "
                    "'{}', height '{}'; area '{}'",
                    choice_.model,
                    choice_.packings,
                    choice_.density_at_start,
                    choice_.height_at_start,
                    choice_.area)};
    for (const FitParameter &parameter : input_.parameters)
      lines.push_back(
          fmt::format("fit {} {}, {}",
                      parameter.words(),
                      parameter.unit,
                      parameter.logarithmic ? "logarithmic" : "linear"));
    lines.emplace_back("misfit: root mean square of the residuals, which "
                       "residuals.csv explains; nan: the run failed");
    return lines;
  }

  /// Makes the packings of all runs: one for the search, others for the end.
  void pack(RunSession &session)
  {
    const auto &material = session.input().material;
    if (material.kind != coupling::MaterialKind::unit_cell ||
        !material.packing_files.empty())
      return;
    if (!material.densities.empty())
      throw InputError("a die of unit cells with an initial density cannot be "
                       "calibrated: all runs take the same packings");
    const bool die = input_.need == Need::die;
    const std::size_t of_die =
        die ? different_packings(material,
                                 session.input().mesh.mesh.number_of_points())
            : 0;
    packings_ = die ? 1 : choice_.packings;
    store_packings(session,
                   std::max<std::size_t>(of_die, packings_),
                   session.folder().subfolder(packings));
    own_packings_ = true;
    input_.shared = {
        "Packing/Source = file",
        fmt::format("Packing/File = {}",
                    fs::absolute(session.folder().path() / packings).string())};
    if (!die)
      for (unsigned k = 0; k < packings_; ++k)
        input_.of_packing.push_back(
            {fmt::format("Packing/Sample = {}", material.first_packing + k)});
  }

  /// The densities at which runs start, one per packing.
  std::vector<double> start_densities() const
  {
    if (input_.of_packing.empty())
      return {simulator_.start_density(input_.base())};
    std::vector<double> densities;
    for (unsigned k = 0; k < packings_; ++k)
      densities.push_back(simulator_.start_density(input_.base(k)));
    return densities;
  }

  /// The path of a probe is that of the measured curve; a die has its own
  /// schedule.
  void take_path(const CurveTargets &targets,
                 const std::vector<double> &start_densities)
  {
    if (input_.need == Need::die)
      return;
    if (input_.of_packing.empty())
      input_.of_packing.emplace_back();
    for (std::size_t k = 0; k < start_densities.size(); ++k) {
      std::string path =
          fmt::format("Path/Stages = uniaxial to strain {}",
                      std::log(targets.largest_density() / start_densities[k]));
      if (targets.lowest_share() > 0)
        path += fmt::format("; unload to {} % of peak",
                            100 * unload_further * targets.lowest_share());
      input_.of_packing[k].push_back(path);
    }
  }

  RunEnd search(RunSession &session, const CurveTargets &targets)
  {
    const std::size_t dimension = input_.parameters.size();
    SearchLimits limits;
    limits.dimension = dimension;
    limits.most_runs = choice_.most_runs > 0
                           ? choice_.most_runs
                           : runs_per_parameter * (dimension + 1);
    file_->open(targets.all().size());
    CalibrationRuns runs(
        session, input_, simulator_, targets, *file_, limits.most_runs);
    session.log().begin(
        fmt::format("fitting {} parameters to {} measured values",
                    dimension,
                    targets.all().size()));
    const SearchEnd end = search_least_squares(
        limits, [&](const std::vector<Eigen::VectorXd> &places, bool survey) {
          std::vector<CalibrationPlace> all;
          for (const Eigen::VectorXd &place : places)
            all.push_back({place, 0});
          return runs.evaluate(all,
                               survey ? RunKind::survey : RunKind::refinement);
        });
    PackingFit fit{end.samples[end.best], {}};
    if (packings_ > 1)
      fit = fit_mean_of_packings(runs, fit.best, end.jacobian, packings_);
    session.log().end();
    session.result("runs[-]", static_cast<double>(runs.runs()));
    session.result("failed_runs[-]", static_cast<double>(runs.failed()));
    session.result("packings[-]", fit.scatter.packings);
    session.result("converged[-]", end.converged ? 1 : 0);
    if (!end.converged)
      session.warn("the search ended with the number of runs; more of them "
                   "(--runs) may come nearer");
    report(session, targets, fit, end.jacobian);
    return {};
  }

  void report(RunSession &session,
              const CurveTargets &targets,
              const PackingFit &fit,
              const Eigen::MatrixXd &jacobian)
  {
    const auto count = static_cast<std::size_t>(fit.best.residuals.size());
    const double misfit = misfit_of({fit.best.residuals.data(), count});
    const std::string doubt = adjusted_pressure_doubt(
        input_.at({fit.best.place, 0}).material.packing);
    if (!doubt.empty())
      session.warn(doubt);
    session.folder().write(
        "best.prm",
        fmt::format(
            "# The best values of a calibration, misfit {:.4g}, tamp "
            "{}. Run it with tamp {}.\n{}{}",
            misfit,
            build_facts().version,
            choice_.model,
            doubt.empty() ? "" : "# Note: " + doubt + ".\n",
            input_.echo(fit.best.place, own_packings_ ? packings : "")));
    session.result("measured_values[-]", static_cast<double>(count));
    session.result("misfit[-]", misfit);
    if (misfit > poor_misfit)
      session.warn(fmt::format(
          "the best run misses the data by {:.1f} % (root mean square): see "
          "plots/calibration; errors count that as noise",
          100 * misfit));
    if (own_packings_ && packings_ == 1)
      session.warn("all runs had the same packings: errors do not hold what "
                   "others would change");
    const FitConfidence confidence =
        confidence_of(input_.parameters, fit.best, jacobian, fit.scatter);
    session.result("residuals_that_count_as_one[-]", confidence.alike);
    give_confidence(session, input_.parameters, confidence);
    const SimulatedCurve again = simulator_.run(input_.at({fit.best.place, 0}));
    write_best_curve(
        session, measured_, again.curve, targets, fit.best.residuals);
  }

  const CalibrationChoice &choice_;
  CurveSimulator simulator_;
  CalibrationInput input_;
  CompactionCurve measured_;
  std::string read_; ///< what was read, in words
  std::optional<CalibrationFile> file_;
  unsigned packings_ = 1;
  bool own_packings_ = false;
};

int run(Calibration &calibration,
        const CalibrationChoice &choice,
        const RunOptions &options)
{
  RunSession session(
      "calibrate", options, choice.model == "die" ? Need::die : Need::probe);
  return session.run([&]() -> RunEnd {
    try {
      return calibration.work(session);
    } catch (const SimulationInterrupted &) {
      return RunSession::interrupted(caught_signal());
    } catch (const PackingError &error) {
      return {exit_not_converged, error.what()};
    }
  });
}
} // namespace

int calibrate(const CalibrationChoice &choice, const RunOptions &options)
{
  Calibration calibration(choice, options);
  if (choice.model == "die")
    return run_under_mpi(
        [&](const fem::Ranks &) { return run(calibration, choice, options); });
  watch_signals();
  return run(calibration, choice, options);
}
} // namespace tamp::apps
