// SPDX-License-Identifier: BSD-3-Clause
#include <fem/compact.h>
#include <fem/work_account.h>

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
namespace
{
bool is_open(const PairForce &pair)
{
  return pair.status == ContactStatus::open;
}

/// Of the way of a tool that a node meets or leaves in an increment, the part
/// that they go together: a force acts along this only.
double part_together(double tool, double node)
{
  return std::clamp(node, std::min(0., tool), std::max(0., tool));
}
} // namespace

WorkAccount &WorkAccount::operator+=(const WorkAccount &other)
{
  tools += other.tools;
  powder += other.powder;
  lost += other.lost;
  return *this;
}

double WorkAccount::residual() const
{
  return tools != 0 ? std::abs((tools - powder - lost) / tools) : 0;
}

WorkAccount increment_work(const Compact &compact,
                           const ToolContact &contact,
                           const PushedPlaces &from,
                           const PushedPlaces &to)
{
  WorkAccount work;
  for (std::size_t i = 0; i < contact.pairs().size(); ++i) {
    const ContactPair &pair = contact.pairs()[i];
    const auto force = 0.5 * (from.forces[i].force + to.forces[i].force);
    const auto node = to.nodes[pair.node] - from.nodes[pair.node];
    double tool = to.tools[pair.tool] - from.tools[pair.tool];
    if (is_open(from.forces[i]) || is_open(to.forces[i]))
      tool = part_together(tool, node[2]);
    work.tools += force[2] * tool;
    work.lost += force[2] * tool - force * node;
  }
  const double whole = compact.mesh().multiplicity();
  return {whole * work.tools, whole * compact.trial_work(), whole * work.lost};
}
} // namespace tamp::fem
