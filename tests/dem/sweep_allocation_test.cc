// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/neighbours.h>
#include <dem/stretch.h>
#include <tests/dem/moving_cell.h>
#include <tests/dem/sample_cells.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

// A program of its own: it counts what every operator new hands out.
namespace
{
std::atomic<std::size_t> handed_out = 0;

void *hand_out(std::size_t size, std::size_t alignment)
{
  ++handed_out;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  if (void *memory = std::aligned_alloc(alignment, whole > 0 ? whole : 1))
    return memory;
  throw std::bad_alloc();
}
} // namespace

void *operator new(std::size_t size)
{
  return hand_out(size, alignof(std::max_align_t));
}
void *operator new(std::size_t size, std::align_val_t alignment)
{
  return hand_out(size, std::size_t(alignment));
}
void operator delete(void *memory) noexcept
{
  std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete(void *memory, std::align_val_t) noexcept
{
  std::free(memory);
}
void operator delete(void *memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

namespace tamp::dem
{
namespace
{
/// How often a sweep asks for memory.
template <class T>
std::size_t asked_by_sweep(const UnitCell &cell, InstructionSet set)
{
  test::LaidOut<T> laid_out(cell, set);
  test::SmallMotion motion = test::random_motion(cell.size(), 3, 2e-8, 1e-4);
  motion.affine.time = 1e-7;
  laid_out.move(motion);
  const std::size_t before = handed_out;
  laid_out.layout.sweep(motion.affine, {Memory::frozen, true});
  laid_out.layout.sweep(motion.affine, {Memory::written, true});
  return handed_out - before;
}

TEST(SweepAllocation, CountSeesWhatIsAskedFor)
{
  const std::size_t before = handed_out;
  const std::vector<double> some(100, 1.0);
  const std::vector<GrainRow<double>> aligned(3);
  EXPECT_EQ(handed_out - before, 2u);
}

TEST(SweepAllocation, SweepAsksForNothingWithAnyLaw)
{
  const UnitCell start = test::random_cell(60, 3);
  for (const ContactModel &model : test::every_contact_model()) {
    UnitCell cell = test::with_history(start, model, 2e-8);
    for (bool mixed : {false, true}) {
      if (mixed)
        test::mix_species(cell);
      for (InstructionSet set : instruction_sets()) {
        EXPECT_EQ(asked_by_sweep<double>(cell, set), 0u);
        EXPECT_EQ(asked_by_sweep<float>(cell, set), 0u);
      }
    }
  }
}
/// How often a deformation of a cell asks for memory, and for how many
/// evaluations.
struct Cost {
  std::size_t asked, evaluations;
};

Cost cost_of(const Driving &driving, double log_strain)
{
  UnitCell cell = test::alumina_cell();
  const std::size_t before = handed_out;
  const CellAnswer answer =
      deform(cell, exponential(Matrix3::Identity() * log_strain), driving);
  return {handed_out - before, answer.evaluations};
}

TEST(SweepAllocation, TimeStepsAskForNothing)
{
  constexpr double strain = -1e-7; // pairs are not listed anew
  for (InstructionSet set : instruction_sets())
    for (Precision precision :
         {Precision::double_precision, Precision::mixed}) {
      Driving driving;
      driving.method = Method::dynamics;
      driving.arithmetic = {precision, set};
      driving.dynamics.strain_rate = 1e-7;
      const Cost some = cost_of(driving, strain);
      const Cost more = cost_of(driving, 5 * strain);
      EXPECT_GT(more.evaluations, 4 * some.evaluations);
      EXPECT_EQ(more.asked, some.asked);
    }
}

TEST(SweepAllocation, EvaluationsOfTheMapAskForNothing)
{
  for (InstructionSet set : instruction_sets())
    for (Precision precision :
         {Precision::double_precision, Precision::mixed}) {
      Driving driving;
      driving.arithmetic = {precision, set};
      driving.quasi_static.unbalance_tolerance = 1e-30; // never
      driving.quasi_static.maximum_evaluations = 10;
      const Cost some = cost_of(driving, -1e-4);
      driving.quasi_static.maximum_evaluations = 60;
      const Cost more = cost_of(driving, -1e-4);
      EXPECT_EQ(more.evaluations, some.evaluations + 50);
      EXPECT_EQ(more.asked, some.asked);
    }
}

TEST(SweepAllocation, ListingNearPairsAgainAsksForNothing)
{
  const UnitCell &cell = test::alumina_cell();
  const double gap = 0.06 * cell.mean_radius();
  const Neighbours outer =
      find_neighbours(cell.box, cell.place, cell.radius, 5 * gap);
  std::vector<NearPair> near;
  for (InstructionSet set : instruction_sets()) {
    near.reserve(outer.pairs.size());
    const std::size_t before = handed_out;
    find_near_pairs(outer, cell.box, cell.place, cell.radius, gap, near, set);
    EXPECT_EQ(handed_out - before, 0u);
    EXPECT_GT(near.size(), cell.size());
  }
}

} // namespace
} // namespace tamp::dem
