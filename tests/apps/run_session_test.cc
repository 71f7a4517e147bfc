// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run_session.h>

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

// A run whose work gives one result and throws.
template <class Error>
End run_that_throws(const Error &error)
{
  const auto folder = std::filesystem::temp_directory_path() /
                      ("tamp_session_" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "law.prm")
      << "subsection Material\nset Type = elastic\nend\n";
  RunOptions options;
  options.input = folder / "law.prm";
  options.output = folder / "results";
  options.verbosity = Verbosity::quiet;
  RunSession session("probe", options, Need::probe);
  End end;
  end.code = session.run([&]() -> RunEnd {
    session.result("steps[-]", 7);
    throw error;
  });
  std::ifstream in(options.output / "run.json");
  end.record.assign(std::istreambuf_iterator<char>(in), {});
  std::filesystem::remove_all(folder);
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
