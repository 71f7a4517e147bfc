// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/measures.h>
#include <dem/tangent.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::dem
{
namespace
{
constexpr double sqrt2 = std::numbers::sqrt2;
constexpr double overlap_ratio = 1e-3; // overlap over distance of centres

/// Elastic grains on a face-centred cubic lattice that do not slide.
struct Lattice : testing::Test {
  UnitCell cell = test::fcc_cell(
      overlap_ratio,
      {.normal_law = NormalLaw::hertz, .friction_coefficient = 10});
  PairMaterial material = pair_material(cell.materials[0], cell.materials[0]);
  double radius = cell.radius[0], distance = 2 * radius / (1 + overlap_ratio);
  double overlap = 2 * radius - distance;
  // Of one contact:
  double a = std::sqrt(0.5 * radius * overlap);
  double force = 4.0 / 3 * material.effective_modulus * a * overlap;
  double kn = 2 * material.effective_modulus * a;
  double kt = 8 * material.effective_shear_modulus * a;
};

TEST_F(Lattice, MeasuresAreThoseOfFaceCentredCubic)
{
  constexpr double round_off = 1e-10;
  const CellMeasures found = measure(cell);
  EXPECT_EQ(found.contacts, 6 * cell.size());
  EXPECT_EQ(found.coordination_number, 12);
  EXPECT_EQ(found.mechanical_coordination_number, 12);
  EXPECT_EQ(found.rattlers, 0u);
  EXPECT_EQ(found.plastic_contacts, 0u);
  EXPECT_EQ(found.sliding_contacts, 0u);
  EXPECT_LT((found.fabric - Matrix3::Identity() / 3).norm(), round_off);
  const double pressure = 2 * sqrt2 * force / (distance * distance);
  EXPECT_LT((found.stress + pressure * Matrix3::Identity()).norm(),
            round_off * pressure);
  EXPECT_NEAR(pressure,
              force / (sqrt2 * radius * radius),
              3 * overlap_ratio * pressure); // the same for small overlaps
  const double energy = 6 * double(cell.size()) * 0.4 * force * overlap;
  EXPECT_NEAR(found.elastic_energy, energy, round_off * energy);
  EXPECT_NEAR(found.relative_density,
              std::numbers::pi / (3 * sqrt2) * std::pow(1 + overlap_ratio, 3),
              round_off);
}

TEST_F(Lattice, VoigtStiffnessIsTheClosedForm)
{
  constexpr double round_off = 1e-10;
  const Tangent found = voigt_stiffness(cell);
  const double c11 = sqrt2 * (kn + kt) / distance;
  const double c12 = (kn - kt) / sqrt2 / distance;
  const double c44 = (kn + kt) / sqrt2 / distance;
  Tangent wanted = Tangent::Zero();
  wanted.topLeftCorner<3, 3>().setConstant(c12);
  for (int k = 0; k < 3; ++k) {
    wanted(k, k) = c11;
    wanted(k + 3, k + 3) = 2 * c44; // columns of tensor shear strain
  }
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), round_off * c11);
}

TEST_F(Lattice, SmoothGrainsHaveNoTangentialStiffness)
{
  cell.contact.tangential_law = TangentialLaw::none;
  const double c11 = sqrt2 * kn / distance;
  EXPECT_NEAR(voigt_stiffness(cell)(0, 0), c11, 1e-10 * c11);
}

TEST(VoigtStiffness, OfAPackingIsSymmetricAndPositive)
{
  const Tangent found = voigt_stiffness(test::alumina_cell());
  Tangent energy = found; // strain . energy . strain: shear counts twice
  for (int k = 3; k < 6; ++k)
    energy.row(k) *= 2;
  EXPECT_LT((energy - energy.transpose()).norm(), 1e-12 * energy.norm());
  const Eigen::SelfAdjointEigenSolver<Tangent> eigen(energy);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0);
}

TEST(VoigtStiffness, IsAnUpperBoundOfTheBulkModulus)
{
  // Smooth elastic grains: one slope, whether loading or unloading.
  constexpr double step = 1e-5;
  UnitCell cell = test::smooth_elastic_cell();
  Driving fine;
  fine.quasi_static.unbalance_tolerance = 1e-6;
  fine.quasi_static.maximum_evaluations = 20000;
  const double before =
      deform(cell, Stretch::Identity(), fine).stress.trace() / 3;
  const Tangent bound = voigt_tangent(cell);
  const double after =
      deform(cell, (1 - step) * Stretch::Identity(), fine).stress.trace() / 3;
  const double found = (before - after) / (3 * step);
  const double affine = bound.topLeftCorner<3, 3>().sum() / 9;
  EXPECT_LT(found, affine);
  EXPECT_GT(found, 0.6 * affine); // grains that do not follow cost a fifth
}

TEST(VoigtStiffness, IsThatOfIsotropicContactsInThePacking)
{
  // K = phi Z k_n / (6 pi R) for equal grains and contacts [Kruyt &
  // Rothenburg 1998]; sizes 450-650 um and the spread of contacts cost some
  // per cent.
  const UnitCell &cell = test::alumina_cell();
  const CellMeasures packing = measure(cell);
  const double radius = cell.mean_radius();
  const double kn =
      std::numbers::pi * cell.materials[0].limiting_pressure * radius / 2;
  const double bulk = packing.relative_density * packing.coordination_number *
                      kn / (6 * std::numbers::pi * radius);
  const double found = voigt_stiffness(cell).topLeftCorner<3, 3>().sum() / 9;
  EXPECT_GT(found / bulk, 0.9);
  EXPECT_LT(found / bulk, 3); // contacts that unload are stiffer
}
} // namespace
} // namespace tamp::dem
