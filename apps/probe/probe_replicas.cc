// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/probe/probe_replicas.h>
#include <apps/probe/replica_results.h>
#include <apps/run/build_facts.h>
#include <apps/run/checkpoints.h>
#include <apps/run/interrupt.h>
#include <apps/run/mpi_run.h>
#include <apps/run/rank_work.h>
#include <coupling/checkpoint.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/elastic.h>
#include <fem/ranks.h>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

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
             const fem::Ranks &ranks,
             const RunOptions &options,
             const ReplicaChoice &choice)
      : session_(session), ranks_(ranks), options_(options)
  {
    const auto &packing = session.input().material.packing;
    // The first rank alone knows its folder.
    const fs::path folder = ranks.first_text(session.folder().path().string());
    std::vector<long> sizes = choice.sizes;
    if (sizes.empty())
      sizes.push_back(static_cast<long>(packing.grain_count));
    std::ranges::sort(sizes);
    for (const long size : sizes)
      for (int i = 0; i < choice.replicas; ++i) {
        Replica one;
        one.size = size;
        one.seed = packing.seed + static_cast<std::uint64_t>(i);
        one.number = static_cast<unsigned>(i + 1);
        one.folder =
            folder / fmt::format("size_{:05d}_seed_{}", size, one.seed);
        replicas_.push_back(one);
      }
  }

  RunEnd work()
  {
    if (session_.place().first())
      remember_input();
    const std::vector<RunEnd> ends = probe_all();
    const auto signal = static_cast<int>(ranks_.largest(caught_signal()));
    if (signal != 0)
      return RunSession::interrupted(signal);
    for (std::size_t i = ends.size(); i-- > 0;) // the largest first
      if (!ends[i].message.empty())
        return ends[i];
    for (std::size_t i = 0; i < ends.size(); ++i)
      replicas_[i].code = ends[i].code;
    if (session_.place().first())
      give_replicas(session_, replicas_);
    for (const Replica &one : replicas_)
      if (one.code != exit_done)
        return {one.code,
                "the probe in " + one.folder.string() +
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

  std::vector<RunEnd> probe_all()
  {
    const std::string where =
        ranks_.size() > 1 ? fmt::format(" on {} ranks", ranks_.size()) : "";
    session_.log().begin(
        fmt::format("probing {} cells{}", replicas_.size(), where));
    RankWork shared;
    shared.order.resize(replicas_.size());
    std::iota(shared.order.rbegin(), shared.order.rend(), std::size_t(0));
    shared.threads = session_.threads();
    shared.work = [this](std::size_t i) { return probe(replicas_[i]); };
    shared.done = [this](std::size_t i, unsigned rank) { tell(i, rank); };
    const std::vector<RunEnd> ends = share_among_ranks(ranks_, shared);
    session_.log().end();
    return ends;
  }

  // A message only if the probe could not even begin.
  RunEnd probe(const Replica &one)
  {
    if (caught_signal())
      return {};
    const bool again = session_.resumes();
    if (again && is_done(one.folder))
      return {};
    RunOptions options = options_;
    options.output = one.folder;
    options.settings.push_back(fmt::format("Grains/Count = {}", one.size));
    options.settings.push_back(fmt::format("Packing/Seed = {}", one.seed));
    options.resume = again && can_go_on(one.folder);
    options.force = options.force || (again && !options.resume);
    options.threads = 1;
    options.verbosity = Verbosity::quiet;
    const int code = run_member(options, {one.number, &writing_});
    return {static_cast<ExitCode>(code), ""};
  }

  void tell(std::size_t i, unsigned rank)
  {
    if (caught_signal())
      return;
    const auto done = static_cast<double>(++done_);
    session_.log().step(
        done / static_cast<double>(replicas_.size()),
        done,
        "cells",
        replicas_[i].folder.filename().string() +
            (ranks_.size() > 1 ? fmt::format(" on rank {}", rank) : ""));
  }

  RunSession &session_;
  const fem::Ranks &ranks_;
  const RunOptions &options_;
  std::vector<Replica> replicas_; ///< by size, then by seed
  std::mutex writing_;
  unsigned done_ = 0;
};

void check(const ReplicaChoice &choice)
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
}

void check(const coupling::MaterialChoice &material)
{
  if (material.kind != coupling::MaterialKind::unit_cell ||
      !material.packing_files.empty())
    throw InputError("--replicas, --sizes: expected Material/Type = unit "
                     "cell with Packing/Source = generate; other powders "
                     "are the same every time");
}
} // namespace

int run_replicas(const RunOptions &options, const ReplicaChoice &choice)
{
  check(choice);
  RunOptions told = options;
  told.also_told = "set --replicas or --sizes = given\n";
  watch_checkpoint_signal();
  return run_under_mpi([&](const fem::Ranks &ranks) {
    const RankPlace place{
        ranks.rank(), ranks.size(), ranks_on_these_cores(ranks)};
    std::optional<RunSession> session;
    together(ranks,
             [&] { session.emplace("probe", told, Need::probe, place); });
    return session->run([&] {
      check(session->input().material);
      return ReplicaRun(*session, ranks, options, choice).work();
    });
  });
}
} // namespace tamp::apps
