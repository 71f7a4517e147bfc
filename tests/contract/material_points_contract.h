// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_contract_material_points_contract_h
#define tests_contract_material_points_contract_h

#include <fem/material_points.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <vector>

/// The contract that every MaterialPoints keeps: see fem/material_points.h. To
/// put a material under it, specialise ContractTraits for a tag type and
/// instantiate the suite:
///
///   struct MyMaterial {};
///   template <> struct ContractTraits<MyMaterial> : ContractDefaults {...};
///   INSTANTIATE_TYPED_TEST_SUITE_P(My, MaterialPointsContract, MyMaterial);
namespace tamp::fem::contract
{
/// What a tangent promises.
enum class Tangent {
  consistent, ///< the derivative of the stress
  upper_bound ///< positive definite, not softer than the secant
};

/// What a trait may leave as it is.
struct ContractDefaults {
  /// Largest |Q sigma Q^T - sigma(Q F)| over |sigma| [-]: rounding.
  static double rotation_tolerance() { return 1e-12; }
  /// Largest change of stress when nothing moves, over |sigma| [-].
  static double identity_tolerance() { return 1e-9; }
  /// What the tangent promises, and its largest relative error [-].
  static Tangent tangent() { return Tangent::consistent; }
  static double tangent_tolerance() { return 1e-6; }
  /// How much stiffer than the secant an upper bound may be [-].
  static double most_stiff() { return 1; }
  /// Strain of the differences the tangent is compared with [-].
  static double probe_strain() { return 1e-6; }
  /// Largest relative error of the density against det F [-]: rounding.
  static double density_tolerance() { return 1e-12; }
  /// An increment far too large; any status may come back, but it must come.
  static dealii::Tensor<2, 3> wild()
  {
    dealii::Tensor<2, 3> F;
    F[0][0] = 0.5;
    F[1][1] = 1.4;
    F[2][2] = 0.6;
    F[0][2] = 0.3;
    return F;
  }
};

/// To be specialised, derived from ContractDefaults, with
///   - static std::unique_ptr<MaterialPoints> make(): three points or more that
///     carry no load yet, equal to each other,
///   - static std::vector<dealii::Tensor<2, 3>> path(): relative F of
///     increments that lead into the plastic range if there is one,
///   - static dealii::Tensor<2, 3> next(): the relative F of the increment
///     that is looked at after the path. It should not be symmetric.
template <class Tag>
struct ContractTraits;

template <class Tag>
class MaterialPointsContract : public testing::Test
{
protected:
  using Traits = ContractTraits<Tag>;
  using Gradient = dealii::Tensor<2, 3>;
  using Stress = dealii::SymmetricTensor<2, 3>;

  /// Fresh points at the end of the path.
  std::unique_ptr<MaterialPoints> loaded() const
  {
    auto points = Traits::make();
    for (const Gradient &F : Traits::path()) {
      const auto answer = evaluate(*points, F);
      EXPECT_NE(answer.status, Status::failed);
      points->commit();
    }
    return points;
  }

  static Gradient identity()
  {
    return Gradient(dealii::unit_symmetric_tensor<3>());
  }

  /// The answer of point 0 if all points go the same way, cold.
  static Response evaluate(MaterialPoints &points,
                           const Gradient &F,
                           const Want want = Want::stress)
  {
    points.begin_attempt();
    const std::vector<Deformation> deformations(points.size(), {F});
    std::vector<Response> responses(points.size());
    points.evaluate(deformations, want, responses);
    return responses[0];
  }

  static bool same_bits(const Stress &a, const Stress &b)
  {
    for (unsigned i = 0; i < 6; ++i)
      if (std::memcmp(&a.access_raw_entry(i),
                      &b.access_raw_entry(i),
                      sizeof(double)) != 0)
        return false;
    return true;
  }

  static Gradient rotation()
  {
    const double a = 0.7, b = -1.1;
    Gradient x = identity(), z = identity();
    x[1][1] = x[2][2] = std::cos(a);
    x[2][1] = -(x[1][2] = -std::sin(a));
    z[0][0] = z[1][1] = std::cos(b);
    z[1][0] = -(z[0][1] = -std::sin(b));
    return x * z;
  }

  /// The strain (e_i e_j + e_j e_i) / 2.
  static Gradient unit_strain(const unsigned i, const unsigned j)
  {
    Gradient strain;
    strain[i][j] += 0.5;
    strain[j][i] += 0.5;
    return strain;
  }
};

TYPED_TEST_SUITE_P(MaterialPointsContract);

TYPED_TEST_P(MaterialPointsContract, EvaluatingTwiceEqualsOnce)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded();
  const auto once =
      this->evaluate(*points, Traits::next(), Want::stress_and_tangent);
  const auto twice =
      this->evaluate(*points, Traits::next(), Want::stress_and_tangent);
  EXPECT_TRUE(this->same_bits(once.stress, twice.stress));
  EXPECT_EQ((once.tangent - twice.tangent).norm(), 0.);
  EXPECT_EQ(once.relative_density, twice.relative_density);
  EXPECT_EQ(once.status, twice.status);
}

