// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_stored_run_h
#define apps_run_stored_run_h

#include <apps/run/run_session.h>
#include <fem/ranks.h>

#include <vector>

namespace tamp::apps
{
/// What a checkpoint has of a run and of its model (the walk of a probe), on
/// every rank; empty if the run does not go on from one.
struct StoredRun {
  std::vector<char> run, model;

  StoredRun(RunSession &session, const fem::Ranks &ranks)
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
