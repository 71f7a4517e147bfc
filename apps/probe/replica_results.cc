// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/curve_writer.h>
#include <apps/output/number_table.h>
#include <apps/output/plots.h>
#include <apps/output/scatter.h>
#include <apps/probe/mean_curve.h>
#include <apps/probe/replica_results.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <optional>

namespace tamp::apps
{
namespace
{
constexpr const char *peak_stress = "peak_axial_stress[Pa]";
const std::vector<std::string> replica_header{"size[-]",
                                              "seed[-]",
                                              "replica[-]",
                                              "exit_code[-]",
                                              "steps[-]",
                                              peak_stress,
                                              "peak_pressure[Pa]",
                                              "initial_relative_density[-]",
                                              "peak_relative_density[-]",
                                              "final_relative_density[-]"};
constexpr std::size_t peak_column = 5;

class ReplicaResults
{
public:
  ReplicaResults(RunSession &session, const std::vector<Replica> &replicas)
      : session_(session), replicas_(replicas)
  {
  }

  void give()
  {
    read();
    write_replicas();
    if (!of_largest_.empty())
      write_mean();
    for (const char *name : {"yield.csv", "moduli.csv"})
      join(name);
    give_peaks();
    warn();
    draw();
  }

private:
  struct Probe {
    Replica replica;
    ProbeCurve curve;
  };

  // A probe whose packing failed has no curve.
  void read()
  {
    for (const Replica &replica : replicas_) {
      const bool ended = replica.code == exit_done;
      const auto file = replica.folder / "curve.csv";
      if (!ended && !std::filesystem::exists(file))
        continue;
      Probe probe{replica, {read_number_table(file), ended}};
      if (!probe.curve.table.rows.empty())
        probes_.push_back(std::move(probe));
      else if (ended)
        throw OutputError(
            fmt::format("'{}' has no lines of numbers", file.string()));
    }
    for (const Probe &probe : probes_)
      if (probe.replica.size == largest())
        of_largest_.push_back(&probe);
  }

  static std::vector<double> results_of(const Probe &probe)
  {
    const NumberTable &curve = probe.curve.table;
    const std::size_t axial = curve.column("stress_zz[Pa]"),
                      density = curve.column("relative_density[-]");
    const auto peak = std::ranges::max_element(
        curve.rows, {}, [&](const auto &row) { return row[axial]; });
    return {static_cast<double>(probe.replica.size),
            static_cast<double>(probe.replica.seed),
            static_cast<double>(probe.replica.number),
            static_cast<double>(probe.replica.code),
            curve.rows.back()[0],
            (*peak)[axial],
            (*peak)[curve.column("pressure[Pa]")],
            curve.rows.front()[density],
            (*peak)[density],
            curve.rows.back()[density]};
  }

  void write_replicas()
  {
    CurveWriter writer(session_.folder().path() / "replicas.csv",
                       replica_header);
    for (const Probe &probe : probes_) {
      const std::vector<double> results = results_of(probe);
      writer.write(results);
      if (probe.curve.ended)
        peaks_[probe.replica.size].push_back(results[peak_column]);
    }
  }

  long largest() const { return replicas_.back().size; }

  void write_mean()
  {
    std::vector<ProbeCurve> curves;
    for (const Probe *probe : of_largest_)
      curves.push_back(probe->curve);
    const NumberTable mean = mean_curve(curves);
    std::vector<std::string> remarks{fmt::format(
        "mean of {} cells of {} grains; NAME_deviation: standard deviation",
        curves.size(),
        largest())};
    std::ranges::copy(mean.remarks, std::back_inserter(remarks));
    CurveWriter writer(
        session_.folder().path() / "curve.csv", mean.names, remarks);
    for (const auto &row : mean.rows)
      writer.write(row);
  }

  // The lines of all probes of the largest size.
  void join(const std::string &name)
  {
    if (!session_.input().scan.on())
      return;
    std::optional<CurveWriter> writer;
    for (const Probe *probe : of_largest_) {
      const NumberTable table = read_number_table(probe->replica.folder / name);
      if (!writer)
        writer.emplace(
            session_.folder().path() / name, table.names, table.remarks);
      for (const auto &row : table.rows)
        writer->write(row);
    }
  }

  // The smallest size whose mean is that of the largest one as far as the
  // scatter of both means can tell, twice their standard error.
  void give_peaks()
  {
    const Scatter last = scatter_of(peaks_[largest()]);
    long recommended = largest();
    for (const auto &[size, peaks] : peaks_) {
      if (peaks.empty())
        continue;
      const Scatter scatter = scatter_of(peaks);
      session_.heading(fmt::format("{} grains", size));
      session_.result(fmt::format("peak_axial_stress_{}[Pa]", size),
                      scatter.mean);
      session_.result(fmt::format("peak_axial_stress_deviation_{}[Pa]", size),
                      scatter.deviation);
      if (recommended == largest() &&
          std::abs(scatter.mean - last.mean) <=
              2 * std::hypot(scatter.of_mean(), last.of_mean()))
        recommended = size;
    }
    session_.heading("All cells");
    session_.result("cells[-]", static_cast<double>(replicas_.size()));
    if (peaks_.size() > 1 && last.count > 1)
      session_.result("recommended_size[-]", static_cast<double>(recommended));
  }

  void warn()
  {
    const auto broken = std::ranges::count_if(
        replicas_, [](const Replica &one) { return one.code != exit_done; });
    if (broken > 0)
      session_.warn(fmt::format(
          "{} of {} cells did not come to the end of the path: the mean in "
          "curve.csv ends where the first of its cells did, and peak stresses "
          "are those of the others",
          broken,
          replicas_.size()));
    if (std::ranges::count(replicas_, largest(), &Replica::size) < 2)
      session_.warn("one cell of each size has no scatter: --replicas 3 or "
                    "more tells a band");
  }

  void draw()
  {
    if (of_largest_.empty())
      return;
    std::vector<Plot> plots = replica_plots();
    if (session_.input().scan.on())
      std::ranges::move(scan_plots(), std::back_inserter(plots));
    session_.draw(plots);
  }

  RunSession &session_;
  const std::vector<Replica> &replicas_;
  std::vector<Probe> probes_;                 ///< those that have a curve
  std::vector<const Probe *> of_largest_;     ///< of these
  std::map<long, std::vector<double>> peaks_; ///< of each size [Pa]
};
} // namespace

void give_replicas(RunSession &session, const std::vector<Replica> &replicas)
{
  ReplicaResults(session, replicas).give();
}
} // namespace tamp::apps
