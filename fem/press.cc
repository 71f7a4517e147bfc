// SPDX-License-Identifier: BSD-3-Clause
#include <fem/dot.h>
#include <fem/helpful_length.h>
#include <fem/press.h>
#include <fem/stop_watch.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace tamp::fem
{
namespace
{
double reactions(const std::vector<PairForce> &forces)
{
  double squares = 0;
  for (const PairForce &pair : forces)
    squares += pair.force.norm_square();
  return std::sqrt(squares);
}
} // namespace

Press::Press(const Mesh &mesh,
             const Tools &tools,
             MaterialPoints &points,
             const SolverSettings &settings,
             const Ranks &ranks)
    : compact_(mesh, points, ranks, settings.f_bar), contact_(mesh, tools),
      system_(mesh, compact_.assembler(), settings.linear, ranks),
      stiffness_(compact_.assembler().pattern()),
      least_reaction_(settings.least_reaction)
{
  // The tools hold what stress the powder brings.
  internal_ = compact_.internal_forces();
  contact_.begin(std::vector<double>(mesh.nodes.size(), 0.),
                 mesh.nodes,
                 tools_,
                 node_densities());
  take_reactions();
  contact_.accept(pair_forces_, mesh.nodes);
  forces_ = trial_forces();
}

ToolPositions Press::tools_after(std::span<const double> increment) const
{
  ToolPositions result = tools_;
  for (unsigned tool = 0; tool < number_of_tools; ++tool)
    result[tool] += increment[tool_dof(mesh(), tool)];
  return result;
}

std::vector<double> Press::node_stiffness() const
{
  std::vector<double> result(mesh().nodes.size(), 0.);
  for (int row = 0; row < stiffness_.size(); ++row)
    if (stiffness_.begin[row] < stiffness_.begin[row + 1])
      result[row / mesh().components()] +=
          stiffness_.at(row, row) / mesh().components();
  ranks().sum(result);
  for (double &value : result)
    value = std::abs(value);
  return result;
}

std::vector<double> Press::node_densities() const
{
  const std::size_t nodes = mesh().nodes.size();
  std::vector<double> sums(2 * nodes, 0.);
  const auto &responses = compact_.state().responses;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const PointGeometry &g = compact_.geometry()[i];
    const std::size_t cell =
        (compact_.point_share().begin + i) / mesh().points_per_cell();
    for (unsigned a = 0; a < mesh().nodes_per_cell(); ++a) {
      const unsigned node = mesh().nodes_of_cell(cell)[a];
      sums[node] += g.value[a] * g.volume * responses[i].relative_density;
      sums[nodes + node] += g.value[a] * g.volume;
    }
  }
  ranks().sum(sums);
  for (std::size_t node = 0; node < nodes; ++node)
    sums[node] /= sums[nodes + node];
  sums.resize(nodes);
  return sums;
}

Fault Press::begin(const Motion &motion, Increment &increment)
{
  compact_.begin_attempt();
  motion_ = motion;
  for (unsigned tool = 0; tool < number_of_tools; ++tool)
    loaded_[tool] = motion[tool].loaded;
  for (const Tool tool : {upper_punch, lower_punch, die_wall})
    increment[tool_dof(mesh(), tool)] = motion[tool].displacement;
  increment.back() = 0; // the core has the die's
  free_ = system_.free_unknowns(loaded_);
  for (std::size_t dof = 0; dof < mesh().number_of_dofs(); ++dof)
    if (!free_[dof])
      increment[dof] = 0;
  const Fault fault = move_powder(increment, Want::stress_and_tangent);
  if (!fault.reason.empty())
    return fault;
  assemble_stiffness();
  {
    const StopWatch watch(times_.contact);
    contact_.begin(
        node_stiffness(), compact_.state().positions, tools_, node_densities());
  }
  meet_tools(increment);
  return fault;
}

Fault Press::move(const Increment &increment, Want want)
{
  const Fault fault = move_powder(increment, want);
  if (fault.reason.empty())
    meet_tools(increment);
  return fault;
}

