// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/mesh_import.h>
#include <fem/mesh_quality.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
constexpr double pi = std::numbers::pi;

/// A file of the format 2.2; numbers start at 1.
struct MeshText {
  std::string format = "2.2 0 8";
  std::vector<std::string> names; ///< number i + 1
  unsigned dimension_of_names = 1;
  std::vector<std::array<double, 3>> nodes;
  /// Type of gmsh, physical number, nodes.
  std::vector<std::vector<int>> elements;

  std::string text() const
  {
    std::ostringstream out;
    out << "$MeshFormat\n" << format << "\n$EndMeshFormat\n";
    out << "$PhysicalNames\n" << names.size() << '\n';
    for (std::size_t i = 0; i < names.size(); ++i)
      out << dimension_of_names << ' ' << i + 1 << " \"" << names[i] << "\"\n";
    out << "$EndPhysicalNames\n$Nodes\n" << nodes.size() << '\n';
    for (std::size_t i = 0; i < nodes.size(); ++i)
      out << i + 1 << ' ' << nodes[i][0] << ' ' << nodes[i][1] << ' '
          << nodes[i][2] << '\n';
    out << "$EndNodes\n$Elements\n" << elements.size() << '\n';
    for (std::size_t i = 0; i < elements.size(); ++i) {
      out << i + 1 << ' ' << elements[i][0] << " 2 " << elements[i][1] << ' '
          << elements[i][1];
      for (std::size_t n = 2; n < elements[i].size(); ++n)
        out << ' ' << elements[i][n];
      out << '\n';
    }
    out << "$EndElements\n";
    return out.str();
  }
};

/// Two cells one above the other, 10 mm wide and 20 mm high.
MeshText two_cells()
{
  MeshText mesh;
  mesh.names = {"punch_bottom", "die_wall", "punch_top", "axis"};
  mesh.nodes = {{0, 0, 0},
                {0.01, 0, 0},
                {0, 0.01, 0},
                {0.01, 0.01, 0},
                {0, 0.02, 0},
                {0.01, 0.02, 0}};
  mesh.elements = {{1, 1, 1, 2},
                   {1, 2, 2, 4},
                   {1, 2, 4, 6},
                   {1, 3, 6, 5},
                   {1, 4, 5, 3},
                   {1, 4, 3, 1},
                   {3, 9, 1, 2, 4, 3},
                   {3, 9, 3, 4, 6, 5}};
  return mesh;
}

/// A cube of 10 mm.
MeshText cube()
{
  MeshText mesh;
  mesh.dimension_of_names = 2;
  mesh.names = {
      "punch_bottom", "die_wall", "punch_top", "symmetry_x", "symmetry_y"};
  for (const double z : {0., 0.01})
    for (const auto &corner : {std::array{0., 0.},
                               std::array{0.01, 0.},
                               std::array{0.01, 0.01},
                               std::array{0., 0.01}})
      mesh.nodes.push_back({corner[0], corner[1], z});
  mesh.elements = {{3, 1, 1, 2, 3, 4},
                   {3, 3, 5, 6, 7, 8},
                   {3, 5, 1, 2, 6, 5},
                   {3, 2, 2, 3, 7, 6},
                   {3, 2, 3, 4, 8, 7},
                   {3, 4, 4, 1, 5, 8},
                   {5, 9, 1, 2, 3, 4, 5, 6, 7, 8}};
  return mesh;
}

/// A file that lives as long as its test.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string &content)
      : name(std::filesystem::temp_directory_path() /
             (std::string("tamp_") +
              testing::UnitTest::GetInstance()->current_test_info()->name() +
              ".msh"))
  {
    std::ofstream(name) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(name); }
  const std::string name;
};

ImportedMesh import_text(const MeshText &mesh)
{
  return import_mesh(TemporaryFile(mesh.text()).name);
}

/// What the reader says of a file; empty if it takes it.
std::string complaint(const std::string &content)
{
  const TemporaryFile file(content);
  try {
    import_mesh(file.name);
  } catch (const std::runtime_error &error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find("mesh file '" + file.name + "': "), 0u) << text;
    return text;
  }
  return "";
}

