// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/trial_file.h>
#include <apps/output/growing_file.h>

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tamp::apps
{
namespace
{
constexpr std::size_t points = 3;

fem::Deformation deformation(double value)
{
  fem::Deformation result;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      result.relative_F[i][j] = value + 3 * i + j;
  return result;
}

PointAnswer answer(double value)
{
  PointAnswer result;
  result.stress.fill(value / 3);
  result.relative_density = 1 / value;
  return result;
}

// A step with trials of one kind each; numbers tell points and trials apart.
PointStep step_of(unsigned number)
{
  PointStep step;
  step.step = number;
  step.stage = number / 2;
  step.accepted = number > 0;
  step.events = {{PointEvent::turn, 1e-3 * number},
                 {PointEvent::attempt},
                 {PointEvent::stress_and_tangent},
                 {PointEvent::stress}};
  return step;
}

std::vector<char> bytes_of_step(unsigned number)
{
  std::vector<char> bytes;
  for (std::size_t point = 0; point < points; ++point) {
    const double value = 100. * number + 10. * static_cast<double>(point);
    const std::array trials{deformation(value), deformation(value + 0.1)};
    append_point(bytes, trials, answer(value + 1));
  }
  return trial_file_step(number, step_of(number), bytes);
}

class TrialFiles : public testing::Test
{
protected:
  void SetUp() override
  {
    GrowingFile out(file_);
    out.append(trial_file_begin({"1.2.3", "set A = 1\n", points, 1}));
    for (unsigned number = 0; number < 4; ++number)
      out.append(bytes_of_step(number));
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      ("tamp_trials_" + std::to_string(getpid()) + ".tamp");
};
} // namespace

TEST_F(TrialFiles, EveryPointGetsItsOwnTrialsBack)
{
  TrialFile trials(file_);
  EXPECT_EQ(trials.title().program, "1.2.3");
  EXPECT_EQ(trials.title().input, "set A = 1\n");
  EXPECT_EQ(trials.title().points, points);
  ASSERT_EQ(trials.steps(), 4u);
  for (unsigned number = 0; number < 4; ++number)
    for (std::size_t point = 0; point < points; ++point) {
      const PointStep step = trials.step(number, point);
      const PointStep wanted = step_of(number);
      EXPECT_EQ(step.step, wanted.step);
      EXPECT_EQ(step.stage, wanted.stage);
      EXPECT_EQ(step.accepted, wanted.accepted);
      ASSERT_EQ(step.events.size(), wanted.events.size());
      for (std::size_t k = 0; k < step.events.size(); ++k) {
        EXPECT_EQ(step.events[k].kind, wanted.events[k].kind);
        EXPECT_EQ(step.events[k].force_floor, wanted.events[k].force_floor);
      }
      ASSERT_EQ(step.trials.size(), 2u);
      const double value = 100. * number + 10. * static_cast<double>(point);
      EXPECT_EQ(step.trials[0].relative_F, deformation(value).relative_F);
      EXPECT_EQ(step.trials[1].relative_F, deformation(value + 0.1).relative_F);
      EXPECT_EQ(step.answer, answer(value + 1));
    }
}

TEST_F(TrialFiles, AStepThatWasWrittenHalfIsPassedOver)
{
  const auto whole = std::filesystem::file_size(file_);
  const auto size = bytes_of_step(3).size();
  for (std::size_t missing = 1; missing < 2 * size; missing += 7) {
    std::filesystem::resize_file(file_, whole - missing);
    EXPECT_EQ(TrialFile(file_).steps(), missing <= size ? 3u : 2u) << missing;
  }
}

TEST_F(TrialFiles, NoFlippedBitGoesUnnoticed)
{
  const auto size = std::filesystem::file_size(file_);
  for (std::uintmax_t place = 0; place < size; ++place) {
    std::fstream change(file_, std::ios::in | std::ios::out | std::ios::binary);
    const auto flip = [&] {
      change.seekg(static_cast<std::streamoff>(place));
      const auto byte = static_cast<char>(change.get() ^ (1 << place % 8));
      change.seekp(static_cast<std::streamoff>(place));
      change.put(byte).flush();
    };
    flip();
    EXPECT_THROW(TrialFile{file_}, coupling::FileError) << place;
    flip();
  }
  EXPECT_NO_THROW(TrialFile{file_});
}

TEST_F(TrialFiles, GoOnAfterTheStepThatTheyAreCutBackTo)
{
  std::uint64_t size = std::filesystem::file_size(file_);
  const auto then = coupling::read_whole_file(file_);
  size -= bytes_of_step(3).size() + bytes_of_step(2).size();
  {
    GrowingFile again(file_, size);
    EXPECT_EQ(again.size(), size);
    again.append(bytes_of_step(2));
    again.append(bytes_of_step(3));
  }
  EXPECT_EQ(coupling::read_whole_file(file_), then);
  EXPECT_THROW(GrowingFile(file_, then.size() + 1), OutputError);
}
} // namespace tamp::apps
