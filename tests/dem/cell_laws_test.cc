// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/mixed_control.h>
#include <dem/pair_path.h>
#include <tests/dem/sample_cells.h>

#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace tamp::dem
{
namespace
{
using test::alumina_cell;
using test::message_of;

// p_a = (2 E*^2 Gamma / (pi^2 R*))^(1/3) with E* = 1.92 GPa, R* = 113 um is
// 87 MPa at 100 J/m2; 0.425 of it is below p_y = 50 MPa up to 245 J/m2.
constexpr double bearable = 230, unbearable = 260;

/// What `call` is refused with; "" if it is not.
template <class Call>
std::string refusal(Call &&call)
{
  return message_of<std::invalid_argument>(call);
}

bool names_pressure(const std::string &message)
{
  return message.find("limiting contact pressure = 5e+07: must be at least") !=
         message.npos;
}

ContactModel sticky(double adhesion)
{
  return {.normal_law = NormalLaw::thornton_ning_jkr,
          .work_of_adhesion = adhesion};
}

TEST(CellLaws, TooMuchAdhesionForTheYieldingGrainsIsRefusedAtEveryDoor)
{
  PackingRequest request = test::alumina_request();
  request.contact = sticky(unbearable);
  EXPECT_TRUE(names_pressure(refusal([&] { (void)make_packing(request); })));

  UnitCell cell = alumina_cell();
  cell.contact = sticky(unbearable);
  const UnitCell before = cell;
  EXPECT_TRUE(names_pressure(
      refusal([&] { (void)deform(cell, test::uniaxial(-1e-4), {}); })));
  EXPECT_TRUE(
      names_pressure(refusal([&] { (void)deform_mixed(cell, {}, {}); })));
  EXPECT_EQ(cell, before);

  const GrainMaterial &solid = cell.materials[0];
  const double fine = 0.5 * cell.smallest_radius();
  const PairLaws laws = pair_laws(cell.contact, solid, solid);
  EXPECT_TRUE(names_pressure(refusal([&] {
    PairContact(laws, {4 * fine, fine, 0, 0});
  })));
  EXPECT_EQ(refusal([&] {
              PairContact(laws, {8 * fine, 2 * fine, 0, 0});
            }),
            "");
}

TEST(CellLaws, BearableAdhesionIsNotRefused)
{
  UnitCell cell = alumina_cell();
  cell.contact = sticky(bearable);
  EXPECT_EQ(refusal([&] { CellLaws(cell).check(cell); }), "");
  cell.contact = sticky(unbearable);
  cell.contact.normal_law = NormalLaw::jkr; // yields under no pressure
  EXPECT_EQ(refusal([&] { CellLaws(cell).check(cell); }), "");
}

TEST(CellLaws, TheSmallestGrainsOfEachKindAreChecked)
{
  UnitCell cell = alumina_cell();
  cell.contact = sticky(bearable);
  cell.materials.push_back(cell.materials[0]);
  cell.species.assign(cell.size(), 0);
  EXPECT_EQ(refusal([&] { CellLaws(cell).check(cell); }), "");
  // A softer kind that no grain is of does not matter.
  cell.materials[1].limiting_pressure = 5e6;
  EXPECT_EQ(refusal([&] { CellLaws(cell).check(cell); }), "");
  // A grain that is eight times as large bears half the pressure of its kind.
  cell.species[0] = 1;
  cell.radius[0] = 8 * 300e-6;
  EXPECT_NE(refusal([&] { CellLaws(cell).check(cell); }), "");
  cell.materials[1].limiting_pressure = 50e6;
  EXPECT_EQ(refusal([&] { CellLaws(cell).check(cell); }), "");
}
} // namespace
} // namespace tamp::dem