std::string complaint(const MeshText &mesh)
{
  return complaint(mesh.text());
}

void expect_complaint(const MeshText &mesh,
                      const std::vector<std::string> &parts)
{
  const std::string text = complaint(mesh);
  for (const std::string &part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << text;
}
} // namespace

TEST(MeshImport, CylinderIsThatWhichIsBuilt)
{
  const Mesh read =
      import_mesh(TAMP_MESHES "/cylinder_axisymmetric_4x7.msh").mesh;
  const Mesh built = build_mesh({});
  ASSERT_EQ(read.nodes.size(), built.nodes.size());
  // gmsh writes 16 digits.
  for (std::size_t n = 0; n < built.nodes.size(); ++n)
    EXPECT_LT((read.nodes[n] - built.nodes[n]).norm(), 1e-13);
  for (unsigned tool = 0; tool < number_of_tools; ++tool)
    EXPECT_EQ(read.tools[tool].nodes, built.tools[tool].nodes);
  ASSERT_EQ(read.held.size(), built.held.size());
  for (std::size_t i = 0; i < read.held.size(); ++i)
    EXPECT_EQ(read.held[i].node, built.held[i].node);
  for (std::size_t cell = 0; cell < built.number_of_cells(); ++cell) {
    std::array<unsigned, 4> a, b;
    std::copy_n(read.nodes_of_cell(cell), 4, a.begin());
    std::copy_n(built.nodes_of_cell(cell), 4, b.begin());
    std::sort(a.begin(), a.end());
    EXPECT_EQ(a, b);
  }
}

TEST(MeshImport, ShippedMeshesHoldTheirShapes)
{
  struct Shape {
    std::string file;
    double volume, tolerance;
  };
  // Exact volumes; chords of a round outline miss what the tolerance says.
  const double c = 4 - pi, cap = pi * 1e-9 * (3 * 36 + 1) / 6;
  const double fillet = 2 * pi * (1e-6 * (1 - pi / 4)) * 4.22e-3;
  for (const Shape &shape : std::vector<Shape>{
           {"ring_axisymmetric", pi * 32e-6 * 7e-3, 1e-12},
           {"tablet_axisymmetric", pi * 36e-6 * 7e-3 + 2 * cap, 0.01},
           {"stepped_axisymmetric", pi * (16e-6 + 49e-6) * 4e-3 + fillet, 2e-3},
           {"cylinder_quarter", pi * 36e-6 * 7e-3, 0.02},
           {"square_die_quarter", (144 - 4 * c) * 7e-9, 0.02}}) {
    const ImportedMesh imported =
        import_mesh(TAMP_MESHES "/" + shape.file + ".msh");
    const Mesh &mesh = imported.mesh;
    EXPECT_TRUE(imported.remarks.empty()) << shape.file;
    EXPECT_NEAR(mesh.multiplicity() * mesh_volume(mesh) / shape.volume,
                1,
                shape.tolerance)
        << shape.file;
    EXPECT_GT(mesh_quality(mesh).scaled_jacobian, 0.7) << shape.file;
    // From below: a layer never starts again.
    for (std::size_t n = 1; n < mesh.nodes.size(); ++n)
      EXPECT_GT(mesh.nodes[n][2], mesh.nodes[n - 1][2] - 1e-9) << shape.file;
  }
}

TEST(MeshImport, QuarterHoldsItsPlanes)
{
  const Mesh mesh = import_text(cube()).mesh;
  EXPECT_EQ(mesh.section, Section::quarter);
  EXPECT_EQ(mesh.held.size(), 8u);
  for (const Mesh::Held &held : mesh.held)
    EXPECT_EQ(mesh.nodes[held.node][held.axis], 0);
  EXPECT_EQ(mesh.tools[die_wall].faces.size(), 8u);
  EXPECT_EQ(mesh.tools[upper_punch].nodes, (std::vector<unsigned>{4, 5, 6, 7}));
}