Fault Press::move_powder(const Increment &increment, Want want)
{
  {
    const StopWatch watch(times_.assembly);
    const Fault fault = compact_.deform(increment);
    if (!fault.reason.empty())
      return fault;
  }
  {
    const StopWatch watch(times_.material);
    const Fault fault = compact_.evaluate(want);
    if (!fault.reason.empty())
      return fault;
  }
  const StopWatch watch(times_.assembly);
  internal_ = compact_.internal_forces();
  return {};
}

void Press::meet_tools(const Increment &increment)
{
  const StopWatch watch(times_.contact);
  trial_tools_ = tools_after(increment);
  pair_forces_ = contact_.forces(compact_.trial_positions(), trial_tools_);
}

void Press::assemble_stiffness()
{
  const StopWatch watch(times_.assembly);
  compact_.assemble_stiffness(stiffness_);
  system_.forget_factors();
}

std::vector<double>
Press::imbalance_of(std::span<const double> internal,
                    const std::vector<PairForce> &forces) const
{
  std::vector<double> result(number_of_unknowns(mesh()), 0.);
  std::copy_n(internal.begin(), mesh().number_of_dofs(), result.begin());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const ContactPair &pair = contact_.pairs()[i];
    for (unsigned c = 0; c < mesh().components(); ++c)
      result[mesh().dof(pair.node, c)] -= forces[i].force[mesh().axis(c)];
    result[tool_dof(mesh(), pair.tool)] += forces[i].force[2];
  }
  for (const Tool tool : {upper_punch, lower_punch, die_wall})
    result[tool_dof(mesh(), tool)] +=
        motion_[tool].force / mesh().multiplicity();
  for (std::size_t i = 0; i < result.size(); ++i)
    if (!free_[i])
      result[i] = 0;
  return result;
}

std::vector<double> Press::imbalance() const
{
  return imbalance_of(internal_, pair_forces_);
}

double Press::reference_force() const
{
  return std::max({reactions(pair_forces_),
                   least_reaction_ * peak_reactions_,
                   std::numeric_limits<double>::min()});
}

double Press::tool_imbalance() const
{
  const ToolForces tools = trial_forces();
  double sum = 0, largest = std::max(least_reaction_ * peak_reactions_,
                                     std::numeric_limits<double>::min());
  for (const ToolForce &tool : tools) {
    sum += tool.force[2];
    largest = std::max({largest, std::abs(tool.force[2]), tool.normal});
  }
  return std::abs(sum) / largest;
}

double Press::work_of_powder(const Increment &increment) const
{
  return dot(internal_, std::span(increment).first(internal_.size()));
}

std::vector<ContactBlock>
Press::contact_blocks(const std::vector<PairForce> &forces,
                      const NodePositions &positions,
                      const ToolPositions &tools) const
{
  std::vector<ContactBlock> blocks;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const PairForce &force = forces[i];
    if (force.status == ContactStatus::open)
      continue;
    const bool slips = force.status == ContactStatus::slip && force.slip > 0;
    blocks.push_back({contact_.pairs()[i].node,
                      contact_.pairs()[i].tool,
                      force.status,
                      contact_.stiffness(i, force, positions, tools),
                      slips ? force.friction.norm() / force.slip : 0});
  }
  if (mesh().is_axisymmetric())
    for (ContactBlock &block : blocks)
      for (unsigned i = 0; i < 3; ++i)
        block.stiffness[1][i] = block.stiffness[i][1] = 0; // no unknowns
  return blocks;
}

/// Forces and what is left of them after a change of the increment, if the
/// powder answers linearly.
struct Press::Balance {
  std::vector<double> change, internal;
  NodePositions positions;
  ToolPositions tools{};
  std::vector<PairForce> pairs;
  std::vector<double> right; ///< minus the imbalance [N]
  double rest = 0;           ///< its norm [N]
};

Press::Balance Press::balance_after(const std::vector<double> &change,
                                    std::vector<double> internal,
                                    const Increment &increment) const
{
  Balance result;
  result.change = change;
  result.internal = std::move(internal);
  Increment total(change);
  for (std::size_t i = 0; i < total.size(); ++i)
    total[i] += increment[i];
  result.positions = moved(mesh(), compact_.state().positions, total);
  result.tools = tools_after(total);
  result.pairs = contact_.forces(result.positions, result.tools);
  result.right = imbalance_of(result.internal, result.pairs);
  double squares = 0;
  for (double &value : result.right) {
    squares += value * value;
    value = -value;
  }
  result.rest = std::sqrt(squares);
  return result;
}

