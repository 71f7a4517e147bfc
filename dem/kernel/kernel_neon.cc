// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/instruction_set.h>
#include <dem/kernel/loops.h>

namespace tamp::dem
{
const Kernel &kernel_neon()
{
  return HWY_NAMESPACE::kernel;
}
} // namespace tamp::dem
