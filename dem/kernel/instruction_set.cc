// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/instruction_set.h>

#include <cassert>
#include <cstdlib>
#include <hwy/targets.h>

namespace tamp::dem
{
namespace
{
struct Choice {
  InstructionSet set;
  std::int64_t target; // as the machine names it
  const Kernel &(*kernel)();
};

// What this program was compiled with, the fastest last.
constexpr Choice choices[] = {
    {InstructionSet::scalar, 0, kernel_scalar},
#if defined(TAMP_KERNEL_NEON)
    {InstructionSet::neon, HWY_NEON, kernel_neon},
#endif
#if defined(TAMP_KERNEL_X86)
    {InstructionSet::avx2, HWY_AVX2, kernel_avx2},
    {InstructionSet::avx512, HWY_AVX3, kernel_avx512},
#endif
};
} // namespace

std::string name_of(InstructionSet set)
{
  switch (set) {
  case InstructionSet::scalar:
    return "scalar";
  case InstructionSet::neon:
    return "neon";
  case InstructionSet::avx2:
    return "avx2";
  default:
    return "avx512";
  }
}

std::vector<InstructionSet> instruction_sets()
{
  std::vector<InstructionSet> result;
  for (const Choice &choice : choices)
    if (choice.target == 0 || (hwy::SupportedTargets() & choice.target) != 0)
      result.push_back(choice.set);
  return result;
}

InstructionSet best_instruction_set()
{
  static const InstructionSet best = instruction_sets().back();
  return best;
}

const Kernel &kernel_of(InstructionSet set)
{
  for (const Choice &choice : choices)
    if (choice.set == set)
      return choice.kernel();
  assert(!"an instruction set that instruction_sets() does not give");
  std::abort();
}
} // namespace tamp::dem
