// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/trial_file.h>
#include <apps/run/run_resume.h>
#include <dem/six.h>
#include <fem/state_bytes.h>

#include <algorithm>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
// The number is that of the format: what the frames are.
const std::string first_line = "tamp trials, format 1";

// Runs what reads the file, and names it if that fails.
template <class Read>
auto naming(const std::filesystem::path &file, const Read &read)
{
  try {
    return read();
  } catch (const std::invalid_argument &error) {
    throw coupling::FileError(
        fmt::format("cannot read '{}': {}", file.string(), error.what()));
  }
}

struct StepHead {
  std::uint32_t step = 0, stage = 0, accepted = 0, unused = 0;
};
} // namespace

PointAnswer answer_of(const fem::Response &response)
{
  PointAnswer answer;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = dem::six_places[k];
    answer.stress[k] = response.stress[i][j];
  }
  answer.relative_density = response.relative_density;
  return answer;
}

std::string input_in(const std::filesystem::path &folder)
{
  const auto text = coupling::read_whole_file(folder / "input.prm");
  return effective_input({text.begin(), text.end()});
}

std::vector<char> trial_file_begin(const TrialTitle &title)
{
  std::vector<char> bytes, frame;
  fem::append_state(bytes, title.program);
  fem::append_state(bytes, title.input);
  fem::append_state(bytes, title.points);
  fem::append_state(bytes, title.points_per_cell);
  frame = coupling::framed(0, bytes);
  const std::string line = first_line + "\n";
  frame.insert(frame.begin(), line.begin(), line.end());
  return frame;
}

std::vector<char> trial_file_step(std::uint64_t number,
                                  const PointStep &head,
                                  std::span<const char> points)
{
  std::vector<char> bytes;
  fem::append_state(bytes, StepHead{head.step, head.stage, head.accepted});
  fem::append_state(bytes, head.events);
  bytes.insert(bytes.end(), points.begin(), points.end());
  return coupling::framed(number + 1, bytes);
}

void append_point(std::vector<char> &bytes,
                  std::span<const fem::Deformation> trials,
                  const PointAnswer &answer)
{
  for (const fem::Deformation &trial : trials)
    fem::append_state(bytes, trial);
  fem::append_state(bytes, answer);
}

TrialFile::TrialFile(const std::filesystem::path &file)
    : file_(file), frames_(naming(file, [&] {
        return coupling::FramedFileReader(
            file, first_line, coupling::FramesEnd::anywhere);
      }))
{
  const std::vector<char> bytes = frame(0);
  fem::StateBytes in(bytes);
  in.take(title_.program);
  in.take(title_.input);
  in.take(title_.points);
  in.take(title_.points_per_cell);
}

std::vector<char> TrialFile::frame(std::size_t number)
{
  return naming(file_, [&] { return frames_.frame(number); });
}

PointStep TrialFile::step(std::size_t number, std::size_t point)
{
  const std::vector<char> bytes = frame(number + 1);
  fem::StateBytes in(bytes);
  StepHead head;
  PointStep step;
  in.take(head);
  in.take(step.events);
  step.step = head.step;
  step.stage = head.stage;
  step.accepted = head.accepted != 0;
  step.trials.resize(static_cast<std::size_t>(
      std::ranges::count_if(step.events, &PointEvent::is_trial)));
  const std::size_t size =
      step.trials.size() * sizeof(fem::Deformation) + sizeof(PointAnswer);
  if (in.rest().size() != size * title_.points)
    throw coupling::FileError(
        fmt::format("cannot read '{}': step {} is not of {} points",
                    file_.string(),
                    step.step,
                    title_.points));
  fem::StateBytes own(in.rest().subspan(point * size, size));
  for (fem::Deformation &trial : step.trials)
    own.take(trial);
  own.take(step.answer);
  return step;
}
} // namespace tamp::apps
