// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/bias_sampling.h>
#include <coupling/checkpoint.h>
#include <coupling/shared_cells.h>
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <tests/coupling/sample_cells.h>

#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace tamp::coupling
{
namespace
{
constexpr std::size_t count = 16;

/// Few grains, pressed well together: loose ones collapse. Made once.
const std::vector<dem::UnitCell> &packings()
{
  static const std::vector<dem::UnitCell> cells = [] {
    dem::PackingRequest request = test::granules(64);
    request.goal.pressure = 2e6;
    return test::first_packings(request, count);
  }();
  return cells;
}

/// The same on any number of ranks.
SharedCells share_cells(const fem::Ranks &ranks,
                        std::size_t number = count,
                        bool same = false)
{
  const fem::Share own = ranks.share(number);
  CellPointsOptions options;
  options.first_point = own.begin;
  std::vector<dem::UnitCell> cells;
  for (std::size_t i = own.begin; i < own.end; ++i)
    cells.push_back(packings()[same ? 0 : i]);
  return {std::make_unique<UnitCellPoints>(std::move(cells), options),
          number,
          ranks};
}

/// The first half of the points is pressed, each a little more than the one
/// before; all others stay as they are.
std::vector<fem::Deformation> uneven(std::size_t number = count)
{
  std::vector<fem::Deformation> all(number);
  for (std::size_t i = 0; i < number; ++i) {
    for (unsigned axis = 0; axis < 3; ++axis)
      all[i].relative_F[axis][axis] = 1;
    if (i < number / 2)
      all[i].relative_F[2][2] -= 4e-3 + 1e-5 * double(i);
  }
  return all;
}

std::vector<char> bytes_of(const fem::MaterialPoints &points)
{
  std::vector<char> bytes;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.pack(i, bytes);
  return bytes;
}

struct DieEnd {
  std::vector<char> bytes;
  std::vector<double> forces;
  std::uint64_t evaluations = 0;
  fem::Advance end = fem::Advance::stepped;
  bool operator==(const DieEnd &) const = default;
};

/// A die whose cells are shared out and whose elements are not.
DieEnd press(const fem::Ranks &ranks)
{
  fem::DieSettings settings;
  settings.geometry.radial_elements = 1;
  settings.geometry.axial_elements = 4;
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
  fem::Stage press;
  press.target = fem::StageTarget::density;
  press.value = 0.69;
  settings.stages = {press};
  settings.solver.displacement_tolerance = 1e-2;
  const fem::Mesh mesh = fem::build_mesh(settings.geometry);
  SharedCells cells = share_cells(ranks);
  fem::DieModel die(
      settings, mesh, cells, [&](unsigned, double) { cells.turn(); });
  DieEnd result;
  while ((result.end = die.advance()) == fem::Advance::stepped) {
    result.forces.push_back(die.last_step().upper_force);
    result.forces.push_back(die.last_step().wall_friction_force);
    result.evaluations += cells.report().evaluations;
  }
  result.bytes = bytes_of(cells);
  return result;
}

const fem::Ranks ranks_of_all()
{
  return fem::Ranks(MPI_COMM_WORLD);
}
} // namespace

TEST(ParallelCells, ADieIsThatOfOneRankToTheBit)
{
  const DieEnd alone = press(fem::Ranks()), shared = press(ranks_of_all());
  EXPECT_EQ(alone.end, fem::Advance::finished);
  EXPECT_GT(alone.forces.size(), 20u); // two a step
  EXPECT_TRUE(shared == alone);
}

TEST(ParallelCells, TellHowManyDifferWhereverTheyAre)
{
  const fem::Ranks ranks = ranks_of_all();
  EXPECT_EQ(share_cells(ranks).different_cells(), count);
  constexpr std::size_t many = 32;
  SharedCells cells = share_cells(ranks, many, true);
  EXPECT_EQ(cells.different_cells(), 1u);
  std::vector<fem::Response> answers(many);
  cells.evaluate(uneven(many), fem::Want::stress, answers);
  EXPECT_EQ(cells.different_cells(), 1u);
  cells.commit();
  // Half of them were pressed, each in its own way.
  EXPECT_EQ(cells.different_cells(), many / 2 + 1);
}

TEST(ParallelCells, MoveToBalanceAnUnevenLoadAndStayTheSameToTheBit)
{
  constexpr std::size_t many = 64;
  const fem::Ranks ranks = ranks_of_all();
  SharedCells shared = share_cells(ranks, many, true),
              alone = share_cells(fem::Ranks(), many, true);
  std::vector<fem::Response> answers(many), wanted(many);
  double first_idle = 0, idle = 0;
  for (unsigned step = 0; step < 4; ++step) {
    shared.evaluate(uneven(many), fem::Want::stress_and_tangent, answers);
    alone.evaluate(uneven(many), fem::Want::stress_and_tangent, wanted);
    for (std::size_t i = 0; i < many; ++i) {
      ASSERT_EQ(answers[i].stress, wanted[i].stress);
      ASSERT_EQ(answers[i].tangent, wanted[i].tangent);
      ASSERT_EQ(answers[i].relative_density, wanted[i].relative_density);
    }
    std::vector<double> loads(ranks.size(), 0.);
    for (std::size_t i = shared.share().begin; i < shared.share().end; ++i)
      loads[ranks.rank()] += shared.cost(i);
    ranks.sum(loads);
    const double now = fem::idle_share(loads);
    (step == 0 ? first_idle : idle) = now;
    shared.commit();
    alone.commit();
    ASSERT_EQ(bytes_of(shared), bytes_of(alone)) << "step " << step;
  }
  if (ranks.size() == 2) {
    EXPECT_GT(first_idle, 0.4);
    EXPECT_LT(idle, 0.1);
  }
  EXPECT_EQ(shared.loads().moved > 0, ranks.size() > 1);
  EXPECT_EQ(alone.loads().moved, 0u);
}

TEST(ParallelCells, AreReportedAsByOneRank)
{
  SharedCells shared = share_cells(ranks_of_all()),
              alone = share_cells(fem::Ranks());
  std::vector<fem::Response> answers(count);
  auto deformations = uneven();
  for (const std::size_t crushed : {count - 1, count - 3})
    deformations[crushed].relative_F[2][2] = 0.05;
  shared.evaluate(deformations, fem::Want::stress, answers);
  EXPECT_EQ(answers[count - 3].status, fem::Status::failed);
  EXPECT_EQ(answers[0].status, fem::Status::converged);
  alone.evaluate(deformations, fem::Want::stress, answers);
  const CellReport report = shared.report(), wanted = alone.report();
  EXPECT_EQ(report.evaluations, wanted.evaluations);
  EXPECT_EQ(report.points, count);
  EXPECT_EQ(report.worst_unbalance, wanted.worst_unbalance);
  EXPECT_EQ(report.worst_unbalance_point, wanted.worst_unbalance_point);
  EXPECT_EQ(report.worst_hill_mandel, wanted.worst_hill_mandel);
  EXPECT_EQ(report.worst_asymmetry, wanted.worst_asymmetry);
  EXPECT_EQ(report.unsettled, wanted.unsettled);
  EXPECT_EQ(report.problem, wanted.problem);
  EXPECT_EQ(report.problem.find("material point 13: "), 0u) << report.problem;
}

TEST(ParallelCells, AreJudgedAndCopiedAsByOneRank)
{
  const SharedCells shared = share_cells(ranks_of_all()),
                    alone = share_cells(fem::Ranks());
  const std::vector<double> pressures(count, 0.5e6);
  const auto found = shared.judge({}, pressures),
             wanted = alone.judge({}, pressures);
  ASSERT_EQ(found.size(), wanted.size());
  ASSERT_FALSE(found.empty()); // few grains make narrow cells
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].point, wanted[i].point);
    EXPECT_EQ(found[i].remarks, wanted[i].remarks);
  }
  for (const std::size_t point : {std::size_t(0), count - 1}) {
    const TurnedCell copy = shared.cell(point), same = alone.cell(point);
    EXPECT_EQ(copy.cell, same.cell);
    EXPECT_EQ(copy.rotation, same.rotation);
  }
}

