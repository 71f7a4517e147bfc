// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_instruction_set_h
#define dem_kernel_instruction_set_h

#include <string>
#include <vector>

namespace tamp::dem
{
struct Kernel;

/// What the sweep is compiled for.
enum class InstructionSet { scalar, neon, avx2, avx512 };

std::string name_of(InstructionSet set);

/// The sets that this program has and this machine can run, the fastest last.
/// Never empty.
std::vector<InstructionSet> instruction_sets();

/// The fastest of instruction_sets().
InstructionSet best_instruction_set();

/// The kernel of one of instruction_sets().
const Kernel &kernel_of(InstructionSet set);

// One function per set, each in its own file with its own compiler flags.
const Kernel &kernel_scalar();
const Kernel &kernel_neon();
const Kernel &kernel_avx2();
const Kernel &kernel_avx512();
} // namespace tamp::dem

#endif