bool Press::advance_balance(Balance &now, const Increment &increment)
{
  std::vector<double> step(increment.size(), 0.);
  if (!system_.factorise(stiffness_,
                         contact_blocks(now.pairs, now.positions, now.tools),
                         loaded_) ||
      !system_.solve(now.right, step))
    return false;
  const auto force = system_.multiply_powder(stiffness_, step);
  const auto after = [&](double length) {
    std::vector<double> change = now.change, internal = now.internal;
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] += length * step[i];
    for (std::size_t i = 0; i < internal.size(); ++i)
      internal[i] += length * force[i];
    return balance_after(change, std::move(internal), increment);
  };
  Balance next = after(1);
  find_helpful_length(
      [&](double length) {
        next = after(length);
        return dot(next.right, step);
      },
      dot(now.right, step),
      dot(next.right, step));
  now = std::move(next);
  return true;
}

std::vector<double> Press::balance_tools(const Increment &increment)
{
  // The best balance found is used if it is much better than none.
  constexpr unsigned most = 40, most_augmentations = 3;
  constexpr double tolerance = 1e-9, tight = 1e-12, useful = 0.5;
  const auto allowed = [this](const Balance &balance) {
    return std::max(tolerance * reference_of(balance),
                    contact_.rounding(balance.pairs));
  };
  const StopWatch watch(times_.linear_solver);
  Balance now = balance_after(
      std::vector<double>(increment.size(), 0.), internal_, increment);
  Balance best = now;
  const double first_rest = now.rest;
  unsigned augmentations = 0;
  for (unsigned iteration = 0; iteration < most; ++iteration) {
    if (!advance_balance(now, increment))
      return {};
    const bool stalls = now.rest > 0.5 * best.rest;
    if (now.rest <= best.rest)
      best = now;
    if (best.rest > allowed(best) ||
        (best.rest > tight * reference_of(best) && !stalls))
      continue;
    if (augmentations == most_augmentations || is_exact(best))
      break;
    ++augmentations;
    contact_.augment(best.pairs);
    now = best =
        balance_after(best.change, std::move(best.internal), increment);
  }
  if (best.rest > useful * first_rest && best.rest > allowed(best))
    return {};
  contact_.augment(best.pairs);
  snap(best);
  return best.change;
}

double Press::reference_of(const Balance &balance) const
{
  return std::max(reactions(balance.pairs), reference_force());
}

bool Press::is_exact(const Balance &balance) const
{
  constexpr double negligible = 1e-6; // of the change
  double change = 0, penetration = 0;
  for (const double value : balance.change)
    change = std::max(change, std::abs(value));
  for (const PairForce &pair : balance.pairs)
    if (pair.status != ContactStatus::open)
      penetration = std::max(penetration, std::abs(pair.penetration));
  return penetration <= negligible * change;
}

void Press::snap(Balance &balance) const
{
  for (std::size_t i = 0; i < balance.pairs.size(); ++i) {
    const PairForce &pair = balance.pairs[i];
    if (pair.status == ContactStatus::open)
      continue;
    const unsigned node = contact_.pairs()[i].node;
    for (unsigned c = 0; c < mesh().components(); ++c)
      if (free_[mesh().dof(node, c)])
        balance.change[mesh().dof(node, c)] +=
            pair.penetration * pair.normal_direction[mesh().axis(c)];
  }
}

void Press::take_reactions()
{
  contact_.take_reactions(internal_, compact_.trial_positions(), trial_tools_);
  pair_forces_ = contact_.forces(compact_.trial_positions(), trial_tools_);
}

void Press::accept()
{
  work_ +=
      increment_work(compact_,
                     contact_,
                     {compact_.state().positions, tools_, contact_.accepted()},
                     {compact_.trial_positions(), trial_tools_, pair_forces_});
  compact_.accept();
  tools_ = trial_tools_;
  contact_.accept(pair_forces_, compact_.state().positions);
  forces_ = trial_forces();
  peak_reactions_ = std::max(peak_reactions_, reactions(pair_forces_));
}
} // namespace tamp::fem
