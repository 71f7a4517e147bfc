// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/mixed_control.h>
#include <dem/six.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
using Kind = ComponentControl::Kind;

Driving driving_by(Method method)
{
  Driving driving;
  driving.method = method;
  driving.dynamics.strain_rate = 1e-4;
  return driving;
}

/// z is strained, x and y are under stress, no shear.
MixedControl triaxial(double strain, double stress)
{
  MixedControl control;
  control.components[0] = control.components[1] = {Kind::stress, stress};
  control.components[2].value = strain;
  return control;
}

/// Shear strains and normal stresses, and one shear stress.
MixedControl all_kinds()
{
  MixedControl control;
  control.components = {{{Kind::stress, -0.8e6},
                         {Kind::strain, -1.3e-3},
                         {Kind::stress, -0.7e6},
                         {Kind::strain, 4e-4},
                         {Kind::stress, 0.05e6},
                         {Kind::strain, -3e-4}}};
  return control;
}

/// Asserts that what was prescribed holds.
void expect_met(const MixedControl &control,
                const MixedAnswer &answer,
                const UnitCell &cell)
{
  EXPECT_EQ(answer.cell.outcome, Outcome::settled);
  const Six strain = to_six(answer.strain),
            stress = to_six(measure(cell).stress);
  double scale = std::abs(stress.head<3>().sum()) / 3;
  for (const ComponentControl &component : control.components)
    if (component.kind == Kind::stress)
      scale = std::max(scale, std::abs(component.value));
  for (int k = 0; k < 6; ++k) {
    const ComponentControl &component = control.components[k];
    if (component.kind == Kind::strain)
      EXPECT_EQ(strain[k], component.value) << k; // to the last bit
    else
      EXPECT_NEAR(stress[k], component.value, 1.0001 * 5e-3 * scale) << k;
  }
}

class MixedControlBy : public testing::TestWithParam<Method>
{
};

TEST_P(MixedControlBy, MeetsStrainsAndStressesOfEveryComponent)
{
  UnitCell cell = test::alumina_cell();
  const MixedControl control = all_kinds();
  const MixedAnswer answer =
      deform_mixed(cell, control, driving_by(GetParam()));
  expect_met(control, answer, cell);
}

TEST_P(MixedControlBy, HoldsTheLateralStressOfATriaxialPath)
{
  UnitCell cell = test::alumina_cell();
  const Driving driving = driving_by(GetParam());
  const Matrix3 first = cell.box.h;
  for (int k = 0; k < 5; ++k) {
    const MixedControl control = triaxial(-2e-3, -0.5e6);
    const MixedAnswer answer = deform_mixed(cell, control, driving);
    expect_met(control, answer, cell);
  }
  // Five stretches of exp(-2e-3), to round-off.
  EXPECT_NEAR(cell.box.h(2, 2) / first(2, 2), std::exp(-1e-2), 1e-14);
}

TEST_P(MixedControlBy, IsOrdinaryDeformationWithoutStresses)
{
  UnitCell mixed = test::alumina_cell(), plain = mixed;
  MixedControl control;
  control.components[1].value = -1e-3;
  const Driving driving = driving_by(GetParam());
  deform_mixed(mixed, control, driving);
  deform(plain, test::uniaxial(-1e-3), driving);
  EXPECT_EQ(mixed, plain);
}

TEST_P(MixedControlBy, ReleasesAllStresses)
{
  UnitCell cell = test::alumina_cell();
  MixedControl control;
  for (ComponentControl &component : control.components)
    component = {Kind::stress, 0};
  for (int k = 0; k < 3; ++k)
    control.components[k].value = -0.1e6;
  const MixedAnswer answer =
      deform_mixed(cell, control, driving_by(GetParam()));
  expect_met(control, answer, cell);
}

INSTANTIATE_TEST_SUITE_P(Both,
                         MixedControlBy,
                         testing::Values(Method::quasi_static,
                                         Method::dynamics),
                         [](const auto &info) {
                           return info.param == Method::dynamics ? "Dynamics"
                                                                 : "Map";
                         });

TEST(MixedControl, ByTheMapIsAFunctionOfTheCommittedCell)
{
  UnitCell a = test::alumina_cell(), b = a;
  const MixedControl control = triaxial(-1e-3, -0.5e6);
  const MixedAnswer answer = deform_mixed(a, control, {});
  deform_mixed(b, control, {});
  EXPECT_EQ(a, b);
  // The cell is one increment from where it was, not a sum of trials.
  const Matrix3 wanted = answer.stretch * test::alumina_cell().box.h;
  EXPECT_LT((a.box.h - wanted).norm(), 1e-14 * wanted.norm());
  EXPECT_EQ(answer.stretch, exponential(answer.strain));
}

TEST(MixedControl, BothMethodsFindTheSameLateralStrain)
{
  const auto lateral = [](Method method) {
    UnitCell cell = test::alumina_cell();
    Driving driving = driving_by(method);
    driving.dynamics.strain_rate = 2e-5;
    double sum = 0;
    for (int k = 0; k < 8; ++k)
      sum += deform_mixed(cell, triaxial(-5e-3, -0.5e6), driving)
                 .strain.diagonal()
                 .head<2>()
                 .sum();
    return sum;
  };
  const double map = lateral(Method::quasi_static);
  // Stresses within 0.5 % leave this much of a strain of 1e-2 open.
  EXPECT_NEAR(lateral(Method::dynamics), map, 0.1 * map);
}

TEST(MixedControl, TellsWhenAStressCannotBeMet)
{
  UnitCell cell = test::alumina_cell();
  MixedControl control = triaxial(0, -0.5e6);
  control.components[0].value = 1e9; // grains do not pull
  control.most_trials = 10;
  EXPECT_NE(deform_mixed(cell, control, {}).cell.outcome, Outcome::settled);
  UnitCell moving = test::alumina_cell();
  control = triaxial(0, -50e6);
  control.most_steps = 200;
  EXPECT_EQ(
      deform_mixed(moving, control, driving_by(Method::dynamics)).cell.outcome,
      Outcome::unsettled);
}

TEST(MixedControl, ComponentsMustBeNumbers)
{
  UnitCell cell = test::alumina_cell();
  MixedControl control;
  control.components[4].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(deform_mixed(cell, control, {}), std::invalid_argument);
}
} // namespace
} // namespace tamp::dem
