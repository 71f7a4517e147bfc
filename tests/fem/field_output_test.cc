// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <tests/fem/test_points.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <unistd.h>
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
  pressed.model.write_fields(folder, "tamp_fields", {{"extra", extra, {}}});
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
                           "cell",
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

/// Reads the file of a model, written with its material's variables, if any.
vtkSmartPointer<vtkUnstructuredGrid> fields_of(const DieModel &model,
                                               const MaterialPoints &points)
{
  const auto file = std::filesystem::temp_directory_path() /
                    ("tamp_state_" + std::to_string(getpid()) + ".vtu");
  model.write_fields(file.parent_path(), file.stem(), variable_fields(points));
  const auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->SetFileName(file.c_str());
  reader->Update();
  std::filesystem::remove(file);
  return reader->GetOutput();
}

TEST(FieldOutput, ContactPressureIsTheStressAtTheTools)
{
  const Pressed pressed;
  const auto grid = fields_of(pressed.model, pressed.points);
  vtkDataArray *pressure = grid->GetPointData()->GetArray("contact_pressure");
  vtkDataArray *slip = grid->GetPointData()->GetArray("contact_slip");
  ASSERT_NE(pressure, nullptr);
  ASSERT_NE(slip, nullptr);
  const auto stress = [&](const char *name) {
    return grid->GetPointData()->GetArray(name)->GetTuple1(0);
  };
  const double radius = pressed.settings.geometry.radius;
  const double fill = pressed.settings.geometry.fill_height;
  const double closed = pressed.model.last_step().upper_displacement;
  unsigned at_wall = 0, at_punches = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    const double r = grid->GetPoint(i)[0], z = grid->GetPoint(i)[1];
    // Places have single precision; the tools let nothing through but 1e-6.
    const bool wall = r > radius * (1 - 1e-5);
    const bool punch = z < 1e-5 * fill || z > (fill - closed) * (1 - 1e-5);
    if (!wall && !punch)
      continue;
    // Where a punch meets the wall the larger of the two pressures is given.
    const double expected = stress(punch ? "stress_zz" : "stress_rr");
    // The state is uniform, the equilibrium that of the force tolerance.
    const bool corner = std::min(z, fill - closed - z) < 0.24 * fill;
    if (punch || !corner) {
      EXPECT_NEAR(pressure->GetTuple1(i) / expected, 1, 2e-3) << r << ' ' << z;
    }
    at_punches += punch;
    at_wall += wall && !punch && !corner;
  }
  EXPECT_GT(at_punches, 8u);
  EXPECT_GT(at_wall, 4u);
  double range[2];
  slip->GetRange(range);
  // The uppermost wall nodes slip as far as the punch goes in a step.
  EXPECT_GT(range[1], 1e-6);
  EXPECT_LT(range[1], closed);
}

TEST(FieldOutput, LawsSayWhatTheirPointsHold)
{
  DieSettings settings = Pressed::make_settings();
  const Mesh mesh = build_mesh(settings.geometry);
  const DruckerPragerCap law;
  ContinuumPoints<DruckerPragerCap> points(law, mesh.number_of_points());
  settings.solver.method = NonlinearMethod::newton;
  settings.steps.maximum = 2e-2;
  DieModel model(settings, mesh, points);
  while (model.advance() == Advance::stepped) {
  }
  const auto grid = fields_of(model, points);
  const auto value = [&](const std::string &name) {
    vtkDataArray *array = grid->GetPointData()->GetArray(name.c_str());
    EXPECT_NE(array, nullptr) << name;
    return array ? array->GetTuple1(0) : -1;
  };
  for (const Variable &variable : points.variables())
    value(variable.name);
  const auto &state = points.state(0);
  const double start = law.initial_state().plastic_compaction;
  // Single precision on disk.
  EXPECT_NEAR(value("plastic_volumetric_strain"),
              state.plastic_compaction - start,
              1e-6);
  // Part of the compaction is elastic.
  EXPECT_GT(value("plastic_volumetric_strain"), 0.01);
  EXPECT_LT(value("plastic_volumetric_strain"),
            std::log(value("relative_density") /
                     law.initial_state().relative_density));
  EXPECT_EQ(value("active_surface"),
            static_cast<double>(DruckerPragerCap::Surface::cap));
  EXPECT_NEAR(
      value("hydrostatic_yield_pressure") /
          law.parameters().hardening.read(state.plastic_compaction).value,
      1,
      1e-6);
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
