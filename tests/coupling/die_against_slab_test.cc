// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <tests/coupling/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <vector>

namespace tamp::coupling
{
namespace
{
constexpr double radius = 6e-3, height = 12e-3; // [m]

/// What a cell does under uniaxial compression, compression positive.
struct CurvePoint {
  double stretch = 1;            ///< height over the first one [-]
  double axial = 0, lateral = 0; ///< [Pa]
};

/// The lateral stress is the mean of both directions.
CurvePoint state(double stretch, const fem::Response &response)
{
  return {stretch,
          -response.stress[2][2],
          -0.5 * (response.stress[0][0] + response.stress[1][1])};
}

std::vector<CurvePoint> curve_of_the_cell()
{
  UnitCellPoints points(test::same_cells(1), {});
  std::vector<CurvePoint> curve;
  std::vector<fem::Response> answer(1);
  fem::Deformation F;
  F.relative_F[0][0] = F.relative_F[1][1] = 1;
  for (int step = 0; step <= 60; ++step) {
    F.relative_F[2][2] = step == 0 ? 1 : 1 - 5e-3;
    points.evaluate(std::span(&F, 1), fem::Want::stress, answer);
    points.commit();
    curve.push_back(
        state(step == 0 ? 1 : curve.back().stretch * (1 - 5e-3), answer[0]));
  }
  return curve;
}

/// On the straight line between the points of the curve at this axial stress.
CurvePoint at(const std::vector<CurvePoint> &curve, double axial)
{
  std::size_t i = 1;
  while (i + 1 < curve.size() && curve[i].axial < axial)
    ++i;
  const CurvePoint &a = curve[i - 1], &b = curve[i];
  const double x = (axial - a.axial) / (b.axial - a.axial);
  return {a.stretch + x * (b.stretch - a.stretch),
          axial,
          a.lateral + x * (b.lateral - a.lateral)};
}

/// Stress of a column of slabs at both ends, compression positive [Pa].
struct Column {
  double upper = 0, lower = 0;
};

/// Janssen's (1895) slabs, each of which is pressed as the cell is: d axial /
/// dz = 4 mu lateral / D upwards from the lower punch, over the height that
/// the slabs have left; the stress there is such that all have `now` [m].
Column slabs(const std::vector<CurvePoint> &curve, double mu, double now)
{
  constexpr int count = 1000;
  const auto column = [&](double lower, double &left) {
    double stress = lower;
    left = 0;
    for (int i = 0; i < count; ++i) {
      const CurvePoint slab = at(curve, stress);
      const double thickness = slab.stretch * height / count;
      left += thickness;
      stress += 2 * mu * slab.lateral / radius * thickness;
    }
    return Column{stress, lower};
  };
  double low = curve[1].axial, high = curve.back().axial, left = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    column(middle, left);
    (left > now ? low : high) = middle;
  }
  return column(low, left);
}

/// What presses the punches of a die of the same cells after this way [Pa].
Column die(double mu, double way)
{
  fem::DieSettings settings;
  settings.geometry.radius = radius;
  settings.geometry.fill_height = height;
  settings.geometry.radial_elements = 1;
  settings.geometry.axial_elements = 6;
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(mu);
  fem::Stage press;
  press.target = fem::StageTarget::displacement;
  press.value = way;
  settings.stages = {press};
  const fem::Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells(test::same_cells(mesh.number_of_points()), {});
  fem::DieModel model(settings, mesh, cells);
  fem::Advance end;
  while ((end = model.advance()) == fem::Advance::stepped)
    ;
  EXPECT_EQ(end, fem::Advance::finished) << model.failure().reason;
  const fem::StepRecord &last = model.last_step();
  return {last.upper_force / last.punch_area,
          last.lower_force / last.punch_area};
}

TEST(DieOfCells, TransmitsPressureAsSlabsOfTheCellDo)
{
  // Slabs take stresses as uniform across, and all of the wall as slipping; on
  // the mesh the node at the lower punch sticks: a twelfth of the wall.
  constexpr double slab = 0.05;
  const std::vector<CurvePoint> curve = curve_of_the_cell();
  const double way = 0.12 * height;
  double last = 1;
  for (const double mu : {0.1, 0.2}) {
    const Column wanted = slabs(curve, mu, height - way);
    const Column found = die(mu, way);
    const double transmission = found.lower / found.upper;
    std::cout << "mu " << mu << ": upper " << found.upper << " Pa, slabs "
              << wanted.upper << "; lower " << found.lower << ", slabs "
              << wanted.lower << "; transmission " << transmission << ", slabs "
              << wanted.lower / wanted.upper << "\n";
    EXPECT_NEAR(found.upper / wanted.upper, 1, slab);
    EXPECT_NEAR(found.lower / wanted.lower, 1, slab);
    EXPECT_NEAR(transmission / (wanted.lower / wanted.upper), 1, slab);
    EXPECT_LT(transmission, last - 0.05); // friction keeps it back
    last = transmission;
  }
}
} // namespace
} // namespace tamp::coupling
