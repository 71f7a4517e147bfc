// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_work_account_h
#define fem_work_account_h

#include <fem/tool_contact.h>

#include <span>

namespace tamp::fem
{
class Compact;

/// Work of the tools on the powder, and where it went [J]. Forces and stresses
/// are taken as linear over a step. What is left between the three is what
/// nodes did that were not in balance, and of second order in the step.
struct WorkAccount {
  double tools = 0;  ///< done by the tools
  double powder = 0; ///< done by the stress of the powder on its strain
  /// By the powder against its tools: friction, and at the rim the forces that
  /// fade.
  double lost = 0;

  WorkAccount &operator+=(const WorkAccount &other);
  /// What powder and friction have not taken of the tools' work, over it [-].
  double residual() const;
};

/// Where nodes and tools stand, and how they push.
struct PushedPlaces {
  const NodePositions &nodes;
  const ToolPositions &tools;
  std::span<const PairForce> forces;
};

/// The work of an increment, that of the compact's trial, of the whole compact.
/// Collective.
WorkAccount increment_work(const Compact &compact,
                           const ToolContact &contact,
                           const PushedPlaces &from,
                           const PushedPlaces &to);
} // namespace tamp::fem

#endif
