// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/output/curve_writer.h>
#include <apps/output/number_table.h>
#include <apps/output/plots.h>
#include <apps/probe/mean_curve.h>
#include <apps/probe/probe_replicas.h>
#include <apps/run/build_facts.h>
#include <apps/run/checkpoints.h>
#include <apps/run/interrupt.h>
#include <coupling/checkpoint.h>
#include <coupling/work_sharing.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/elastic.h>
#include <fem/ranks.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

/// One of the probes, and what came of it.
struct Member {
  long size = 0;
  std::uint64_t seed = 0;
  unsigned replica = 1;
  fs::path folder;
  int code = exit_done;
  NumberTable curve;
};

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

// Whether a probe came to its end in this folder.
bool is_done(const fs::path &folder)
{
  std::ifstream in(folder / "run.json");
  const auto tree = nlohmann::json::parse(in, nullptr, false);
  return tree.is_object() && tree.value("status", "") == "done";
}

// Whether it left a checkpoint there that can be used.
bool can_go_on(const fs::path &folder)
{
  try {
    return coupling::find_checkpoint(folder / "checkpoint",
                                     build_facts().version)
        .has_value();
  } catch (const coupling::FileError &) {
    return false;
  }
}

class ReplicaRun
{
public:
  ReplicaRun(RunSession &session,
             const RunOptions &options,
             const ReplicaChoice &choice)
      : session_(session), options_(options)
  {
    const auto &packing = session.input().material.packing;
    std::vector<long> sizes = choice.sizes;
    if (sizes.empty())
      sizes.push_back(static_cast<long>(packing.grain_count));
    std::ranges::sort(sizes);
    for (const long size : sizes)
      for (int i = 0; i < choice.replicas; ++i) {
        Member member;
        member.size = size;
        member.seed = packing.seed + static_cast<std::uint64_t>(i);
        member.replica = static_cast<unsigned>(i + 1);
        member.folder =
            session.folder().path() /
            fmt::format("size_{:05d}_seed_{}", member.size, member.seed);
        members_.push_back(member);
      }
  }

