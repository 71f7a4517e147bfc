// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/curve_writer.h>
#include <apps/output/number_table.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

using namespace tamp::apps;

namespace
{
std::vector<std::string> lines_of(const std::filesystem::path &file)
{
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}
} // namespace

TEST(CurveWriter, KeepsAllDigits)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_curve_" + std::to_string(getpid()) + ".csv");
  const double third = 1. / 3, small = 4.9406564584124654e-324;
  {
    CurveWriter curve(file, {"step", "stress[Pa]", "x[-]"}, {"a remark"});
    curve.write(std::vector<double>{1, third, small});
    // Nothing waits in a buffer.
    EXPECT_EQ(lines_of(file).size(), 3u);
  }
  const auto lines = lines_of(file);
  EXPECT_EQ(lines[0], "# a remark");
  EXPECT_EQ(lines[1], "step,stress[Pa],x[-]");
  const std::size_t comma = lines[2].find(',');
  EXPECT_EQ(lines[2].substr(0, comma), "1");
  EXPECT_EQ(std::strtod(lines[2].c_str() + comma + 1, nullptr), third);
  EXPECT_EQ(std::strtod(lines[2].c_str() + lines[2].rfind(',') + 1, nullptr),
            small);
  std::filesystem::remove(file);
}

TEST(CurveWriter, SaysWhichFileCannotBeWritten)
{
  EXPECT_THROW(CurveWriter("/dev/null/curve.csv", {"step"}), OutputError);
}

TEST(CurveWriter, KeepsOnlyCompleteLinesWhenTheDiskIsFull)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_full_" + std::to_string(getpid()) + ".csv");
  // A limit on the size of files cuts a line like a disk that is full.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  {
    CurveWriter curve(file, {"step", "stress[Pa]"});
    curve.write(std::vector<double>{1, 2});
    rlimit small = before;
    small.rlim_cur = std::filesystem::file_size(file) + 5;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(curve.write(std::vector<double>{2, 123456789}), OutputError);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  }
  std::signal(SIGXFSZ, handler);
  const auto lines = lines_of(file);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines.back(), "1,2");
  EXPECT_EQ(std::filesystem::file_size(file), 20u);
  std::filesystem::remove(file);
}

TEST(CurveWriter, GoesOnWhereItWasAndRefusesWhatIsShorter)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_go_on_" + std::to_string(getpid()) + ".csv");
  std::uint64_t size = 0;
  {
    CurveWriter curve(file, {"step", "stress[Pa]"});
    curve.write(std::vector<double>{1, 2});
    size = curve.size();
    curve.write(std::vector<double>{2, 3});
  }
  {
    CurveWriter curve(file, 2, size);
    curve.write(std::vector<double>{2, 4});
  }
  EXPECT_EQ(lines_of(file),
            (std::vector<std::string>{"step,stress[Pa]", "1,2", "2,4"}));
  const std::uint64_t whole = std::filesystem::file_size(file);
  EXPECT_THROW(CurveWriter(file, 2, whole + 1), OutputError);
  EXPECT_EQ(std::filesystem::file_size(file), whole);
  std::filesystem::remove(file);
  EXPECT_THROW(CurveWriter(file, 2, 0), OutputError);
}

TEST(NumberTable, IsWhatWasWrittenToTheLastBit)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_table_" + std::to_string(getpid()) + ".csv");
  const std::vector<std::string> names{"step", "stress[Pa]"};
  const std::vector<std::string> remarks{"stage 1: press", "", "# a remark"};
  const std::vector<std::vector<double>> rows{{0, 1. / 3}, {1, -1e-300}};
  {
    CurveWriter writer(file, names, remarks);
    for (const auto &row : rows)
      writer.write(row);
  }
  const NumberTable table = read_number_table(file);
  EXPECT_EQ(table.remarks, remarks);
  EXPECT_EQ(table.names, names);
  EXPECT_EQ(table.rows, rows);
  std::filesystem::remove(file);
}

TEST(NumberTable, DamageIsAnErrorOfOutputThatNamesTheLine)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_table_" + std::to_string(getpid()) + ".csv");
  const auto complaint = [&] {
    try {
      read_number_table(file);
    } catch (const OutputError &error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint().find("there is no table"), std::string::npos);
  for (const auto &[text, words] : std::vector<std::array<std::string, 2>>{
           {"", ".csv:1: there is no header"},
           {"a,b\n1,2\n1\n", ".csv:3: '1': expected 2 values"},
           {"a,b\n1,nan\n", ".csv:2: 'nan': expected a finite number"}}) {
    std::ofstream(file) << text;
    EXPECT_NE(complaint().find(words), std::string::npos) << complaint();
  }
  std::filesystem::remove(file);
}
