// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/quasi_static.h>
#include <dem/relattice.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/LU>

#include <cmath>
#include <gtest/gtest.h>

namespace tamp::dem
{
namespace
{
Matrix3 sheared(double xy, double xz, double yz)
{
  Matrix3 F = Matrix3::Identity();
  F(0, 1) = xy;
  F(0, 2) = xz;
  F(1, 2) = yz;
  return F;
}

TEST(Relattice, ReductionKeepsTheLatticeAndItsHand)
{
  for (const Matrix3 &h :
       {sheared(2.3, -1.7, 0.8), sheared(0.6, 0.6, -0.6), sheared(-11, 7, 5)}) {
    const Matrix3 U = reduction(h);
    EXPECT_EQ(U, Matrix3(U.array().round()));
    EXPECT_NEAR(U.determinant(), 1, 1e-9); // integers in doubles
    EXPECT_FALSE(is_oblique(h * U));
    EXPECT_EQ(reduction(h * U), Matrix3(Matrix3::Identity()));
  }
}

TEST(Relattice, ASkewCubeIsACubeAgain)
{
  const Matrix3 h = sheared(3, -2, 5); // integers: the lattice of the cube
  const Matrix3 edges = h * reduction(h);
  EXPECT_EQ(edges.cwiseAbs().colwise().sum().maxCoeff(), 1);
  EXPECT_NEAR(PeriodicBox{edges}.smallest_width(), 1, 1e-12); // round-off
}

TEST(Relattice, ABoxThatIsStraightStays)
{
  UnitCell cell = test::alumina_cell();
  const UnitCell before = cell;
  EXPECT_FALSE(relattice(cell));
  EXPECT_EQ(cell, before);
}

/// The alumina cell with a lattice described by long edges.
UnitCell skew_cell()
{
  UnitCell cell = test::alumina_cell();
  // Long edges of the same lattice, but not so long that nearest images fail.
  const Matrix3 U = sheared(1, 0, 0), inverse = U.inverse();
  cell.box.h *= U;
  for (Vector3 &place : cell.place)
    place = (inverse * place).eval();
  cell.neighbours = {};
  return cell;
}

TEST(Relattice, NothingPhysicalChanges)
{
  const UnitCell skew = skew_cell();
  UnitCell straight = skew;
  ASSERT_TRUE(relattice(straight));
  EXPECT_GT(straight.box.smallest_width(), 1.3 * skew.box.smallest_width());
  EXPECT_EQ(straight.contacts, skew.contacts);

  const CellMeasures a = measure(skew), b = measure(straight);
  // Overlaps of 1e-2 R are differences of places known to 1e-15 R.
  constexpr double round_off = 1e-12;
  EXPECT_LT((a.stress - b.stress).norm(), round_off * a.stress.norm());
  EXPECT_LT((a.fabric - b.fabric).norm(), round_off);
  EXPECT_NEAR(a.elastic_energy, b.elastic_energy, round_off * a.elastic_energy);
  EXPECT_EQ(a.contacts, b.contacts);
}

TEST(Relattice, NextAnswerIsTheSame)
{
  const Stretch stretch = test::uniaxial(-2e-3);
  UnitCell skew = skew_cell(), straight = skew;
  ASSERT_TRUE(relattice(straight));
  const CellAnswer a = deform_quasi_static(skew, stretch, {}, {}, nullptr);
  const CellAnswer b = deform_quasi_static(straight, stretch, {}, {}, nullptr);
  EXPECT_EQ(a.evaluations, b.evaluations);
  // Round-off, grown over some hundred steps of the relaxation.
  EXPECT_LT((a.stress - b.stress).norm(), 1e-10 * a.stress.norm());
}

/// Simple shear of a cell in its own, co-rotating frame.
class SimpleShear
{
public:
  /// The next increment of shear, with the box described anew where it is
  /// oblique, or not. Returns the stress in the frame of the shear.
  Matrix3 go(UnitCell &cell, double increment, bool anew)
  {
    Matrix3 F = Matrix3::Identity();
    F(0, 1) = increment;
    const Stretch U = exponential(0.5 * logarithm(F.transpose() * F));
    const Matrix3 R = F * U.inverse();
    const Stretch own = frame_.transpose() * U * frame_;
    const Stretch stretch = 0.5 * (own + own.transpose());
    const CellAnswer answer =
        anew ? deform(cell, stretch, {})
             : deform_quasi_static(cell, stretch, {}, {}, nullptr);
    EXPECT_NE(answer.outcome, Outcome::diverged);
    frame_ = (R * frame_).eval();
    return frame_ * answer.stress * frame_.transpose();
  }

private:
  Matrix3 frame_ = Matrix3::Identity();
};

TEST(Relattice, SimpleShearGoesOnAsIfNothingHadHappened)
{
  // Above jamming without friction: sheared at constant volume it keeps its
  // stress.
  UnitCell anew = test::smooth_elastic_cell();
  for (int k = 0; k < 4; ++k)
    deform(anew, std::exp(-5e-3) * Stretch::Identity(), {});
  UnitCell same = anew;
  SimpleShear path_anew, path_same;
  constexpr double increment = 1e-2;
  Matrix3 last = measure(anew).stress;
  double jump_before = 0, jump_after = 0;
  bool exchanged = false;
  for (int k = 1; k <= 100; ++k) {
    const Matrix3 lattice = anew.box.h;
    const Matrix3 stress = path_anew.go(anew, increment, true);
    exchanged =
        exchanged || (anew.box.h - lattice).norm() > .1 * lattice.norm();
    if (k * increment <= 0.6) {
      const Matrix3 plain = path_same.go(same, increment, false);
      // Equal but for round-off, which grows with every rearrangement.
      EXPECT_LT((stress - plain).norm(), 1e-3 * plain.norm()) << k;
    }
    double &jump = exchanged ? jump_after : jump_before;
    jump = std::max(jump, (stress - last).norm());
    last = stress;
  }
  EXPECT_TRUE(exchanged);
  EXPECT_FALSE(is_oblique(anew.box.h));
  // Rearrangements make the stress jump; the exchange adds nothing to that.
  EXPECT_LT(jump_after, 2 * jump_before);
}
} // namespace
} // namespace tamp::dem
