// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <tests/coupling/sample_cells.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::coupling
{
namespace
{
using fem::Advance;
using fem::Deformation;
using fem::DieModel;
using fem::DieSettings;
using fem::Mesh;
using fem::Response;
using fem::Stage;

/// Passes everything on; may spoil answers and remembers what point 0 was
/// told in the steps that were committed.
class Watched final : public fem::MaterialPoints
{
public:
  explicit Watched(UnitCellPoints &cells) : cells_(cells) {}

  std::size_t size() const override { return cells_.size(); }
  void begin_attempt() override { cells_.begin_attempt(); }
  void evaluate(std::span<const Deformation> deformations,
                fem::Want want,
                std::span<Response> responses) override
  {
    cells_.evaluate(deformations, want, responses);
    last_ = deformations[0];
    if (spoil)
      spoil(++evaluations_, responses);
  }
  void commit() override
  {
    cells_.commit();
    told.push_back(last_);
  }
  void pack(std::size_t i, std::vector<char> &bytes) const override
  {
    cells_.pack(i, bytes);
  }
  void unpack(std::size_t i, std::span<const char> bytes) override
  {
    cells_.unpack(i, bytes);
  }
  double cost(std::size_t i) const override { return cells_.cost(i); }

  std::function<void(unsigned, std::span<Response>)> spoil;
  std::vector<Deformation> told;

private:
  UnitCellPoints &cells_;
  Deformation last_;
  unsigned evaluations_ = 0;
};

DieSettings small_die(unsigned radial, unsigned axial, double density)
{
  DieSettings settings;
  settings.geometry.radial_elements = radial;
  settings.geometry.axial_elements = axial;
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0);
  Stage press;
  press.target = fem::StageTarget::density;
  press.value = density;
  settings.stages = {press};
  return settings;
}

std::vector<char> bytes_of(const fem::MaterialPoints &points)
{
  std::vector<char> bytes;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.pack(i, bytes);
  return bytes;
}

/// One element between frictionless tools has every displacement prescribed:
/// the only mesh on which a cell, never quite isotropic, is pressed uniformly.
TEST(DieWithCells, OneElementIsTheCellToTheBit)
{
  const DieSettings settings = small_die(1, 1, 0.66);
  const Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells(test::same_cells(4), test::cold());
  Watched points(cells);
  DieModel die(settings, mesh, points);
  std::vector<Response> pressed;
  while (die.advance() == Advance::stepped)
    pressed.push_back(die.responses()[0]);
  ASSERT_GT(pressed.size(), 15u);

  UnitCellPoints bare(test::same_cells(1), test::cold());
  ASSERT_EQ(points.told.size(), pressed.size());
  for (std::size_t step = 0; step < pressed.size(); ++step) {
    std::vector<Response> answer(1);
    bare.evaluate(
        std::span(points.told).subspan(step, 1), fem::Want::stress, answer);
    bare.commit();
    EXPECT_EQ(answer[0].stress, pressed[step].stress) << "step " << step;
  }
}

TEST(DieWithCells, FrictionlessPressingIsTheCurveOfTheCell)
{
  const DieSettings settings = small_die(1, 1, 0.66);
  const Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells(test::same_cells(4), test::cold());
  DieModel die(settings, mesh, cells);
  UnitCellPoints bare(test::same_cells(1), test::cold());
  double height = settings.geometry.fill_height;
  const double area =
      std::numbers::pi * settings.geometry.radius * settings.geometry.radius;
  unsigned steps = 0;
  Advance end;
  while ((end = die.advance()) == Advance::stepped) {
    ++steps;
    const double now =
        settings.geometry.fill_height - die.last_step().upper_displacement;
    Deformation F;
    F.relative_F[0][0] = F.relative_F[1][1] = 1;
    F.relative_F[2][2] = now / height;
    height = now;
    std::vector<Response> answer(1);
    bare.evaluate(std::span(&F, 1), fem::Want::stress, answer);
    bare.commit();
    const double wanted = -answer[0].stress[2][2];
    // Round-off of the stretch, as slips follow it.
    EXPECT_NEAR(die.last_step().upper_force / area / wanted, 1, 1e-10);
    EXPECT_NEAR(die.last_step().lower_force / area / wanted, 1, 1e-10);
  }
  EXPECT_EQ(end, Advance::finished);
  EXPECT_GT(steps, 15u);
}

TEST(DieWithCells, DensityOfElementsIsThatOfTheirCells)
{
  DieSettings settings = small_die(1, 2, 0.64);
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
  const Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells(test::different_cells(8), {});
  std::vector<double> start;
  for (std::size_t i = 0; i < cells.size(); ++i)
    start.push_back(cells.cell(i).relative_density());
  DieModel die(settings, mesh, cells);
  Advance end;
  while ((end = die.advance()) == Advance::stepped) {
    const fem::StepRecord &step = die.last_step();
    // The tools are in balance within the force tolerance.
    EXPECT_LE(std::abs(step.upper_force - step.lower_force -
                       step.wall_friction_force),
              settings.solver.force_tolerance *
                  std::max(step.upper_force, step.wall_normal_force));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double volume = dealii::determinant(die.deformation_gradients()[i]);
      EXPECT_NEAR(
          cells.cell(i).relative_density() * volume / start[i], 1, 1e-12);
      EXPECT_EQ(cells.cell(i).relative_density(),
                die.responses()[i].relative_density);
    }
  }
  EXPECT_EQ(end, Advance::finished);
}

