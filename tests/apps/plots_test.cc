// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_plots.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

using namespace tamp::apps;
using namespace tamp::fem;

namespace
{
const Plot *find(const std::vector<Plot> &plots, const std::string &name)
{
  const auto plot = std::ranges::find(plots, name, &Plot::name);
  return plot == plots.end() ? nullptr : &*plot;
}

/// A run that presses, unloads, presses, unloads and ejects.
DieSettings settings()
{
  DieSettings settings;
  settings.stages = {{StageKind::press},
                     {StageKind::unload},
                     {StageKind::press},
                     {StageKind::unload},
                     {StageKind::eject, StageTarget::out}};
  return settings;
}

StepRecord record(unsigned stage, double progress)
{
  StepRecord record;
  record.stage = stage;
  record.stage_progress = progress;
  record.compact_height = 5e-3;
  record.compact_radius = 6e-3;
  return record;
}
} // namespace

TEST(Plots, TransmissionShowsAllStagesThatPress)
{
  const auto plots =
      die_plots(plot_facts(settings(), record(2, 1), record(4, 1)));
  const Plot *plot = find(plots, "transmission");
  ASSERT_NE(plot, nullptr);
  for (const char *stage : {"1", "2", "3", "4", "5"})
    EXPECT_EQ(plot->script.find(std::string("column(\"stage\") == ") + stage) !=
                  std::string::npos,
              *stage == '1' || *stage == '3')
        << stage;
}

TEST(Plots, OnlyWhatThereIsToSeeIsDrawn)
{
  const auto pressed =
      die_plots(plot_facts(settings(), record(0, 1), record(0, 1)));
  for (const char *name : {"compaction", "pressures", "forces", "density_map"})
    EXPECT_NE(find(pressed, name), nullptr) << name;
  const char *later[] = {"ejection",
                         "spring_back",
                         "density_map_final",
                         "axial_stress_final",
                         "hoop_stress_final"};
  for (const char *name : later)
    EXPECT_EQ(find(pressed, name), nullptr) << name;
  DiePlotFacts facts = plot_facts(settings(), record(2, 1), record(4, 1));
  for (const char *name : later)
    EXPECT_NE(find(die_plots(facts), name), nullptr) << name;
  facts.maps = false;
  EXPECT_EQ(find(die_plots(facts), "density_map"), nullptr);
  EXPECT_EQ(find(die_plots(facts), "hoop_stress_final"), nullptr);
}

TEST(Plots, MapsSayTheStateThatTheyShow)
{
  const auto title = [](unsigned stage, double progress) {
    const auto plots = die_plots(
        plot_facts(settings(), record(2, 1), record(stage, progress)));
    return find(plots, "density_map_final")->script;
  };
  EXPECT_NE(title(3, 1).find("after unloading"), std::string::npos);
  EXPECT_NE(title(4, 0.5).find("during ejection"), std::string::npos);
  EXPECT_NE(title(4, 1).find("after ejection"), std::string::npos);
}

TEST(Plots, LaterStagesAreThoseAfterThePeak)
{
  const DiePlotFacts facts = plot_facts(settings(), record(0, 1), record(4, 1));
  EXPECT_EQ(facts.later_stages, (std::vector<unsigned>{2, 3, 4, 5}));
  EXPECT_EQ(facts.press_stages, (std::vector<unsigned>{1, 3}));
  EXPECT_EQ(facts.peak_height, 5e-3);
}
