// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/build_facts.h>
#include <apps/run/checkpoints.h>
#include <apps/run/interrupt.h>
#include <coupling/checkpoint.h>

#include <fmt/format.h>
#include <utility>

namespace tamp::apps
{
namespace
{
using Seconds = std::chrono::duration<double>;
}

Checkpoints::Checkpoints(RunSession &session, const fem::Ranks &ranks)
    : session_(session), ranks_(ranks)
{
  if (session.found())
    last_step_ = session.found()->title.step;
}

bool Checkpoints::due()
{
  const double interval = session_.input().output.checkpoint_interval;
  const bool over = interval > 0 && session_.place().first() &&
                    Seconds(Clock::now() - last_).count() >= interval;
  const int signals = checkpoint_signals();
  const bool asked = std::exchange(signals_, signals) != signals;
  return ranks_.largest(asked || over ? 1 : 0) > 0;
}

void Checkpoints::write(unsigned step,
                        std::span<const char> state,
                        const fem::MaterialPoints &points)
{
  // The first rank knows; one that is there is not written again.
  const bool there = session_.place().first() && last_step_ == step;
  if (ranks_.largest(there ? 1 : 0) > 0)
    return;
  const Clock::time_point start = Clock::now();
  try {
    const auto folder = session_.folder().path() / "checkpoint";
    const auto bytes = static_cast<double>(coupling::write_checkpoint(
        folder,
        {build_facts().version, session_.told(), step},
        state,
        points,
        ranks_));
    const double seconds = Seconds(Clock::now() - start).count();
    session_.log().detail(
        fmt::format("checkpoint of step {}: {:.4g} MB, {:.3g} s, {:.3g} MB/s",
                    step,
                    bytes / 1e6,
                    seconds,
                    bytes / 1e6 / seconds));
    last_step_ = step;
  } catch (const coupling::FileError &error) {
    session_.warn(fmt::format(
        "no checkpoint of step {}: {}; the run goes on", step, error.what()));
  }
  last_ = Clock::now();
}
} // namespace tamp::apps