TEST(DieWithCells, AStepThatFailsForGoodLeavesNoTrace)
{
  DieSettings settings = small_die(1, 2, 0.7);
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
  const Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells(test::different_cells(8), {});
  Watched points(cells);
  DieModel die(settings, mesh, points);
  ASSERT_EQ(die.advance(), Advance::stepped);
  ASSERT_EQ(die.advance(), Advance::stepped);
  const std::vector<char> committed = bytes_of(points);
  const double force = die.last_step().upper_force;

  points.spoil = [](unsigned, std::span<Response> responses) {
    responses[5].status = fem::Status::failed;
  };
  EXPECT_EQ(die.advance(), Advance::failed);
  EXPECT_EQ(die.failure().point, 5u);
  EXPECT_FALSE(die.failure().reason.empty());
  EXPECT_EQ(bytes_of(points), committed);
  EXPECT_EQ(die.last_step().upper_force, force);
}

TEST(DieWithCells, ACutStepIsTheShorterStepToTheBit)
{
  // The third step fails once and is halved; the other die is told to take
  // that half from the start.
  const auto run = [](bool fails, double largest) {
    DieSettings settings = small_die(1, 2, 0.7);
    settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
    settings.steps.first = settings.steps.maximum = largest;
    const Mesh mesh = fem::build_mesh(settings.geometry);
    UnitCellPoints cells(test::different_cells(8), {});
    Watched points(cells);
    DieModel die(settings, mesh, points);
    if (fails)
      points.spoil = [](unsigned number, std::span<Response> responses) {
        if (number == 2) // the first update of the first step
          responses[3].status = fem::Status::failed;
      };
    EXPECT_EQ(die.advance(), Advance::stepped);
    EXPECT_EQ(die.last_step().cuts, fails ? 1u : 0u);
    return bytes_of(points);
  };
  EXPECT_EQ(run(true, 4e-3), run(false, 2e-3));
}

TEST(DieWithCells, WhereAnAttemptFailsLeavesNoTrace)
{
  // The fourth step is cut whichever of its updates fails, and the run goes on
  // with warm cells: to the bit the same.
  const auto run = [](unsigned failing) {
    DieSettings settings = small_die(1, 2, 0.7);
    settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
    settings.solver.force_tolerance = 1e-5; // some updates to choose from
    const Mesh mesh = fem::build_mesh(settings.geometry);
    UnitCellPoints cells(test::different_cells(8), {});
    Watched points(cells);
    DieModel die(settings, mesh, points);
    for (unsigned step = 1; step <= 6; ++step) {
      unsigned update = 0;
      bool spoilt = step != 4;
      points.spoil = [&](unsigned, std::span<Response> responses) {
        if (++update == failing && !spoilt) {
          responses[3].status = fem::Status::failed;
          spoilt = true;
        }
      };
      EXPECT_EQ(die.advance(), Advance::stepped);
      EXPECT_TRUE(spoilt) << "update " << failing << " never came";
      EXPECT_EQ(die.last_step().cuts, step == 4 ? 1u : 0u);
    }
    return bytes_of(points);
  };
  const std::vector<char> wanted = run(1);
  for (const unsigned failing : {2u, 3u})
    EXPECT_EQ(run(failing), wanted) << "update " << failing;
}

TEST(DieWithCells, PressesUnloadsAndEjects)
{
  DieSettings settings = small_die(1, 2, 0.75);
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
  settings.solver.displacement_tolerance = 1e-2;
  Stage unload, eject;
  unload.kind = fem::StageKind::unload;
  unload.target = fem::StageTarget::peak_share;
  unload.value = 0.05;
  eject.kind = fem::StageKind::eject;
  eject.target = fem::StageTarget::displacement;
  eject.value = 0.3e-3;
  eject.hold_share = 0.05;
  settings.stages.push_back(unload);
  settings.stages.push_back(eject);
  const Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells(test::different_cells(8), {});
  double peak = 0;
  DieModel die(settings, mesh, cells, [&](unsigned, double pressure) {
    cells.turn();
    peak = pressure;
  });
  Advance end;
  while ((end = die.advance()) == Advance::stepped) {
    const fem::StepRecord &step = die.last_step();
    EXPECT_LE(
        std::abs(step.upper_force - step.lower_force -
                 step.wall_friction_force),
        settings.solver.force_tolerance *
            std::max(
                {step.upper_force, step.lower_force, step.wall_normal_force}))
        << "step " << step.step;
  }
  ASSERT_EQ(end, Advance::finished) << die.failure().reason;
  const fem::StepRecord &last = die.last_step();
  EXPECT_GT(peak, 3e6); // pressed well above the 0.5 MPa of the start
  EXPECT_NEAR(last.upper_force / last.punch_area / peak, 0.05, 1e-3);
  EXPECT_LT(last.wall_friction_force, 0); // the wall now holds it back
  EXPECT_NEAR(last.lower_displacement, 0.3e-3, 1e-9);
}
} // namespace
} // namespace tamp::coupling