TEST(ParallelCells, AreDrivenMoreFinelyAsByOneRank)
{
  SharedCells shared = share_cells(ranks_of_all()),
              alone = share_cells(fem::Ranks());
  const auto deformations = uneven();
  std::vector<CellIncrement> increments;
  for (const std::size_t point : {count - 1, std::size_t(0), std::size_t(6)})
    increments.push_back({point, deformations[point], {}});
  const auto found = answer_finely(shared, increments, {}, 1),
             wanted = answer_finely(alone, increments, {}, 2);
  ASSERT_EQ(found.size(), increments.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_TRUE(found[i].settled);
    EXPECT_EQ(found[i].stress, wanted[i].stress);
    EXPECT_EQ(found[i].evaluations, wanted[i].evaluations);
  }
}

TEST(ParallelCells, AreStoredWhereverTheyAreAndTakenUpAsSharedOutAnew)
{
  const fem::Ranks ranks = ranks_of_all();
  SharedCells shared = share_cells(ranks), fresh = share_cells(ranks);
  std::vector<fem::Response> answers(count);
  shared.evaluate(uneven(), fem::Want::stress, answers);
  shared.commit();
  ASSERT_EQ(shared.loads().moved > 0, ranks.size() > 1);
  const std::vector<char> bytes = bytes_of(shared);
  ASSERT_NE(bytes_of(fresh), bytes);
  // The first rank writes and reads.
  const auto folder = std::filesystem::temp_directory_path() /
                      ("tamp_parallel_cells_" + std::to_string(getpid()));
  write_checkpoint(folder, {"1.2.3", "", 1}, {}, shared.own(), ranks);
  std::optional<FoundCheckpoint> found;
  if (ranks.rank() == 0)
    found = find_checkpoint(folder, "1.2.3");
  unpack_points(found ? &*found : nullptr, fresh.own(), ranks);
  EXPECT_EQ(bytes_of(fresh), bytes);
  std::filesystem::remove_all(folder);
}
} // namespace tamp::coupling
