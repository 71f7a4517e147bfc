// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/calibration_report.h>
#include <apps/output/curve_writer.h>
#include <apps/output/plots.h>

#include <array>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
void write_curve(const std::filesystem::path &file,
                 const CompactionCurve &curve)
{
  std::vector<std::string> header{
      "unloading", "relative_density[-]", "axial_pressure[Pa]"};
  if (curve.has_lateral)
    header.emplace_back("lateral_pressure[Pa]");
  CurveWriter writer(file,
                     header,
                     {"compression is positive; unloading: 0 loading, 1 "
                      "unloading"});
  for (const bool unloading : {false, true})
    for (const CompactionPoint &point :
         unloading ? curve.unloading : curve.loading) {
      std::vector<double> values{
          unloading ? 1.0 : 0.0, point.relative_density, point.axial};
      if (curve.has_lateral)
        values.push_back(point.lateral);
      writer.write(values);
    }
}

void write_residuals(const std::filesystem::path &file,
                     const CurveTargets &targets,
                     const Eigen::VectorXd &residuals)
{
  CurveWriter writer(
      file,
      {"residual",
       "kind",
       "place[-]",
       "measured",
       "simulated",
       "scale",
       "residual[-]"},
      {"kind 0: axial pressure [Pa] at a relative density, loading; 1: lateral "
       "pressure [Pa] there",
       "kind 2: recovered axial strain [-] at a share of the peak pressure, "
       "unloading; 3: lateral over peak axial pressure [-] there",
       "residual = (simulated - measured) / scale; all have the same weight"});
  for (std::size_t i = 0; i < targets.all().size(); ++i) {
    const CurveTarget &target = targets.all()[i];
    const double residual = residuals[static_cast<Eigen::Index>(i)];
    writer.write(std::array{static_cast<double>(i + 1),
                            static_cast<double>(target.kind),
                            target.place,
                            target.value,
                            target.value + target.scale * residual,
                            target.scale,
                            residual});
  }
}

std::vector<Plot> plots(const CompactionCurve &measured)
{
  std::vector<Plot> all{{"calibration",
                         R"(set title "Measured and simulated compaction"
set xlabel "relative density [-]"
set ylabel "axial pressure [MPa]"
set logscale y
set format y "%g"
positive(p) = p > 0 ? p / 1e6 : NaN
plot "../measured.csv" using (column("relative_density[-]")):(positive(column("axial_pressure[Pa]"))) with points pointsize 1.2 title "measured", \
     "../curve.csv" using (column("relative_density[-]")):(positive(column("axial_pressure[Pa]"))) with lines title "simulated, first packing", \
     "../residuals.csv" using (column("kind") == 0 ? column("place[-]") : NaN):(column("simulated") / 1e6) with lines dashtype 2 title "simulated, mean of all packings"
)"},
                        {"residuals",
                         R"(set title "What the simulation misses"
set xlabel "number in residuals.csv"
set ylabel "(simulated - measured) / scale [%]"
kind(k) = column("kind") == k ? 100 * column("residual[-]") : NaN
plot 0 with lines linecolor rgb "#888888" linewidth 1 notitle, \
     "../residuals.csv" using (column("residual")):(kind(0)) with points pointsize 1.2 linetype 1 title "axial pressure, loading", \
     "" using (column("residual")):(kind(1)) with points pointsize 1.2 linetype 2 title "lateral pressure, loading", \
     "" using (column("residual")):(kind(2)) with points pointsize 1.2 linetype 3 title "recovered strain", \
     "" using (column("residual")):(kind(3)) with points pointsize 1.2 linetype 4 title "lateral pressure, unloading"
)"},
                        {"misfit",
                         R"(set title "Misfit of the runs"
set xlabel "run"
set ylabel "misfit [-]"
set logscale y
set format y "%g"
kind(k) = column("kind") == k ? column("misfit[-]") : NaN
plot "../calibration.csv" using (column("run")):(kind(1)) with points pointsize 1.2 title "survey", \
     "" using (column("run")):(kind(2)) with points pointsize 1.2 title "refinement", \
     "" using (column("run")):(kind(3)) with points pointsize 1.2 title "several packings"
)"}};
  if (measured.has_lateral)
    all.push_back({"lateral",
                   R"(set title "Lateral pressure"
set xlabel "axial pressure [MPa]"
set ylabel "lateral pressure [MPa]"
plot "../measured.csv" using (column("axial_pressure[Pa]") / 1e6):(column("lateral_pressure[Pa]") / 1e6) with points pointsize 1.2 title "measured", \
     "../curve.csv" using (column("axial_pressure[Pa]") / 1e6):(column("lateral_pressure[Pa]") / 1e6) with lines title "simulated"
)"});
  return all;
}
} // namespace

void write_best_curve(RunSession &session,
                      const CompactionCurve &measured,
                      const CompactionCurve &best,
                      const CurveTargets &targets,
                      const Eigen::VectorXd &residuals)
{
  const auto &folder = session.folder().path();
  write_curve(folder / "measured.csv", measured);
  write_curve(folder / "curve.csv", best);
  write_residuals(folder / "residuals.csv", targets, residuals);
  session.draw(plots(measured));
}

void give_confidence(RunSession &session,
                     const std::vector<FitParameter> &parameters,
                     const FitConfidence &confidence)
{
  for (const FitSentence &sentence : confidence_words(parameters, confidence))
    if (sentence.doubt)
      session.warn(sentence.text);
    else
      session.log().say(sentence.text);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const FitParameter &parameter = parameters[i];
    const FitEstimate &estimate = confidence.estimates[i];
    session.heading(parameter.path);
    const auto give = [&](const char *what, double value) {
      session.result(
          fmt::format("{} {}[{}]", parameter.path, what, parameter.unit),
          value);
    };
    give("best", estimate.value);
    give("standard error", estimate.standard_error);
    give("95 % from", estimate.low);
    give("95 % to", estimate.high);
    session.result(fmt::format("{} known within 10 %[-]", parameter.path),
                   estimate.determined && !estimate.at_bound ? 1 : 0);
  }
  session.heading("Correlations");
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t j = i + 1; j < parameters.size(); ++j)
      session.result(fmt::format("correlation of {} and {}[-]",
                                 parameters[i].path,
                                 parameters[j].path),
                     confidence.correlation(static_cast<Eigen::Index>(i),
                                            static_cast<Eigen::Index>(j)));
}
} // namespace tamp::apps