TYPED_TEST_P(MaterialPointsContract, EqualPointsAnswerEqually)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded();
  ASSERT_GE(points->size(), 3u);
  const std::vector<Deformation> deformations(points->size(), {Traits::next()});
  std::vector<Response> responses(points->size());
  points->begin_attempt();
  points->evaluate(deformations, Want::stress, responses);
  for (const Response &response : responses)
    EXPECT_TRUE(this->same_bits(response.stress, responses[0].stress));
}

TYPED_TEST_P(MaterialPointsContract, UncommittedTrialLeavesNoTrace)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded(), spoilt = this->loaded();
  std::vector<char> before, after;
  spoilt->pack(0, before);
  (void)this->evaluate(*spoilt, invert(Traits::next()));
  (void)this->evaluate(*spoilt, Traits::wild(), Want::stress_and_tangent);
  auto inside_out = this->identity();
  inside_out[1][1] = -1;
  (void)this->evaluate(*spoilt, inside_out, Want::stress_and_tangent);
  spoilt->pack(0, after);
  EXPECT_EQ(before, after);

  const auto clean = this->evaluate(*points, Traits::next());
  const auto after_failure = this->evaluate(*spoilt, Traits::next());
  EXPECT_TRUE(this->same_bits(clean.stress, after_failure.stress));
  EXPECT_EQ(clean.status, after_failure.status);
}

TYPED_TEST_P(MaterialPointsContract, ImpossibleIncrementFails)
{
  auto points = this->loaded();
  auto inside_out = this->identity();
  inside_out[1][1] = -1;
  EXPECT_EQ(this->evaluate(*points, inside_out).status, Status::failed);
  auto not_a_number = this->identity();
  not_a_number[0][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(this->evaluate(*points, not_a_number).status, Status::failed);
}

TYPED_TEST_P(MaterialPointsContract, CommittedStressStaysIfNothingMoves)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded();
  const auto moved = this->evaluate(*points, Traits::next());
  ASSERT_NE(moved.status, Status::failed);
  points->commit();
  const auto still = this->evaluate(*points, this->identity());
  EXPECT_LE((still.stress - moved.stress).norm(),
            Traits::identity_tolerance() * moved.stress.norm());
  EXPECT_NEAR(still.relative_density,
              moved.relative_density,
              Traits::density_tolerance());
}

TYPED_TEST_P(MaterialPointsContract, PackThenUnpackIsTheIdentity)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded(), other = Traits::make();
  std::vector<char> bytes{'x'}, again;
  points->pack(1, bytes); // appends
  bytes.erase(bytes.begin());
  for (std::size_t i = 0; i < other->size(); ++i)
    other->unpack(i, bytes);
  other->pack(1, again);
  EXPECT_EQ(bytes, again);

  const auto here =
      this->evaluate(*points, Traits::next(), Want::stress_and_tangent);
  const auto there =
      this->evaluate(*other, Traits::next(), Want::stress_and_tangent);
  EXPECT_TRUE(this->same_bits(here.stress, there.stress));
  EXPECT_EQ((here.tangent - there.tangent).norm(), 0.);
  EXPECT_EQ(here.relative_density, there.relative_density);
}

TYPED_TEST_P(MaterialPointsContract, UnpackedStateIsNotOverwrittenByOldTrial)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded();
  std::vector<char> bytes, after;
  points->pack(0, bytes);
  (void)this->evaluate(*points, Traits::next());
  for (std::size_t i = 0; i < points->size(); ++i)
    points->unpack(i, bytes);
  points->commit();
  points->pack(0, after);
  EXPECT_EQ(bytes, after);
}

TYPED_TEST_P(MaterialPointsContract, GarbageIsRefusedAndChangesNothing)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded();
  std::vector<char> good, after;
  points->pack(0, good);
  std::vector<std::vector<char>> garbage{
      {}, {'t'}, std::vector<char>(good.size(), 'x'), good, good};
  garbage[3].pop_back();
  garbage[4].push_back('x');
  for (const std::vector<char> &bytes : garbage)
    EXPECT_THROW(points->unpack(0, bytes), std::runtime_error);
  points->pack(0, after);
  EXPECT_EQ(good, after);
  auto fresh = this->loaded();
  EXPECT_TRUE(this->same_bits(this->evaluate(*points, Traits::next()).stress,
                              this->evaluate(*fresh, Traits::next()).stress));
}

