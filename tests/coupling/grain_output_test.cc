// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/grain_output.h>
#include <dem/measures.h>
#include <tests/coupling/sample_cells.h>

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

namespace tamp::coupling
{
namespace
{
TEST(GrainOutput, FileHoldsGrainsAndForces)
{
  const dem::UnitCell &cell = test::sample_cell();
  const auto file = std::filesystem::path(testing::TempDir()) / "cell.vtp";
  write_grains(cell, dem::Matrix3::Identity(), file);

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData *data = reader->GetOutput();
  const auto forces = dem::contact_forces(cell);
  EXPECT_EQ(std::size_t(data->GetNumberOfVerts()), cell.size());
  EXPECT_EQ(std::size_t(data->GetNumberOfLines()), forces.size() + 12);

  double volume = 0;
  vtkDataArray *radius = data->GetPointData()->GetArray("radius");
  ASSERT_NE(radius, nullptr);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    volume += 4.0 / 3 * std::numbers::pi * std::pow(radius->GetTuple1(i), 3);
  EXPECT_NEAR(volume / cell.solid_volume(), 1, 1e-12);

  vtkDataArray *normal = data->GetCellData()->GetArray("normal_force");
  ASSERT_NE(normal, nullptr);
  double sum = 0, wanted = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    sum += normal->GetTuple1(i);
  for (const dem::ContactForce &c : forces)
    wanted += c.normal_force;
  EXPECT_NEAR(sum / wanted, 1, 1e-12);
  std::filesystem::remove(file);
}

TEST(GrainOutput, UnwritableFileIsNamed)
{
  try {
    write_grains(
        test::sample_cell(), dem::Matrix3::Identity(), "/dev/null/cell.vtp");
    FAIL() << "no error";
  } catch (const std::exception &error) {
    EXPECT_NE(std::string(error.what()).find("cell.vtp"), std::string::npos);
  }
}
} // namespace
} // namespace tamp::coupling
