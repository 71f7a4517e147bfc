// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/trial_recorder.h>
#include <apps/run/build_facts.h>
#include <fem/state_bytes.h>

#include <algorithm>
#include <fmt/format.h>

namespace tamp::apps
{
TrialRecorder::TrialRecorder(RunSession &session,
                             const fem::Mesh &mesh,
                             RecordedPoints &points)
    : session_(session), mesh_(mesh), points_(points)
{
}

template <class Deed>
void TrialRecorder::attempt(const Deed &deed)
{
  try {
    deed();
  } catch (const OutputError &error) {
    file_ = nullptr;
    session_.warn(fmt::format(
        "{}; the run goes on, tamp inspect will not have its further steps",
        error.what()));
  }
}

void TrialRecorder::begin()
{
  if (!points_.are_cells() || !session_.place().first())
    return;
  attempt([&] {
    file_ = std::make_unique<GrowingFile>(session_.folder().path() / name);
    file_->append(trial_file_begin({build_facts().version,
                                    input_in(session_.folder().path()),
                                    mesh_.number_of_points(),
                                    mesh_.points_per_cell()}));
  });
}

void TrialRecorder::go_on(fem::StateBytes &stored)
{
  // What points are told before they have their states is no part of the run.
  points_.forget();
  std::uint64_t size = 0;
  stored.take(size);
  stored.take(steps_);
  if (size > 0 && session_.place().first())
    attempt([&] {
      file_ =
          std::make_unique<GrowingFile>(session_.folder().path() / name, size);
    });
}

void TrialRecorder::pack(std::vector<char> &bytes) const
{
  if (file_)
    file_->sync();
  fem::append_state(bytes, file_ ? file_->size() : std::uint64_t(0));
  fem::append_state(bytes, steps_);
}

void TrialRecorder::write(unsigned step, unsigned stage, bool accepted)
{
  PointStep head;
  head.step = step;
  head.stage = stage;
  head.accepted = accepted;
  head.events = points_.events();
  if (std::ranges::none_of(head.events, &PointEvent::is_trial))
    return;
  std::vector<char> all;
  if (file_)
    points_.append_points(all);
  points_.forget();
  if (file_)
    attempt([&] { file_->append(trial_file_step(steps_++, head, all)); });
}
} // namespace tamp::apps
