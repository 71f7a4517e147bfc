// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_quality.h>
#include <fem/mesh_template.h>

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <set>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
std::string shipped(const std::string &name)
{
  return TAMP_MESHES "/" + name;
}

std::string complaint(const std::string &file, const std::string &parameters)
{
  try {
    import_geometry(file, parameters);
  } catch (const std::exception &error) {
    return error.what();
  }
  return "";
}
} // namespace

TEST(MeshTemplate, EveryTemplateGivesAGoodMesh)
{
  if (!has_gmsh())
    GTEST_SKIP() << "gmsh is not installed; its shipped meshes are read";
  unsigned count = 0;
  for (const auto &entry : std::filesystem::directory_iterator(TAMP_MESHES)) {
    if (entry.path().extension() != ".geo")
      continue;
    ++count;
    const ImportedMesh imported = import_geometry(entry.path().string(), "");
    EXPECT_TRUE(imported.remarks.empty()) << entry.path();
    EXPECT_GT(mesh_quality(imported.mesh).scaled_jacobian, 0.7) << entry.path();
  }
  EXPECT_EQ(count, 6u);
}

TEST(MeshTemplate, ParametersReachTheMesh)
{
  if (!has_gmsh())
    GTEST_SKIP() << "gmsh is not installed";
  const Mesh mesh = import_geometry(shipped("cylinder_axisymmetric.geo"),
                                    "R = 5e-3, H=0.01,nr = 2, nz=3")
                        .mesh;
  EXPECT_EQ(mesh.number_of_cells(), 6u);
  const double exact = std::numbers::pi * 25e-6 * 0.01;
  // gmsh writes 16 digits.
  EXPECT_NEAR(mesh_volume(mesh), exact, 1e-12 * exact);
}

TEST(MeshTemplate, WrongParametersAreNamed)
{
  const std::string file = shipped("cylinder_axisymmetric.geo");
  EXPECT_NE(complaint(file, "R = big").find("'R = big' is not of the form"),
            std::string::npos);
  EXPECT_NE(complaint(file, "R = 1; rm").find("not of the form"),
            std::string::npos);
  EXPECT_NE(complaint(file, "R = 1, R = 2").find("'R' is given twice"),
            std::string::npos);
  EXPECT_NE(complaint(file, "Q = 1").find("declares H, R, nr, nz"),
            std::string::npos);
  EXPECT_EQ(complaint("nowhere.geo", ""),
            "cannot open geometry file 'nowhere.geo'");
}

TEST(MeshTemplate, GmshSpeaksForItself)
{
  if (!has_gmsh())
    GTEST_SKIP() << "gmsh is not installed";
  // Spaces and quotes in the name do not reach a shell.
  const std::string file =
      std::filesystem::temp_directory_path() / "tamp bad's geometry.geo";
  std::ofstream(file) << "Point(1) = {0, 0, 0};\nLine(1) = {1, 2};\n";
  const std::string text = complaint(file, "");
  EXPECT_NE(text.find("gmsh cannot mesh '" + file), std::string::npos) << text;
  EXPECT_NE(text.find("point 2"), std::string::npos) << text;
  std::ofstream(file)
      << "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0};\nLine(1) = {1, 2};\n";
  EXPECT_NE(complaint(file, "").find("mesh file '" + file + "': has no "),
            std::string::npos);
  std::filesystem::remove(file);
}
} // namespace tamp::fem
