// SPDX-License-Identifier: BSD-3-Clause
#include <apps/plots.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

using namespace tamp::apps;

TEST(Plots, TransmissionShowsAllStagesThatPress)
{
  const auto plots = die_plots({2, 4});
  const auto plot = std::ranges::find(plots, "transmission", &Plot::name);
  ASSERT_NE(plot, plots.end());
  for (const char *stage : {"1", "2", "3", "4"})
    EXPECT_EQ(plot->script.find(std::string("column(\"stage\") == ") + stage) !=
                  std::string::npos,
              *stage == '2' || *stage == '4')
        << stage;
}
