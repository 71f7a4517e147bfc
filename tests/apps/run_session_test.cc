// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/run/run_session.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

using namespace tamp::apps;

namespace
{
struct End {
  int code = 0;
  std::string record; ///< run.json
};

// The folder of one test, with an input in it, removed at the end.
class Place
{
public:
  Place()
      : folder_(std::filesystem::temp_directory_path() /
                ("tamp_session_" + std::to_string(getpid())))
  {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "law.prm")
        << "subsection Material\nset Type = elastic\nend\n";
    options.input = folder_ / "law.prm";
    options.output = folder_ / "results";
    options.verbosity = Verbosity::quiet;
  }
  ~Place() { std::filesystem::remove_all(folder_); }
  Place(const Place &) = delete;
  Place &operator=(const Place &) = delete;

  RunOptions options;

private:
  std::filesystem::path folder_;
};

// A run whose work gives one result and throws.
template <class Error>
End run_that_throws(const Error &error)
{
  const Place place;
  RunSession session("probe", place.options, Need::probe);
  End end;
  end.code = session.run([&]() -> RunEnd {
    session.result("steps[-]", 7);
    throw error;
  });
  std::ifstream in(place.options.output / "run.json");
  end.record.assign(std::istreambuf_iterator<char>(in), {});
  return end;
}
} // namespace

TEST(RunSession, AComputationThatThrowsDidNotConvergeAndKeepsItsResults)
{
  const End end = run_that_throws(std::runtime_error(
      "-----\nAn error occurred in line 3\nAdditional information:\n  PETSc "
      "failed\n  twice\n\nStacktrace:\n#0\n-----"));
  EXPECT_EQ(end.code, exit_not_converged);
  EXPECT_NE(end.record.find("\"PETSc failed twice\""), std::string::npos)
      << end.record;
  EXPECT_NE(end.record.find("\"steps[-]\": 7"), std::string::npos);
}

TEST(RunSession, MemoryThatDoesNotSufficeIsNoTroubleWithFiles)
{
  EXPECT_EQ(run_that_throws(std::bad_alloc()).code, exit_not_converged);
}

TEST(RunSession, WhatCannotBeWrittenEndsWithFour)
{
  EXPECT_EQ(run_that_throws(OutputError("'a' cannot be written")).code,
            exit_output);
  EXPECT_EQ(run_that_throws(std::runtime_error("cannot write 'a'")).code,
            exit_output);
  EXPECT_EQ(run_that_throws(std::filesystem::filesystem_error(
                                "a", std::make_error_code(std::errc::io_error)))
                .code,
            exit_output);
}

TEST(RunSession, OtherRanksWriteNothingAndLeaveExceptions)
{
  const Place place;
  RunSession session("die", place.options, Need::die, {1, 2});
  session.log().begin("pressing");
  session.warn("loose");
  EXPECT_EQ(session.folder().subfolder("fields"), "");
  EXPECT_FALSE(session.plots());
  EXPECT_EQ(session.run([] {
    return RunEnd{exit_not_converged, "cut"};
  }),
            exit_not_converged);
  EXPECT_THROW(
      session.run([]() -> RunEnd { throw OutputError("'a' is full"); }),
      OutputError);
  EXPECT_FALSE(std::filesystem::exists(place.options.output));
}

TEST(RunSession, RanksShareTheCoresThatTheyMayUse)
{
  const unsigned cores = available_cores();
  EXPECT_EQ(checked_threads({}, {0, 4, 1}), cores);
  EXPECT_EQ(checked_threads({}, {1, 4, cores}), 1u);
  EXPECT_EQ(checked_threads({}, {1, 4, cores + 1}), 1u);
  EXPECT_EQ(checked_threads(3, {1, 4, cores + 1}), 3u); // as the user says
}
