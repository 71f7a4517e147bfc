// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/all_loops.h>
#include <dem/kernel/instruction_set.h>

namespace tamp::dem
{
const Kernel &kernel_scalar()
{
  return HWY_NAMESPACE::kernel;
}
} // namespace tamp::dem
