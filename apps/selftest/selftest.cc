// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/input/units.h>
#include <apps/run/build_facts.h>
#include <apps/run/mpi_run.h>
#include <apps/selftest/self_checks.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
using Checks = std::vector<SelfCheck> (*)();

double processor_time()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

SelfCheckRoom checked(const std::string &name, Checks work)
{
  SelfCheckRoom room;
  room.name = name;
  const double start = processor_time();
  try {
    room.checks = work();
  } catch (const std::exception &error) {
    room.problem = error.what();
  }
  room.seconds = processor_time() - start;
  return room;
}

int check_all()
{
  fmt::print("tamp {}: what it computes, beside what is known\n",
             build_facts().version);
  std::vector<SelfCheckRoom> rooms;
  for (const auto &[name, work] :
       {std::pair<const char *, Checks>{"contacts of grains", check_contacts},
        {"unit cells", check_cells},
        {"cells as material points", check_points},
        {"continuum laws", check_laws},
        {"dies", check_dies}}) {
    rooms.push_back(checked(name, work));
    fmt::print("{}", self_check_table({rooms.back()}));
    std::fflush(stdout);
  }
  std::size_t count = 0;
  double seconds = 0;
  for (const SelfCheckRoom &room : rooms) {
    count += room.checks.size();
    seconds += room.seconds;
  }
  const std::size_t failed = failures(rooms);
  fmt::print("\n{} checks, {} failed, {:.1f} s of processor time\n",
             count,
             failed,
             seconds);
  return failed == 0 ? exit_done : exit_check_failed;
}
} // namespace

double difference(const SelfCheck &check)
{
  const double less = check.value - check.reference;
  return check.reference == 0 ? less : less / std::abs(check.reference);
}

bool passes(const SelfCheck &check)
{
  return std::abs(difference(check)) <= check.tolerance;
}

std::size_t failures(const std::vector<SelfCheckRoom> &rooms)
{
  std::size_t count = 0;
  for (const SelfCheckRoom &room : rooms) {
    for (const SelfCheck &check : room.checks)
      count += !passes(check);
    count += !room.problem.empty();
  }
  return count;
}

std::string self_check_table(const std::vector<SelfCheckRoom> &rooms)
{
  std::string table;
  for (const SelfCheckRoom &room : rooms) {
    table += fmt::format("\n{} ({:.2f} s)\n{:<48} {:>12} {:>12} {:>10} {:>9}  "
                         "{:6}  {}\n",
                         room.name,
                         room.seconds,
                         "",
                         "value",
                         "reference",
                         "difference",
                         "tolerance",
                         "",
                         "source");
    for (const SelfCheck &check : room.checks)
      table += fmt::format("{:<48} {:>12.6g} {:>12.6g} {:>10.1e} {:>9.0e}  "
                           "{:6}  {}\n",
                           check.quantity,
                           check.value,
                           check.reference,
                           difference(check),
                           check.tolerance,
                           passes(check) ? "passed" : "FAILED",
                           check.source);
    if (!room.problem.empty())
      table += "FAILED before the end: " + room.problem + "\n";
  }
  return table;
}

void add_selftest(CLI::App &app, int &code)
{
  app.add_subcommand("selftest",
                     "Compute what is known in closed form, and compare")
      ->callback([&code] {
        code = run_under_mpi([](const fem::Ranks &ranks) {
          if (ranks.size() > 1)
            throw InputError(fmt::format(
                "tamp selftest runs on one rank, not on {}", ranks.size()));
          return check_all();
        });
      });
}
} // namespace tamp::apps
