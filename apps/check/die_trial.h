// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_check_die_trial_h
#define apps_check_die_trial_h

#include <apps/input/run_input.h>

#include <cstddef>
#include <string>

namespace tamp::apps
{
/// The first steps of a die with a continuum law, done for a second at most.
struct DieTrial {
  bool own_mesh = true; ///< false: a coarser stand-in, of a cylinder
  std::size_t unknowns = 0, points = 0;
  unsigned steps = 0;
  unsigned updates = 0;      ///< evaluations of all points in these steps
  double seconds = 0;        ///< of these steps, all
  double linear_seconds = 0; ///< of these, in the linear solver
  std::string problem;       ///< why the steps ended early; or empty
};

/// Large meshes are stood in for by a coarser cylinder of the same section,
/// height and material. MPI must be up. Throws what DieModel does.
DieTrial try_die(const RunInput &input);

/// Seconds of a step on `unknowns` and `points` of their number, by how direct
/// and iterative solvers grow.
double seconds_per_step(const DieTrial &trial, const RunInput &input);

/// Whether the run's linear systems are solved iteratively.
bool solves_iteratively(const RunInput &input);
} // namespace tamp::apps

#endif
