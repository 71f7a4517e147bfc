// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/measured_curve.h>
#include <apps/input/units.h>

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

using namespace tamp::apps;

namespace
{
// What the reader says of a file with this text.
class MeasuredCurveFile : public testing::Test
{
protected:
  MeasuredCurveFile()
      : file_(std::filesystem::temp_directory_path() /
              fmt::format("tamp_measured_{}.csv", getpid()))
  {
  }
  ~MeasuredCurveFile() override { std::filesystem::remove(file_); }

  MeasuredCurve read(const std::string &text)
  {
    std::ofstream(file_, std::ios::binary) << text;
    return read_measured_curve(file_, reference_);
  }

  // The message without the folder: "curve:LINE: ...".
  std::string problem(const std::string &text)
  {
    try {
      read(text);
    } catch (const InputError &error) {
      const std::string message = error.what();
      const std::string name = file_.string();
      const auto at = message.find(name);
      return at == std::string::npos ? message
                                     : "curve" + message.substr(name.size());
    }
    return "it was read";
  }

  void expect_problem(const std::string &text,
                      const std::string &place,
                      const std::string &words)
  {
    const std::string said = problem(text);
    EXPECT_TRUE(said.starts_with(place)) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }

  void expect_same_as_plain(const std::string &text)
  {
    const auto plain = read(plain_).curve, other = read(text).curve;
    ASSERT_EQ(other.loading.size(), plain.loading.size());
    ASSERT_EQ(other.unloading.size(), plain.unloading.size());
    for (std::size_t i = 0; i < plain.loading.size(); ++i) {
      // A sum of powers of ten, in whatever unit, is exact but for rounding.
      EXPECT_DOUBLE_EQ(other.loading[i].relative_density,
                       plain.loading[i].relative_density);
      EXPECT_DOUBLE_EQ(other.loading[i].axial, plain.loading[i].axial);
    }
    EXPECT_DOUBLE_EQ(other.unloading[0].axial, plain.unloading[0].axial);
  }

  const std::string header_ = "relative_density[-],pressure[MPa]\n";
  const std::string rows_ =
      "0.4,0.5\n0.5,2\n0.6,8.5\n0.7,30\n0.8,100\n0.79,20\n";
  const std::string plain_ = header_ + rows_;
  CurveReference reference_;

private:
  std::filesystem::path file_;
};

std::string
replaced(std::string text, const std::string &from, const std::string &to)
{
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;
       at += to.size())
    text.replace(at, from.size(), to);
  return text;
}
} // namespace

TEST_F(MeasuredCurveFile, IsLoadedToItsLargestDensityThenUnloaded)
{
  const MeasuredCurve measured = read(plain_);
  ASSERT_EQ(measured.curve.loading.size(), 5u);
  ASSERT_EQ(measured.curve.unloading.size(), 1u);
  EXPECT_DOUBLE_EQ(measured.curve.peak().axial, 100e6);
  EXPECT_DOUBLE_EQ(measured.curve.peak().relative_density, 0.8);
  EXPECT_DOUBLE_EQ(measured.curve.unloading[0].axial, 20e6);
  EXPECT_FALSE(measured.curve.has_lateral);
}

TEST_F(MeasuredCurveFile, MayHaveAnyLineEndsMarkQuotesAndBlankLines)
{
  expect_same_as_plain(replaced(plain_, "\n", "\r\n"));
  expect_same_as_plain(replaced(plain_, "\n", "\r"));
  expect_same_as_plain("\xEF\xBB\xBF" + plain_);
  expect_same_as_plain("# rig 3\n\n" + replaced(plain_, "\n", "\n\n") + " \n");
  expect_same_as_plain(
      "\"relative_density[-]\",\"pressure[MPa]\"\n\"0.4\",\"0.5\"\n" +
      rows_.substr(8));
}