TYPED_TEST_P(MaterialPointsContract, RotationTurnsTheStress)
{
  using Traits = ContractTraits<TypeParam>;
  const auto Q = this->rotation();
  auto points = this->loaded(), turned = this->loaded();
  const auto plain = this->evaluate(*points, Traits::next());
  const auto answer = this->evaluate(*turned, Q * Traits::next());
  const double tolerance = Traits::rotation_tolerance() * plain.stress.norm();
  const auto expected = [&Q](const auto &stress) {
    return symmetrize(Q * dealii::Tensor<2, 3>(stress) * transpose(Q));
  };
  EXPECT_LE((answer.stress - expected(plain.stress)).norm(), tolerance);

  // The committed state turns as well: the next step is Q F Q^T there.
  points->commit();
  turned->commit();
  const auto next = this->evaluate(*points, Traits::next());
  const auto next_turned =
      this->evaluate(*turned, Q * Traits::next() * transpose(Q));
  EXPECT_LE((next_turned.stress - expected(next.stress)).norm(),
            10 * Traits::rotation_tolerance() * next.stress.norm());
}

TYPED_TEST_P(MaterialPointsContract, TangentDescribesTheStress)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = this->loaded();
  const auto F = Traits::next();
  const auto answer = this->evaluate(*points, F, Want::stress_and_tangent);
  const double size = answer.tangent.norm();
  ASSERT_TRUE(std::isfinite(size));
  ASSERT_GT(size, 0);
  if (Traits::tangent() == Tangent::consistent) {
    const double h = Traits::probe_strain();
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j < 3; ++j) {
        const auto strain = this->unit_strain(i, j);
        const auto ahead =
            this->evaluate(*points, (this->identity() + h * strain) * F);
        const auto back =
            this->evaluate(*points, (this->identity() - h * strain) * F);
        const auto slope = (ahead.stress - back.stress) / (2 * h);
        EXPECT_LE((answer.tangent * symmetrize(strain) - slope).norm(),
                  Traits::tangent_tolerance() * size)
            << "strain " << i << j;
      }
    return;
  }
  // Stiffer than what is measured along the increment, and positive.
  const auto rest = this->evaluate(*points, this->identity());
  const auto strain = symmetrize(F - this->identity());
  EXPECT_GE(strain * (answer.tangent * strain),
            (1 - Traits::tangent_tolerance()) *
                (strain * (answer.stress - rest.stress)));
  EXPECT_LE(strain * (answer.tangent * strain),
            Traits::most_stiff() * (strain * (answer.stress - rest.stress)));
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j) {
      const auto unit = symmetrize(this->unit_strain(i, j));
      EXPECT_GT(unit * (answer.tangent * unit), 0) << "strain " << i << j;
    }
}

TYPED_TEST_P(MaterialPointsContract, VariablesAreThoseOfTheCommittedState)
{
  using Traits = ContractTraits<TypeParam>;
  const auto points = this->loaded();
  const std::size_t count = points->variables().size();
  const auto variables = [count](const MaterialPoints &of, std::size_t point) {
    std::vector<double> values(count, std::nan(""));
    of.variables_of(point, values);
    return values;
  };
  const std::vector<double> before = variables(*points, 0);
  for (const double value : before)
    EXPECT_TRUE(std::isfinite(value));
  this->evaluate(*points, Traits::next());
  EXPECT_EQ(variables(*points, 0), before);
  // They belong to the state, so they travel with it.
  std::vector<char> bytes;
  points->pack(0, bytes);
  const auto fresh = Traits::make();
  fresh->unpack(1, bytes);
  EXPECT_EQ(variables(*fresh, 1), before);
}

TYPED_TEST_P(MaterialPointsContract, DensityFollowsTheVolume)
{
  using Traits = ContractTraits<TypeParam>;
  auto points = Traits::make();
  const double start =
      this->evaluate(*points, this->identity()).relative_density;
  double volume = 1;
  for (const auto &F : Traits::path()) {
    volume *= determinant(F);
    const auto answer = this->evaluate(*points, F);
    EXPECT_NEAR(answer.relative_density * volume / start,
                1,
                Traits::density_tolerance());
    points->commit();
  }
}

REGISTER_TYPED_TEST_SUITE_P(MaterialPointsContract,
                            EvaluatingTwiceEqualsOnce,
                            EqualPointsAnswerEqually,
                            UncommittedTrialLeavesNoTrace,
                            ImpossibleIncrementFails,
                            CommittedStressStaysIfNothingMoves,
                            PackThenUnpackIsTheIdentity,
                            UnpackedStateIsNotOverwrittenByOldTrial,
                            GarbageIsRefusedAndChangesNothing,
                            RotationTurnsTheStress,
                            TangentDescribesTheStress,
                            VariablesAreThoseOfTheCommittedState,
                            DensityFollowsTheVolume);
} // namespace tamp::fem::contract

#endif
