// SPDX-License-Identifier: BSD-3-Clause
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
} // namespace
} // namespace tamp::dem