TEST_F(MeasuredCurveFile, MayHaveDecimalCommasWhereTheyDivideNoColumns)
{
  const std::string commas = replaced(replaced(plain_, ",", ";"), ".", ",");
  expect_same_as_plain(commas);
  expect_same_as_plain("sep=;\n" + commas);
  expect_same_as_plain(replaced(replaced(plain_, ",", "\t"), ".", ","));
  expect_same_as_plain(
      header_ +
      replaced(
          replaced(
              std::string("\"") +
                  replaced(rows_.substr(0, rows_.size() - 1), "\n", "\"\n\"") +
                  "\"\n",
              ",",
              "\",\""),
          ".",
          ","));
}

TEST_F(MeasuredCurveFile, MayHaveOtherUnitsNamesAndColumns)
{
  expect_same_as_plain("time[s],Relative density [-],comment,Pressure (MPa)\n"
                       "0,0.4,a,0.5\n1,0.5,,2\n2,0.6,b,8.5\n3,0.7,,30\n4,0.8,,"
                       "100\n5,0.79,,20\n");
  expect_same_as_plain("relative_density[%],axial_stress[kPa]\n"
                       "40,500\n50,2000\n60,8500\n70,30000\n80,1e+5\n79,2e4\n");
}

TEST_F(MeasuredCurveFile, HasDensityFromDisplacementHeightAndMass)
{
  reference_ = {.density_at_start = 0.4,
                .height_at_start = 0.01,
                .area = 1e-4,
                .solid_density = 2500};
  // rho h is constant: 0.4 * 10 mm.
  const auto at_end = [&](const std::string &header, const std::string &end) {
    const auto curve = read(header + "\n" + end).curve;
    EXPECT_NEAR(curve.peak().relative_density, 0.8, 1e-12);
    return curve.peak().axial;
  };
  const std::string rows = "0,1\n1,2\n2,3\n3,4\n5,5\n";
  // 5 kN on 1 cm2 are 50 MPa; exact but for rounding.
  EXPECT_NEAR(at_end("displacement[mm],force[kN]", rows), 50e6, 1e-6);
  at_end("height[mm],force[kN]", "10,1\n9,2\n8,3\n7,4\n5,5\n");
  at_end("density[g/cm3],force[kN]", "1,1\n1.2,2\n1.5,3\n1.8,4\n2,5\n");
  reference_ = {};
  expect_problem(
      "displacement[mm],force[kN]\n" + rows, "curve:1: ", "--density-at-start");
  reference_.density_at_start = 0.4;
  expect_problem(
      "displacement[mm],force[kN]\n" + rows, "curve:1: ", "--height-at-start");
  reference_.height_at_start = 0.01;
  expect_problem("displacement[mm],force[kN]\n" + rows, "curve:1: ", "--area");
}

TEST_F(MeasuredCurveFile, IsRefusedWithItsLineWhereUnitsAreMissingOrWrong)
{
  expect_problem(
      "relative_density[-],pressure\n" + rows_, "curve:1: ", "pressure[Pa]");
  expect_problem("relative_density,pressure[MPa]\n" + rows_,
                 "curve:1: ",
                 "relative_density[-]");
  expect_problem("relative_density[-],pressure[mm]\n" + rows_,
                 "curve:1: ",
                 "a unit of a pressure");
  expect_problem("relative_density[-],torque[MPa]\n" + rows_,
                 "curve:1: ",
                 "no column pressure[MPa]");
  expect_problem("time[s],pressure[MPa]\n" + rows_,
                 "curve:1: ",
                 "no column relative_density[-]");
  expect_problem("pressure[MPa],pressure[MPa]\n" + rows_,
                 "curve:1: ",
                 "no column relative_density[-]");
}

TEST_F(MeasuredCurveFile, IsRefusedIfEmptyOrOfAFewNumbers)
{
  expect_problem("", "curve:1: ", "empty");
  expect_problem("# nothing\n\n", "curve:2: ", "empty");
  expect_problem(header_, "curve:1: ", "nothing below the header");
  expect_problem("1, 2, 3\n", "curve:1: ", "expected a header");
  expect_problem("1\n2\n3\n", "curve:1: ", "expected a header");
  expect_problem(header_ + "0.4,1\n0.5,2\n0.6,3\n",
                 "curve:4: ",
                 "after 3 lines of loading");
}