TEST(MeshImport, WithoutPlanesTheMeshIsFull)
{
  MeshText mesh = cube();
  mesh.names.resize(3);
  mesh.elements[2][1] = mesh.elements[5][1] = 2;
  const Mesh full = import_text(mesh).mesh;
  EXPECT_EQ(full.section, Section::full);
  EXPECT_TRUE(full.held.empty());
  EXPECT_EQ(full.tools[die_wall].faces.size(), 16u);
}

TEST(MeshImport, ClockwiseCellsAreTurned)
{
  MeshText mesh = two_cells();
  mesh.elements[6] = {3, 9, 1, 3, 4, 2};
  mesh.elements[7] = {3, 9, 3, 5, 6, 4};
  EXPECT_GT(mesh_quality(import_text(mesh).mesh).scaled_jacobian, 0.99);
}

TEST(MeshImport, LineEndsOfWindowsAreRead)
{
  std::string text;
  for (const char c : two_cells().text())
    text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(complaint(text), "");
}

TEST(MeshImport, WrongFilesAreNamed)
{
  EXPECT_THROW(import_mesh("nowhere.msh"), std::runtime_error);
  EXPECT_NE(complaint("hello\n").find("is no gmsh mesh"), std::string::npos);
  MeshText mesh = two_cells();
  mesh.format = "2.2 1 8";
  expect_complaint(mesh, {"is binary", "ASCII"});
  mesh.format = "4 0 8";
  expect_complaint(mesh, {"has the format 4;", "msh41"});
  std::string cut = two_cells().text();
  cut.resize(cut.size() - 60);
  EXPECT_FALSE(complaint(cut).empty());
}

TEST(MeshImport, WrongElementsAreNamed)
{
  MeshText mesh = two_cells();
  mesh.elements[6] = {2, 9, 1, 2, 3};
  mesh.elements.push_back({2, 9, 2, 4, 3});
  expect_complaint(mesh, {"has triangles (2)", "Recombine Surface"});
  mesh = two_cells();
  mesh.elements[6] = {10, 9, 1, 2, 4, 3, 1, 2, 4, 3, 1};
  expect_complaint(mesh, {"type 10", "first order"});
  mesh = two_cells();
  mesh.elements.resize(6);
  expect_complaint(mesh, {"no quadrilaterals", "Physical Surface"});
  mesh = cube();
  mesh.elements[6] = {4, 9, 1, 2, 3, 5};
  expect_complaint(mesh, {"has tetrahedra (1)"});
}

TEST(MeshImport, MissingNamesAreNamed)
{
  MeshText mesh = two_cells();
  mesh.names[1] = "hull";
  mesh.names[3] = "middle";
  expect_complaint(mesh, {"no physical curve 'die_wall', 'axis';", "core"});
  mesh = cube();
  mesh.names[2] = "lid";
  expect_complaint(mesh, {"no physical surface 'punch_top'"});
  mesh = cube();
  mesh.names[4] = "plane";
  expect_complaint(mesh, {"only one of 'symmetry_x'"});
}

TEST(MeshImport, FacesWithoutToolAreCounted)
{
  MeshText mesh = two_cells();
  mesh.elements.erase(mesh.elements.begin() + 1);
  expect_complaint(mesh, {"no tool: 1, ", "(r, z) = (10, 5) mm", "'core'"});
  mesh = two_cells();
  mesh.names.push_back("hole");
  mesh.elements[1][1] = mesh.elements[2][1] = 5;
  expect_complaint(mesh, {"no tool: 2, ", "(10, 5) mm to 'hole'"});
  mesh = two_cells();
  mesh.elements[1][1] = mesh.elements[2][1] = 3;
  expect_complaint(mesh, {"'die_wall' holds no face"});
}

TEST(MeshImport, NamesInsideThePowderAreRefused)
{
  MeshText mesh = two_cells();
  mesh.elements.push_back({1, 2, 3, 4});
  expect_complaint(mesh, {"lies inside the powder"});
}

