// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/measures.h>
#include <tests/dem/mdr_cells.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <variant>
#include <vector>

// Cells whose grains grow and respond in bulk: the law mdr beyond one pair.
namespace tamp::dem
{
namespace
{
using test::grown_cell;
using test::mdr_cell;
using test::part;
using test::request_for;
using test::take_to;

constexpr double kappa = 5e9 / (3 * (1 - 2 * 0.3)); // of the solid [Pa]

/// A side of a contact: a grain and the flat that presses it.
struct Flat {
  std::size_t grain;
  double open, distance, force; ///< 1 less the obstruction; [m], [N]
  MdrSide<double> side;
  MdrMemory<double> memory;
};

/// All flats whose contacts overlap.
std::vector<Flat> flats_of(const UnitCell &cell)
{
  const CellLaws laws(cell);
  const Mdr &law = std::get<Mdr>(laws.of_kind(0).normal);
  std::vector<Flat> flats;
  for (std::size_t c = 0; c < cell.contacts.size(); ++c) {
    const ContactMemory &contact = cell.contacts[c];
    const auto [i, j] = contact.pair;
    const auto shape = cell.shape(contact.pair);
    const double overlap =
        shape.radius_sum -
        cell.box.nearest_image(cell.place[j] - cell.place[i]).norm();
    if (overlap <= 0)
      continue;
    std::array<double, Mdr::more> more;
    std::copy_n(cell.more_memory.data() + c * laws.more(), Mdr::more, &more[0]);
    NormalMemory<double> memory = {contact.largest_overlap, 0, more.data()};
    const auto sides = law.sides(overlap, shape, memory);
    const double force = law(overlap, shape, memory).force;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t grain = k == 0 ? i : j;
      flats.push_back(
          {grain,
           1 - more[Mdr::more - 1],
           cell.radius[grain] - sides[k].overlap,
           force,
           sides[k],
           MdrMemory<double>::read(&more[k * MdrMemory<double>::size])});
    }
  }
  return flats;
}

double ball(double radius)
{
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

/// d p / d ln D over kappa, as the bulk response has it: all flats of a grain
/// of volume V move by h de, de = d ln D / 3, at distances h; each then pushes
/// with kappa sum(A) / V A more for this, and the pressure is sum(N h) / (3
/// V_cell). As d A / A = d h / delta the areas add twice delta_B / delta, and
/// shorter branches in a smaller volume 2/3 p.
double expected_slope(const UnitCell &cell, double pressure)
{
  std::vector<double> moment(cell.size()), in_bulk(cell.size()),
      overlap(cell.size());
  for (const Flat &flat : flats_of(cell)) {
    const double area = flat.open * flat.side.area;
    moment[flat.grain] += area * flat.distance;
    in_bulk[flat.grain] += area * flat.side.bulk_overlap;
    overlap[flat.grain] += area * flat.side.overlap;
  }
  double slope = 2.0 / 3 * pressure / kappa;
  for (std::size_t g = 0; g < cell.size(); ++g)
    if (overlap[g] > 0)
      slope += moment[g] * moment[g] /
               (9 * ball(cell.initial_radius_of(g)) * cell.box.volume()) *
               (1 + 2 * in_bulk[g] / overlap[g]);
  return slope;
}

TEST(MdrCell, LocksUpWherePairLawsDoNot)
{
  UnitCell grown = mdr_cell();
  UnitCell plain = make_packing(request_for(NormalLaw::thornton_ning));
  // Up to the onset the two laws are of one kind.
  const double early = take_to(grown, 0.75) / take_to(plain, 0.75);
  EXPECT_GT(early, 0.5);
  EXPECT_LT(early, 2);
  const double late = take_to(grown, 1.0) / take_to(plain, 1.0);
  EXPECT_GT(late, 3 * early);
}

TEST(MdrCell, BulkModulusFollowsTheAreasOfContactTowardsThatOfTheSolid)
{
  // Contacts are not at the onset all at once, and move by other ways than the
  // box does.
  constexpr double tolerance = 0.15;
  UnitCell cell = mdr_cell();
  double before = take_to(cell, 0.97), last = 0;
  for (double next : {0.985, 1.0, 1.015}) {
    const double density = cell.relative_density();
    const double first = expected_slope(cell, before);
    const double pressure = take_to(cell, next);
    const double slope = (pressure - before) / std::log(next / density) / kappa;
    const double expected = 0.5 * (first + expected_slope(cell, pressure));
    EXPECT_NEAR(slope / expected, 1, tolerance) << next;
    EXPECT_GT(slope, last);
    EXPECT_LT(slope, 1); // that of contacts without gaps between them
    last = slope;
    before = pressure;
  }
  EXPECT_GT(last, 0.5);
}

TEST(MdrCell, GrowthTakesUpTheVolumeThatContactsDisplace)
{
  // Caps from before yield and of contacts that are being relieved, and the
  // displaced volume of the last increment, are not in the radii.
  constexpr double tolerance = 0.05;
  UnitCell cell = mdr_cell();
  cell.contact.bulk_onset = 0; // beyond it there is nowhere to grow to
  take_to(cell, 0.88);
  double displaced = 0, elastic = 0, grown = 0;
  for (const Flat &flat : flats_of(cell)) {
    const double R = cell.radius[flat.grain], height = R - flat.distance;
    displaced += flat.open * std::numbers::pi / 3 * height * height *
                 (2 * R + flat.distance);
    elastic += flat.force * flat.distance / (3 * kappa);
  }
  for (std::size_t g = 0; g < cell.size(); ++g)
    grown += ball(cell.radius[g]) - ball(cell.initial_radius_of(g));
  EXPECT_GT(displaced, 0.05 * cell.solid_volume());
  EXPECT_NEAR((grown + elastic) / displaced, 1, tolerance);
}

/// A column of grains of two sizes in turn, which touch: large ones of 0.55 and
/// small ones of 0.5 mm, without friction.
UnitCell column()
{
  constexpr std::size_t grains = 24;
  constexpr double large = 0.55e-3, small = 0.5e-3;
  UnitCell cell;
  cell.materials[0] = request_for(NormalLaw::mdr).material;
  cell.contact = request_for(NormalLaw::mdr).contact;
  cell.contact.tangential_law = TangentialLaw::none;
  cell.box.h = Vector3(5e-3, 5e-3, grains * (large + small)).asDiagonal();
  for (std::size_t g = 0; g < grains; ++g) {
    cell.radius.push_back(g % 2 == 0 ? large : small);
    cell.place.emplace_back(0.5, 0.5, (double(g) + 0.5) / grains);
  }
  cell.reference_volume = cell.box.volume();
  return cell;
}

TEST(MdrCell, GrainsOfUnequalSizeMayBePressedFlat)
{
  // To a quarter of the distance of their centres, past where the spheres
  // intersect behind the centre of the smaller one. By symmetry nothing moves
  // but with the cell.
  UnitCell cell = column();
  const Stretch stretch = Vector3(1, 1, std::exp(-1e-2)).asDiagonal();
  double behind = 1;
  while (cell.box.h(2, 2) > 0.25 * column().box.h(2, 2)) {
    const CellAnswer answer = deform(cell, stretch, {});
    ASSERT_EQ(answer.outcome, Outcome::settled) << cell.box.h(2, 2);
    ASSERT_LT(answer.stress(2, 2), 0) << cell.box.h(2, 2);
    const double way = cell.box.h(2, 2) / double(cell.size());
    const double large = cell.radius[0], small = cell.radius[1];
    behind = (way * way + small * small - large * large) / (2 * way * small);
  }
  EXPECT_LT(behind, 1 - SphereOnFlat::overlap_limit);
}

TEST(MdrCell, HasNoBulkPartAboveTheOnset)
{
  UnitCell with = mdr_cell(), without = mdr_cell();
  without.contact.bulk_onset = 0;
  EXPECT_EQ(take_to(with, 0.75), take_to(without, 0.75));
  for (const Flat &flat : flats_of(with)) {
    EXPECT_EQ(flat.memory.bulk_stiffness, 0);
    EXPECT_EQ(flat.side.bulk_overlap, 0);
  }
  const UnitCell early = without;
  without.contact = with.contact;
  EXPECT_EQ(with, without);
  without = early;
  EXPECT_GT(take_to(with, 0.95), 1.2 * take_to(without, 0.95));
}

TEST(MdrCell, SmallElasticStrainsAreThoseOfHertz)
{
  // MDR departs from Hertz by a term of the order of the overlap over R, here
  // 1e-3; the packings are two, each at rest within the usual unbalance.
  constexpr double tolerance = 0.01;
  PackingRequest request = request_for(NormalLaw::hertz);
  request.material.limiting_pressure = 2e9; // never reached
  request.goal.pressure = 1e6;
  UnitCell hertz = make_packing(request), grown = hertz;
  grown.contact.normal_law = NormalLaw::mdr;
  grown.contacts.clear();
  grown.more_memory.clear();
  hertz.contacts.clear();
  deform(grown, Matrix3::Identity(), {});
  deform(hertz, Matrix3::Identity(), {});
  const Stretch stretch = test::uniaxial(-2e-3);
  const CellAnswer one = deform(grown, stretch, {});
  const CellAnswer two = deform(hertz, stretch, {});
  EXPECT_LT((one.stress - two.stress).norm(), tolerance * two.stress.norm());
  EXPECT_TRUE(grown.initial_radius.empty()); // none yields, none grows
}

TEST(MdrCell, CyclesGainNoEnergy)
{
  UnitCell cell = mdr_cell();
  const double low = 0.94, high = 0.98;
  take_to(cell, high);
  take_to(cell, low); // the first relief lets the contacts settle
  take_to(cell, high);
  const auto lost = [&] {
    return cell.energy.plastic_dissipation + cell.energy.friction_dissipation;
  };
  for (int cycle = 0; cycle < 2; ++cycle) {
    const double work = cell.energy.work, heat = lost();
    take_to(cell, low);
    const double back = work - cell.energy.work;
    take_to(cell, high);
    EXPECT_GT(back, 0);
    EXPECT_GE(cell.energy.work, work);
    EXPECT_LT(cell.energy.work - work, 0.1 * back); // nearly elastic, too
    EXPECT_GE(lost(), heat);
  }
}

TEST(MdrCell, FullReliefKeepsTheGrainsGrownAndGivesLessBack)
{
  UnitCell cell = grown_cell();
  const std::vector<double> radius = cell.radius;
  const double work = cell.energy.work;
  EXPECT_EQ(take_to(cell, 0.8), 0);
  EXPECT_LT(work - cell.energy.work, 0.3 * work);
  EXPECT_GT(work - cell.energy.work, 0);
  for (std::size_t g = 0; g < cell.size(); ++g)
    EXPECT_GE(cell.radius[g], radius[g]);
}

TEST(MdrCell, HeatOfPlasticFlowNeverFallsInLoading)
{
  UnitCell cell = mdr_cell();
  double last = 0;
  while (cell.relative_density() < 1) {
    deform(cell, std::exp(-part) * Matrix3::Identity(), {});
    // Of the work so far; trapezoids, and what is left of forces.
    EXPECT_GE(cell.energy.plastic_dissipation, last - 1e-4 * cell.energy.work);
    last = cell.energy.plastic_dissipation;
  }
  EXPECT_GT(last, 0.3 * cell.energy.work);
}

TEST(MdrCell, DynamicsAgreesWithTheMap)
{
  // Grains grow at other times, and what is left of the rate.
  constexpr double tolerance = 0.03;
  Driving slow;
  slow.method = Method::dynamics;
  slow.dynamics.strain_rate = 1e-4;
  UnitCell one = grown_cell(), two = grown_cell();
  const double reference = take_to(two, 0.94, slow);
  EXPECT_NEAR(take_to(one, 0.94) / reference, 1, tolerance);
  EXPECT_NEAR(
      measure(one).coordination_number, measure(two).coordination_number, 0.1);
  const EnergyAccount &energy = two.energy;
  EXPECT_GT(energy.plastic_dissipation, 0.3 * energy.work);
  EXPECT_LT(energy.plastic_dissipation + measure(two).elastic_energy,
            1.001 * energy.work);
}
} // namespace
} // namespace tamp::dem