TEST_F(MeasuredCurveFile, IsRefusedWithItsLineWhereItIsNoNumber)
{
  expect_problem(header_ + "0.4,0.5\n0.5,nan\n", "curve:3: ", "'nan'");
  expect_problem(header_ + "0.4,0.5\n0.5,inf\n", "curve:3: ", "'inf'");
  expect_problem(header_ + "0.4,0.5\n0.5,\n", "curve:3: ", "no value");
  expect_problem(header_ + "0.4,0.5\n0.5,2 MPa\n", "curve:3: ", "'2 MPa'");
  expect_problem(header_ + "0,4,0,5\n", "curve:2: ", "semicolons");
  expect_problem("relative_density[-];pressure[MPa]\n0,4;1.234,5\n",
                 "curve:2: ",
                 "nothing between thousands");
  expect_problem("relative_density[-];pressure[MPa]\n0.4;1,5\n",
                 "curve:2: ",
                 "decimal commas in line 2 and decimal points in line 2");
  expect_problem(header_ + "0.4,\"0.5\n", "curve:2: ", "quote");
  expect_problem(std::string("\xFF\xFEr\0e\0l\0", 8), "curve:1: ", "UTF-16");
}

TEST_F(MeasuredCurveFile, IsRefusedWithItsLineWhereItTurnsOrCannotBe)
{
  expect_problem(header_ + "0.4,1\n0.5,2\n0.45,3\n0.6,4\n0.7,5\n0.8,6\n",
                 "curve:4: ",
                 "relative density falls");
  expect_problem(header_ + "0.4,1\n0.5,2\n0.6,4\n0.7,5\n0.8,6\n0.7,1\n0.75,2\n",
                 "curve:8: ",
                 "relative density rises");
  expect_problem(header_ + "0.4,1\n0.5,20\n0.6,4\n0.7,25\n0.8,60\n",
                 "curve:4: ",
                 "pressure falls");
  expect_problem(header_ + "0.4,1\n0.5,20\n0.6,40\n0.7,50\n8.0,60\n",
                 "curve:6: ",
                 "relative density of 8");
  expect_problem(header_ + "0.4,-1\n0.5,-2\n0.6,-4\n0.7,-5\n0.8,-6\n",
                 "curve:2: ",
                 "compression positive");
}

TEST_F(MeasuredCurveFile, KeepsNoiseAsItIs)
{
  // Pressures 10 % off are noise, no unloading.
  EXPECT_EQ(problem(header_ +
                    "0.4,1\n0.5,2\n0.6,1.8\n0.7,5\n0.8,6\n0.79,1\n0.78,1.1\n"),
            "it was read");
}

TEST(MeasuredCurve, IsThinnedByAveragesOfEqualIntervals)
{
  CompactionCurve curve;
  constexpr int many = 1000;
  for (int i = 0; i <= many; ++i) {
    const double density = 0.4 + 0.4 * i / many;
    curve.loading.push_back({density, 100 * density, 10 * density});
  }
  const CompactionCurve few = thinned(curve, 21);
  ASSERT_EQ(few.loading.size(), 21u);
  EXPECT_EQ(few.peak().relative_density, curve.peak().relative_density);
  for (std::size_t i = 0; i < few.loading.size(); ++i) {
    const CompactionPoint &point = few.loading[i];
    // Averages of a straight line lie on it.
    EXPECT_NEAR(point.axial, 100 * point.relative_density, 1e-9);
    EXPECT_NEAR(point.lateral, 10 * point.relative_density, 1e-9);
    if (i > 0) {
      EXPECT_GT(point.relative_density, few.loading[i - 1].relative_density);
    }
  }
}
