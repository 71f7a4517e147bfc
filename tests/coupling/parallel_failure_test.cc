// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/unit_cell_points.h>
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/shared_points.h>
#include <tests/coupling/sample_cells.h>

#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tamp::coupling
{
namespace
{
constexpr std::size_t count = 16;
constexpr unsigned always = std::numeric_limits<unsigned>::max();

/// Evaluations in which the last cell of all is crushed, counted from 1.
struct Fault {
  unsigned first = 0, last = 0;
  bool is_at(unsigned evaluation) const
  {
    return first <= evaluation && evaluation <= last;
  }
};

/// Cells of a rank. The last cell of all fails at times, on the rank that has
/// it.
class FaultyCells final : public fem::MovablePoints
{
public:
  FaultyCells(std::vector<dem::UnitCell> cells,
              const CellPointsOptions &options,
              const Fault &fault)
      : cells_(std::move(cells), options), fault_(fault)
  {
  }
  std::size_t size() const override { return cells_.size(); }
  void begin_attempt() override { cells_.begin_attempt(); }
  void evaluate(std::span<const fem::Deformation> deformations,
                fem::Want want,
                std::span<fem::Response> responses) override
  {
    std::vector<fem::Deformation> told(deformations.begin(),
                                       deformations.end());
    if (fault_.is_at(++evaluation_) && share().holds(count - 1))
      told[count - 1 - share().begin].relative_F[2][2] = 0.05;
    cells_.evaluate(told, want, responses);
  }
  void commit() override { cells_.commit(); }
  void pack(std::size_t point, std::vector<char> &bytes) const override
  {
    cells_.pack(point, bytes);
  }
  void unpack(std::size_t point, std::span<const char> bytes) override
  {
    cells_.unpack(point, bytes);
  }
  double cost(std::size_t point) const override { return cells_.cost(point); }
  fem::Share share() const override { return cells_.share(); }
  void hold(const fem::Share &share) override { cells_.hold(share); }

private:
  UnitCellPoints cells_;
  Fault fault_;
  unsigned evaluation_ = 0;
};

/// What a few steps of a die left.
struct DieEnd {
  std::vector<char> cells;
  std::vector<double> forces;
  unsigned cuts = 0;
  bool failed = false;
  std::size_t point = 0; ///< of the failure
  std::string reason;
  bool operator==(const DieEnd &) const = default;
};

DieEnd press(const fem::Ranks &ranks, const Fault &fault)
{
  fem::DieSettings settings;
  settings.geometry.radial_elements = 1;
  settings.geometry.axial_elements = 4;
  settings.solver.displacement_tolerance = 1e-2;
  settings.stages = {fem::Stage{}};
  const fem::Mesh mesh = fem::build_mesh(settings.geometry);
  const fem::Share own = ranks.share(count);
  CellPointsOptions options;
  options.first_point = own.begin;
  fem::SharedPoints cells(std::make_unique<FaultyCells>(
                              test::same_cells(own.size()), options, fault),
                          count,
                          ranks);
  fem::DieModel die(settings, mesh, cells);
  DieEnd end;
  while (end.forces.size() < 6 && !end.failed) {
    end.failed = die.advance() == fem::Advance::failed;
    end.forces.push_back(die.last_step().upper_force);
    end.cuts += die.last_step().cuts;
  }
  end.point = die.failure().point;
  end.reason = die.failure().reason;
  for (std::size_t i = 0; i < count; ++i)
    cells.pack(i, end.cells);
  return end;
}
} // namespace

TEST(AFailedCell, FailsTheAttemptOnAllRanksWhichGoOnAsOne)
{
  // It is the last rank's; all cut the step and go on as one rank does.
  const Fault second_update{3, 3}; // the first is that of the start
  const DieEnd shared = press(fem::Ranks(MPI_COMM_WORLD), second_update);
  const DieEnd alone = press(fem::Ranks(), second_update);
  EXPECT_EQ(shared.cuts, 1u);
  EXPECT_FALSE(shared.failed);
  EXPECT_TRUE(shared == alone);
}

TEST(AFailedCell, ThatFailsInEveryAttemptEndsTheRunOnAllRanks)
{
  const Fault later_on{30, always}; // after some steps
  const DieEnd shared = press(fem::Ranks(MPI_COMM_WORLD), later_on);
  const DieEnd alone = press(fem::Ranks(), later_on);
  EXPECT_TRUE(shared.failed);
  EXPECT_GT(shared.forces.size(), 1u); // some steps went well
  EXPECT_EQ(shared.point, count - 1);
  EXPECT_TRUE(shared == alone) << shared.reason;
}
} // namespace tamp::coupling