TEST(MeshImport, AxisAndPlanesMustBeInPlace)
{
  MeshText mesh = two_cells();
  mesh.nodes[2][0] = 0.001;
  expect_complaint(mesh, {"'axis' is not at r = 0", "(r, z) = (1, 10) mm"});
  mesh.nodes[2][0] = -0.001;
  expect_complaint(mesh, {"negative r", "(-1, 10) mm"});
  mesh = cube();
  mesh.nodes[3][0] = 0.001;
  expect_complaint(mesh, {"'symmetry_x' is not at x = 0"});
  mesh = cube();
  mesh.nodes[1][1] = -0.001;
  expect_complaint(mesh, {"negative y", "(10, -1, 0) mm"});
  mesh = two_cells();
  std::swap(mesh.names[0], mesh.names[2]);
  expect_complaint(mesh, {"'punch_top' is not above 'punch_bottom'"});
}

TEST(MeshImport, SectionInAnotherPlaneIsRefused)
{
  MeshText mesh = two_cells();
  for (auto &node : mesh.nodes)
    std::swap(node[1], node[2]);
  expect_complaint(mesh, {"xy plane"});
}

TEST(MeshImport, BadCellsArePlaced)
{
  MeshText mesh = two_cells();
  mesh.nodes[3] = {0.01, 0.025, 0};
  expect_complaint(mesh, {"inverted cell", "scaled Jacobian", "mm"});
  // Just outside the line between its neighbours, then half a millimetre.
  mesh.nodes[3] = {0.00505, 0.00505, 0};
  expect_complaint(mesh, {"badly shaped cell", "(r, z)"});
  mesh.nodes[3] = {0.0055, 0.0055, 0};
  const ImportedMesh poor = import_text(mesh);
  ASSERT_EQ(poor.remarks.size(), 1u);
  EXPECT_NE(poor.remarks[0].find("(scaled Jacobian 0.2) at (r, z)"),
            std::string::npos)
      << poor.remarks[0];
}

TEST(MeshImport, NodesThatAreNotJoinedAreFound)
{
  MeshText mesh = two_cells();
  mesh.nodes.push_back(mesh.nodes[2]);
  mesh.nodes.push_back(mesh.nodes[3]);
  mesh.elements[7] = {3, 9, 7, 8, 6, 5};
  mesh.elements[2] = {1, 2, 8, 6};
  mesh.elements[4] = {1, 4, 5, 7};
  expect_complaint(mesh, {"lie where others do", "them: 2, ", "Coherence"});
}

TEST(MeshImport, HangingNodesAreFound)
{
  MeshText mesh = two_cells();
  mesh.nodes.push_back({0.005, 0.01, 0});
  mesh.nodes.push_back({0.005, 0.02, 0});
  mesh.elements[7] = {3, 9, 3, 7, 8, 5};
  mesh.elements.push_back({3, 9, 7, 4, 6, 8});
  mesh.elements[3] = {1, 3, 6, 8};
  mesh.elements.push_back({1, 3, 8, 5});
  expect_complaint(mesh, {"hanging node at (r, z) = (5, 10) mm"});
}

TEST(MeshImport, SeveralBodiesAreRefused)
{
  MeshText mesh = two_cells();
  for (const double z : {0.03, 0.04})
    for (const double r : {0., 0.01})
      mesh.nodes.push_back({r, z, 0});
  mesh.elements.push_back({3, 9, 7, 8, 10, 9});
  expect_complaint(mesh, {"2 parts", "(r, z) = (5, 35) mm"});
}

TEST(MeshImport, MillimetresAndUnusedNodesAreRemarked)
{
  MeshText mesh = two_cells();
  mesh.nodes.push_back({0.5, 0.5, 0});
  for (auto &node : mesh.nodes)
    for (double &coordinate : node)
      coordinate *= 1000;
  const ImportedMesh imported = import_text(mesh);
  ASSERT_EQ(imported.remarks.size(), 2u);
  EXPECT_NE(imported.remarks[0].find("left out: 1."), std::string::npos);
  EXPECT_NE(imported.remarks[1].find("20 m large"), std::string::npos);
  EXPECT_EQ(imported.mesh.nodes.size(), 6u);
}
} // namespace tamp::fem
