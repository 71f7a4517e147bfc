// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>
#include <unistd.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

using namespace tamp::apps;

namespace
{
namespace fs = std::filesystem;

const std::string input = R"(include granules.prm
subsection Die
  set Elements                  = 1, 2
  set Radius                    = 6 mm
  set Fill height               = 7 mm
  set Wall friction coefficient = 0.2
end
subsection Schedule
  set Stages = press to density 0.61
end
subsection Output
  set Field interval = 2
  set Grain interval = 3
  set Grain points   = 1, 6
end
)";
constexpr int points = 8, grains = 60;

/// A small die with cells, run once, and its folder.
class Files : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    home =
        fs::temp_directory_path() / ("tamp_files_" + std::to_string(getpid()));
    fs::create_directories(home);
    fs::copy_file(fs::path(TAMP_TEST_INPUTS) / "granules.prm",
                  home / "granules.prm");
    std::ofstream(home / "die.prm") << input;
    RunOptions options;
    options.input = home / "die.prm";
    options.output = home / "results";
    options.plots = false;
    options.verbosity = Verbosity::quiet;
    exit_code = run_die(options);
  }
  static void TearDownTestSuite() { fs::remove_all(home); }

  /// The files that a .pvd file names.
  static std::vector<fs::path> files_of(const std::string &series)
  {
    std::ifstream in(home / "results" / series);
    std::stringstream text;
    text << in.rdbuf();
    const std::string content = text.str();
    const std::regex file("file=\"([^\"]+)\"");
    std::vector<fs::path> files;
    for (std::sregex_iterator i(content.begin(), content.end(), file), end;
         i != end;
         ++i)
      files.push_back(home / "results" / (*i)[1].str());
    return files;
  }
  /// The files of a folder with this ending.
  static std::set<fs::path> written(const std::string &folder,
                                    const std::string &ending)
  {
    std::set<fs::path> files;
    for (const auto &entry : fs::directory_iterator(home / "results" / folder))
      if (entry.path().extension() == ending)
        files.insert(entry.path());
    return files;
  }

  static inline fs::path home;
  static inline int exit_code = -1;
};

std::array<double, 2> range_of(vtkDataArray *array)
{
  std::array<double, 2> range;
  array->GetRange(range.data());
  return range;
}
} // namespace

TEST_F(Files, SeriesNameAllFilesAndOnlyThose)
{
  ASSERT_EQ(exit_code, exit_done);
  for (const auto &[series, folder, ending] :
       {std::array<std::string, 3>{"fields.pvd", "fields", ".vtu"},
        {"grains.pvd", "grains", ".vtp"}}) {
    const auto named = files_of(series);
    EXPECT_GE(named.size(), 3u) << series;
    EXPECT_EQ(std::set<fs::path>(named.begin(), named.end()),
              written(folder, ending));
  }
}

TEST_F(Files, FieldsHaveAQuadrilateralAPointWithItsValues)
{
  ASSERT_EQ(exit_code, exit_done);
  for (const fs::path &file : files_of("fields.pvd")) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkUnstructuredGrid *grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfCells(), points) << file;
    for (const char *name : {"displacement",
                             "stress_rr",
                             "stress_tt",
                             "stress_zz",
                             "stress_rz",
                             "pressure",
                             "relative_density",
                             "point",
                             "coordination_number"}) {
      vtkDataArray *array = grid->GetPointData()->GetArray(name);
      ASSERT_NE(array, nullptr) << file << ": " << name;
      EXPECT_EQ(array->GetNumberOfTuples(), 4 * points);
    }
    const auto values = [grid](const char *name) {
      return range_of(grid->GetPointData()->GetArray(name));
    };
    EXPECT_EQ(values("point"), (std::array<double, 2>{0, points - 1}));
    EXPECT_EQ(values("cell"), (std::array<double, 2>{0, points / 4 - 1}));
    // A jammed packing under pressure, powder signs.
    EXPECT_GT(values("relative_density")[0], 0.5);
    EXPECT_LT(values("relative_density")[1], 0.7);
    EXPECT_GT(values("stress_zz")[0], 0);
    EXPECT_GT(values("coordination_number")[0], 3);
    EXPECT_LT(values("coordination_number")[1], 12);
  }
}

TEST_F(Files, GrainsHaveRadiiAndContactsForces)
{
  ASSERT_EQ(exit_code, exit_done);
  for (const fs::path &file : files_of("grains.pvd")) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData *data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfVerts(), grains) << file;
    EXPECT_GT(data->GetNumberOfLines(), grains);
    vtkDataArray *radius = data->GetPointData()->GetArray("radius");
    vtkDataArray *force = data->GetCellData()->GetArray("normal_force");
    ASSERT_NE(radius, nullptr);
    ASSERT_NE(force, nullptr);
    EXPECT_LE(range_of(radius)[1], 325e-6);
    EXPECT_GE(range_of(radius)[1], 225e-6);
    EXPECT_GT(range_of(force)[1], 0);
  }
}
