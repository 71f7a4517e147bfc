// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/random_numbers.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::dem
{
namespace
{
/// Directions all over the sphere, evenly on a spiral.
std::vector<Vector3> directions(int count)
{
  std::vector<Vector3> result;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z);
    result.emplace_back(r * std::cos(turn * k), r * std::sin(turn * k), z);
  }
  return result;
}

Matrix3 traceless(double xx, double yy, double xy, double yz)
{
  Matrix3 result;
  result << xx, xy, 0, xy, yy, yz, 0, yz, -xx - yy;
  return result;
}

/// Contacts whose forces follow the second-order forms of Anisotropies.
std::vector<ContactForce> contacts_of(const std::vector<Vector3> &normals,
                                      const Anisotropies &wanted)
{
  std::vector<ContactForce> result;
  for (const Vector3 &n : normals) {
    ContactForce c;
    c.branch = 2e-4 * n;
    c.normal_force = 3 * (1 + n.dot(wanted.normal * n));
    const Vector3 along = wanted.tangential * n;
    c.tangential_force = -3 * (along - along.dot(n) * n);
    result.push_back(c);
  }
  return result;
}

TEST(Anisotropies, OfForcesAreThoseTheyWereMadeWith)
{
  // The spiral of 4000 points integrates polynomials of 4th order to 1e-3.
  constexpr double quadrature = 1e-3;
  const Anisotropies wanted{Matrix3::Zero(),
                            traceless(.3, -.1, .05, .1),
                            traceless(-.1, .2, .1, -.05)};
  const Anisotropies found =
      anisotropies(contacts_of(directions(4000), wanted));
  EXPECT_LT(found.contacts.norm(), quadrature);
  EXPECT_LT((found.normal - wanted.normal).norm(), quadrature);
  EXPECT_LT((found.tangential - wanted.tangential).norm(), quadrature);
}

TEST(Anisotropies, OfForcesDoNotDependOnThoseOfContacts)
{
  // Contacts drawn at random: components scatter by 7.5 sqrt(4/45 / 20000),
  // about 0.016; four times that.
  constexpr double scatter = 0.064;
  const Anisotropies wanted{traceless(-.4, .5, .1, 0),
                            traceless(.3, -.1, .05, .1),
                            traceless(-.1, .2, .1, -.05)};
  RandomNumbers random(1);
  std::vector<Vector3> drawn;
  for (const Vector3 &n : directions(40000))
    if (2 * random.next() < 1 + n.dot(wanted.contacts * n))
      drawn.push_back(n);
  const Anisotropies found = anisotropies(contacts_of(drawn, wanted));
  EXPECT_LT((found.contacts - wanted.contacts).cwiseAbs().maxCoeff(), scatter);
  EXPECT_LT((found.normal - wanted.normal).cwiseAbs().maxCoeff(), scatter);
  EXPECT_LT((found.tangential - wanted.tangential).cwiseAbs().maxCoeff(),
            scatter);
}

TEST(Anisotropies, OfNoContactsVanish)
{
  EXPECT_EQ(anisotropies({}).contacts.norm(), 0);
  EXPECT_EQ(anisotropies({}).normal.norm(), 0);
}

TEST(Anisotropies, MakeUpTheStressOfACompressedPacking)
{
  // Rothenburg & Bathurst's sum is of first order, for grains of one size:
  // here anisotropies reach 0.6, and sizes spread by a fifth.
  constexpr double first_order = 0.1;
  UnitCell cell = test::alumina_cell();
  ASSERT_EQ(test::compress(cell, -0.02, 10, {}).outcome, Outcome::settled);
  const CellMeasures found = measure(cell);
  const double pressure = -found.stress.trace() / 3;
  const Matrix3 shear =
      -found.stress / pressure - Matrix3::Identity(); // compression positive
  const Anisotropies &a = found.anisotropy;
  const Matrix3 sum = 0.4 * (a.contacts + a.normal + 1.5 * a.tangential);
  EXPECT_GT(shear(1, 1), 0.2); // pressed along y
  EXPECT_LT((sum - shear).norm(), first_order * shear.norm());
  // Forces carry it, not the number of contacts.
  EXPECT_GT(a.normal(1, 1), 0.1);
  EXPECT_GT(a.tangential(1, 1), 0.05);
  EXPECT_LT(a.contacts.norm(), 0.5 * a.normal.norm());
}

/// Contacts between the pairs, whatever the cell.
std::vector<ContactForce> touching(const std::vector<Pair> &pairs)
{
  std::vector<ContactForce> result;
  for (const Pair &pair : pairs) {
    ContactForce c;
    c.pair = pair;
    result.push_back(c);
  }
  return result;
}

TEST(Backbone, LosesADanglingChainGrainByGrain)
{
  // A ring 0-1-2, a chain 2-3-4, and grain 5 alone.
  UnitCell cell;
  cell.radius.assign(6, 1);
  const auto contacts = touching({{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}});
  const Backbone found = find_backbone(cell, contacts);
  EXPECT_EQ(found.rattlers, 3u);
  EXPECT_EQ(found.contacts, 3u);
  EXPECT_EQ(found.coordination_number, 2);
}

TEST(Backbone, OfSmoothGrainsNeedsFourContacts)
{
  // Five grains that all touch, and a sixth that touches three of them.
  std::vector<Pair> pairs;
  for (std::uint32_t j = 1; j < 5; ++j)
    for (std::uint32_t i = 0; i < j; ++i)
      pairs.push_back({i, j});
  for (std::uint32_t i = 0; i < 3; ++i)
    pairs.push_back({i, 5});
  UnitCell cell;
  cell.radius.assign(6, 1);
  EXPECT_EQ(find_backbone(cell, touching(pairs)).rattlers, 0u);
  cell.contact.tangential_law = TangentialLaw::none;
  EXPECT_EQ(find_backbone(cell, touching(pairs)).rattlers, 1u);
  EXPECT_EQ(find_backbone(cell, touching(pairs)).contacts, 10u);
  pairs.pop_back();
  pairs.erase(pairs.begin()); // grains 0 and 1 part: the whole falls
  EXPECT_EQ(find_backbone(cell, touching(pairs)).rattlers, 6u);
  EXPECT_EQ(find_backbone(cell, touching(pairs)).coordination_number, 0);
}

TEST(Measures, MeanNormalForceOfALatticeGivesItsPressure)
{
  // p = C <N> d / (3 V) without friction.
  constexpr double round_off = 1e-12, ratio = 1e-3;
  ContactModel smooth;
  smooth.tangential_law = TangentialLaw::none;
  const UnitCell cell = test::fcc_cell(ratio, smooth);
  const CellMeasures found = measure(cell);
  const double distance = 2 * cell.radius[0] / (1 + ratio);
  const double pressure = double(found.contacts) * found.mean_normal_force *
                          distance / (3 * cell.box.volume());
  EXPECT_NEAR(-found.stress.trace() / 3, pressure, round_off * pressure);
  EXPECT_EQ(found.backbone.coordination_number, 12);
  EXPECT_LT(found.anisotropy.contacts.norm(), 1e-10);
  EXPECT_LT(found.anisotropy.normal.norm(), 1e-10);
}

TEST(Measures, RattlersOfAPackingAreFew)
{
  const CellMeasures found = measure(test::alumina_cell());
  EXPECT_GT(found.rattlers, 0u);
  EXPECT_LT(found.rattlers, 20u);                   // a tenth
  EXPECT_GT(found.backbone.coordination_number, 4); // isostatic with friction
  EXPECT_GT(found.backbone.coordination_number, found.coordination_number);
}
} // namespace
} // namespace tamp::dem
