// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/work_sharing.h>

#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace tamp::coupling
{
namespace
{
std::vector<std::size_t> first_numbers(std::size_t count)
{
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  return order;
}

TEST(WorkSharing, EveryItemIsDoneOnce)
{
  for (unsigned threads : {0u, 1u, 3u, 200u}) {
    std::vector<int> done(100, 0);
    share_work(first_numbers(100), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(100, 1)) << threads << " threads";
  }
}

TEST(WorkSharing, FirstErrorInOrderIsThrownAfterAllWork)
{
  std::vector<int> done(50, 0);
  try {
    share_work(first_numbers(50), 3, [&](std::size_t i) {
      ++done[i];
      if (i % 20 == 7)
        throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "no error";
  } catch (const std::runtime_error &error) {
    EXPECT_STREQ(error.what(), "7");
  }
  EXPECT_EQ(done, std::vector<int>(50, 1));
}
} // namespace
} // namespace tamp::coupling
