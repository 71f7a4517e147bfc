// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/run/rank_work.h>

#include <atomic>
#include <gtest/gtest.h>
#include <vector>

using namespace tamp;
using namespace tamp::apps;

TEST(RankWork, IsBegunInItsOrderAndToldPieceByPiece)
{
  std::vector<std::size_t> begun, told;
  RankWork shared;
  shared.order = {2, 0, 3, 1};
  shared.work = [&](std::size_t piece) {
    begun.push_back(piece); // one thread at a time
    return RunEnd();
  };
  shared.done = [&](std::size_t piece, unsigned rank) {
    EXPECT_EQ(rank, 0u);
    told.push_back(piece);
  };
  EXPECT_EQ(share_among_ranks(fem::Ranks(), shared).size(), 4u);
  EXPECT_EQ(begun, shared.order);
  EXPECT_EQ(told, shared.order);
}

TEST(RankWork, NeverHasMorePiecesAtWorkThanThreads)
{
  constexpr int threads = 2, pieces = 9;
  std::atomic<int> at_work = 0, most = 0, all = 0;
  RankWork shared;
  shared.threads = threads;
  for (std::size_t piece = 0; piece < pieces; ++piece)
    shared.order.push_back(piece);
  shared.work = [&](std::size_t) {
    const int now = ++at_work;
    int before = most;
    while (before < now && !most.compare_exchange_weak(before, now))
      ;
    ++all;
    --at_work;
    return RunEnd();
  };
  shared.done = [](std::size_t, unsigned) {};
  (void)share_among_ranks(fem::Ranks(), shared);
  EXPECT_EQ(all, pieces);
  EXPECT_LE(most, threads);
}

TEST(RankWork, ThatThrowsEndsAsItsExceptionAndSparesTheRest)
{
  RankWork shared;
  shared.order = {0, 1, 2};
  shared.work = [](std::size_t piece) -> RunEnd {
    if (piece == 0)
      throw InputError("too few grains");
    return {piece == 1 ? exit_not_converged : exit_done, ""};
  };
  shared.done = [](std::size_t, unsigned) {};
  const auto ends = share_among_ranks(fem::Ranks(), shared);
  EXPECT_EQ(ends[0].code, exit_input);
  EXPECT_EQ(ends[0].message, "too few grains");
  EXPECT_EQ(ends[1].code, exit_not_converged);
  EXPECT_EQ(ends[2].code, exit_done);
}
