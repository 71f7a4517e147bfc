// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <tests/fem/test_points.h>

#include <filesystem>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace tamp::fem
{
namespace
{
/// A frictionless compact pressed by a tenth.
struct Pressed {
  DieSettings settings;
  Mesh mesh;
  test::HenckyPoints points;
  DieModel model;

  static DieSettings make_settings()
  {
    DieSettings settings;
    settings.friction[die_wall] = FrictionCoefficient(0);
    settings.geometry.radial_elements = 2;
    settings.geometry.axial_elements = 3;
    settings.stages = {{StageKind::press, StageTarget::displacement, 7e-4}};
    return settings;
  }

  Pressed()
      : settings(make_settings()), mesh(build_mesh(settings.geometry)),
        points(mesh.number_of_points(), test::HenckyLaw()),
        model(settings, mesh, points)
  {
    while (model.advance() == Advance::stepped) {
    }
  }
};
} // namespace

TEST(FieldOutput, FileHoldsOneCellAPointWithAllFields)
{
  const Pressed pressed;
  const auto folder = std::filesystem::temp_directory_path();
  std::vector<double> extra(pressed.mesh.number_of_points(), 7.);
  pressed.model.write_fields(folder, "tamp_fields", {{"extra", extra}});
  const auto file = folder / "tamp_fields.vtu";
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(folder / "tamp_fields.vtu.part"));

  const auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkUnstructuredGrid *grid = reader->GetOutput();
  EXPECT_EQ(grid->GetNumberOfCells(), 24);
  vtkPointData *data = grid->GetPointData();
  for (const char *name : {"stress_rr",
                           "stress_tt",
                           "stress_zz",
                           "stress_rz",
                           "pressure",
                           "deviatoric_stress",
                           "relative_density",
                           "point",
                           "extra"})
    EXPECT_NE(data->GetArray(name), nullptr) << name;
  // Files speak powder: compression is positive. Single precision on disk.
  const StepRecord &last = pressed.model.last_step();
  EXPECT_NEAR(data->GetArray("stress_zz")->GetTuple1(0) /
                  (last.upper_force / last.punch_area),
              1,
              1e-5);
  vtkDataArray *displacement = data->GetArray("displacement");
  ASSERT_NE(displacement, nullptr);
  EXPECT_EQ(displacement->GetNumberOfComponents(), 3);
  double range[2];
  displacement->GetRange(range, 1);
  EXPECT_NEAR(range[0], -7e-4, 1e-9);
  std::filesystem::remove(file);
}

TEST(FieldOutput, UnwritableFileIsNamed)
{
  const Pressed pressed;
  try {
    pressed.model.write_fields("/nowhere/at/all", "fields");
    FAIL() << "wrote into a folder that does not exist";
  } catch (const std::runtime_error &error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all/fields.vtu"),
              std::string::npos);
  }
}
} // namespace tamp::fem
