// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <tests/dem/sample_cells.h>

#include <gtest/gtest.h>

#include <cmath>

namespace tamp::dem
{
namespace
{
TEST(Placeholder, None) {}
} // namespace
} // namespace tamp::dem
