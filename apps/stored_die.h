// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_stored_die_h
#define apps_stored_die_h

#include <apps/run_session.h>
#include <fem/ranks.h>

#include <vector>

namespace tamp::apps
{
/// What a checkpoint has of a run and of its model, on every rank; empty if the
/// run does not go on from one.
struct StoredDie {
  std::vector<char> run, model;

  StoredDie(RunSession &session, const fem::Ranks &ranks)
  {
    if (!session.resumes())
      return;
    const std::vector<char> bytes =
        coupling::stored_state(session.found(), ranks);
    fem::StateBytes in(bytes);
    in.take(run);
    model.assign(in.rest().begin(), in.rest().end());
  }
};
} // namespace tamp::apps

#endif