  RunEnd work()
  {
    remember_input();
    session_.log().begin(fmt::format("probing {} cells", members_.size()));
    std::vector<std::size_t> order(members_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::reverse(order); // the largest first
    coupling::share_work(
        order, session_.threads(), [this](std::size_t i) { probe(i); });
    session_.log().end();
    if (caught_signal())
      return RunSession::interrupted(caught_signal());
    gather();
    for (const Member &member : members_)
      if (member.code != exit_done)
        return {static_cast<ExitCode>(member.code),
                "the probe in " + member.folder.string() +
                    " did not end well, see there"};
    return {};
  }

private:
  // A checkpoint without a state: what --resume compares the input with. The
  // folders of the cells are all that it needs.
  void remember_input()
  {
    const fem::Ranks alone;
    const fem::ContinuumPoints<fem::Elastic> nothing(fem::Elastic({}), 0);
    Checkpoints(session_, alone).write(0, {}, nothing);
  }

  void probe(std::size_t i)
  {
    if (caught_signal())
      return;
    Member &member = members_[i];
    const bool again = session_.resumes();
    if (again && is_done(member.folder))
      return;
    RunOptions options = options_;
    options.output = member.folder;
    options.settings.push_back(fmt::format("Grains/Count = {}", member.size));
    options.settings.push_back(fmt::format("Packing/Seed = {}", member.seed));
    options.resume = again && can_go_on(member.folder);
    options.force = options.force || (again && !options.resume);
    options.threads = 1;
    options.verbosity = Verbosity::quiet;
    member.code = run_member(options, {member.replica, &writing_});
    const auto done = static_cast<double>(++done_);
    const std::lock_guard lock(writing_);
    session_.log().step(done / static_cast<double>(members_.size()),
                        done,
                        "cells",
                        member.folder.filename().string());
  }

  void gather()
  {
    CurveWriter replicas(session_.folder().path() / "replicas.csv",
                         replica_header);
    for (Member &member : members_) {
      member.curve = read_number_table(member.folder / "curve.csv");
      replicas.write(results_of(member));
    }
    for (const Member &member : members_)
      peaks_[member.size].push_back(results_of(member)[5]);
    write_mean();
    for (const char *name : {"yield.csv", "moduli.csv"})
      join(name);
    give();
    draw();
  }

  static std::vector<double> results_of(const Member &member)
  {
    const NumberTable &curve = member.curve;
    const std::size_t axial = curve.column("stress_zz[Pa]"),
                      density = curve.column("relative_density[-]");
    const auto peak = std::ranges::max_element(
        curve.rows, {}, [&](const auto &row) { return row[axial]; });
    return {static_cast<double>(member.size),
            static_cast<double>(member.seed),
            static_cast<double>(member.replica),
            static_cast<double>(member.code),
            curve.rows.back()[0],
            (*peak)[axial],
            (*peak)[curve.column("pressure[Pa]")],
            curve.rows.front()[density],
            (*peak)[density],
            curve.rows.back()[density]};
  }

  long largest() const { return members_.back().size; }

  void write_mean()
  {
    std::vector<ProbeCurve> curves;
    for (const Member &member : members_)
      if (member.size == largest())
        curves.push_back({member.curve, member.code == exit_done});
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

  // The lines of all members of the largest size.
  void join(const std::string &name)
  {
    if (!session_.input().scan.on())
      return;
    std::optional<CurveWriter> writer;
    for (const Member &member : members_) {
      if (member.size != largest())
        continue;
      const NumberTable table = read_number_table(member.folder / name);
      if (!writer)
        writer.emplace(
            session_.folder().path() / name, table.names, table.remarks);
      for (const auto &row : table.rows)
        writer->write(row);
    }
  }

  // The smallest size whose mean is that of the largest one as far as the
  // scatter of both means can tell, twice their standard error.
  void give()
  {
    long recommended = largest();
    const Scatter last = scatter_of(peaks_.at(largest()));
    for (const auto &[size, peaks] : peaks_) {
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
    session_.result("cells[-]", static_cast<double>(members_.size()));
    if (peaks_.size() > 1 && last.count > 1)
      session_.result("recommended_size[-]", static_cast<double>(recommended));
    if (last.count < 2)
      session_.warn("one cell of each size has no scatter: --replicas 3 or "
                    "more tells a band");
  }

  void draw()
  {
    std::vector<Plot> plots = replica_plots();
    if (session_.input().scan.on())
      std::ranges::move(scan_plots(), std::back_inserter(plots));
    session_.draw(plots);
  }

  RunSession &session_;
  const RunOptions &options_;
  std::vector<Member> members_; ///< by size, then by seed
  std::map<long, std::vector<double>> peaks_;
  std::mutex writing_;
  std::atomic<unsigned> done_ = 0;
};
} // namespace

int run_replicas(const RunOptions &options, const ReplicaChoice &choice)
{
  if (choice.replicas < 1)
    throw InputError(
        fmt::format("--replicas {}: expected a whole number of at least 1",
                    choice.replicas));
  for (const long size : choice.sizes)
    if (size < 1 || std::ranges::count(choice.sizes, size) > 1)
      throw InputError(fmt::format(
          "--sizes {}: expected different counts of grains, such as 200,500",
          size));
  RunOptions told = options;
  told.also_told = "set --replicas or --sizes = given\n";
  RunSession session("probe", told, Need::probe);
  watch_signals();
  watch_checkpoint_signal();
  return session.run([&]() -> RunEnd {
    const auto &material = session.input().material;
    if (material.kind != coupling::MaterialKind::unit_cell ||
        !material.packing_files.empty())
      throw InputError("--replicas, --sizes: expected Material/Type = unit "
                       "cell with Packing/Source = generate; other powders "
                       "are the same every time");
    return ReplicaRun(session, options, choice).work();
  });
}
} // namespace tamp::apps
