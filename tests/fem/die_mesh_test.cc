// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_mesh_data.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
std::string slurp(const std::string &file)
{
  std::ifstream stream(file);
  std::stringstream content;
  content << stream.rdbuf();
  return content.str();
}

std::string shipped() { return TAMP_MESHES "/cylinder_axisymmetric_4x7.msh"; }

/// What the mesh file says when read; empty if it can be read.
std::string complaint(const std::string &file)
{
  DieGeometry geometry;
  geometry.mesh_file = file;
  try {
    const DieMesh mesh(geometry);
  } catch (const std::runtime_error &error) {
    return error.what();
  }
  return "";
}

std::string complaint_about(const std::string &name, const std::string &content)
{
  const auto folder = std::filesystem::temp_directory_path();
  const std::string file = (folder / name).string();
  std::ofstream(file) << content;
  const std::string text = complaint(file);
  std::filesystem::remove(file);
  return text;
}

std::string
replaced(std::string text, const std::string &old, const std::string &now)
{
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, old.size(), now);
}
} // namespace

TEST(DieMesh, BuiltInMeshHasFourPointsACell)
{
  DieGeometry geometry;
  geometry.radial_elements = 2;
  geometry.axial_elements = 3;
  const DieMesh mesh(geometry);
  EXPECT_EQ(mesh.number_of_points(), 24u);
  EXPECT_EQ(mesh.data().wall.size(), 4u);
  EXPECT_EQ(mesh.data().punch_top.size(), 3u);
  EXPECT_DOUBLE_EQ(mesh.radius(), geometry.radius);
  EXPECT_DOUBLE_EQ(mesh.height(), geometry.fill_height);
  for (const auto &position : mesh.point_positions()) {
    EXPECT_GT(position[0], 0);
    EXPECT_LT(position[0], mesh.radius());
  }
}

TEST(DieMesh, GmshFileGivesTheSameToolsAsTheBuiltInMesh)
{
  DieGeometry geometry;
  const DieMesh built_in(geometry);
  geometry.mesh_file = shipped();
  const DieMesh read(geometry);
  EXPECT_EQ(read.number_of_points(), built_in.number_of_points());
  EXPECT_DOUBLE_EQ(read.radius(), built_in.radius());
  EXPECT_DOUBLE_EQ(read.height(), built_in.height());
  EXPECT_EQ(read.data().wall.size(), built_in.data().wall.size());
  EXPECT_EQ(read.data().axis.size(), built_in.data().axis.size());
  EXPECT_EQ(read.data().punch_top.size(), built_in.data().punch_top.size());
}

TEST(DieMesh, MissingFileIsNamed)
{
  EXPECT_EQ(complaint("nowhere.msh"), "cannot open mesh file 'nowhere.msh'");
}

TEST(DieMesh, MissingPhysicalNameIsNamed)
{
  const std::string text = complaint_about(
      "tamp_no_wall.msh", replaced(slurp(shipped()), "die_wall", "hull"));
  EXPECT_NE(text.find("no physical curve 'die_wall'"), std::string::npos)
      << text;
  EXPECT_NE(text.find("'punch_bottom'"), std::string::npos) << text;
}

TEST(DieMesh, TrianglesAreRefused)
{
  const std::string text = complaint_about(
      "tamp_triangles.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n"
      "1 1 \"punch_bottom\"\n1 2 \"die_wall\"\n1 3 \"punch_top\"\n"
      "1 4 \"axis\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
      "3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n6\n1 1 2 1 1 1 2\n"
      "2 1 2 2 2 2 3\n3 1 2 3 3 3 4\n4 1 2 4 4 4 1\n5 2 2 5 5 1 2 3\n"
      "6 2 2 5 5 1 3 4\n$EndElements\n");
  EXPECT_NE(text.find("not quadrilaterals"), std::string::npos) << text;
}

TEST(DieMesh, SlantingWallIsRefused)
{
  const std::string text = complaint_about(
      "tamp_slanting.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n"
      "1 1 \"punch_bottom\"\n1 2 \"die_wall\"\n1 3 \"punch_top\"\n"
      "1 4 \"axis\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
      "3 1.1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n5\n1 1 2 1 1 1 2\n"
      "2 1 2 2 2 2 3\n3 1 2 3 3 3 4\n4 1 2 4 4 4 1\n5 3 2 5 5 1 2 3 4\n"
      "$EndElements\n");
  EXPECT_NE(text.find("die_wall is not at constant r"), std::string::npos)
      << text;
}

TEST(DieMesh, OtherFilesAreRefused)
{
  EXPECT_NE(complaint_about("tamp_text.msh", "hello\n")
                .find("is not a gmsh file"),
            std::string::npos);
}
} // namespace tamp::fem
