// SPDX-License-Identifier: BSD-3-Clause
#include <fem/tool_contact.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
using Matrix = dealii::Tensor<2, 3>;

/// Stiffness of the contact over that of the powder at the node. The larger,
/// the smaller are penetration and elastic slip; the system of equations
/// becomes ill-conditioned by as much.
constexpr double normal_stiffness = 1e3;
/// Of sticking friction. Softer: stick and slip then meet in few iterations.
constexpr double stick_stiffness = 10;
/// A node nearer to a tool than this share of the mesh touches it.
constexpr double touching = 1e-10;
/// Such a node is in contact without a force only if it is nearer than this
/// share of that: rounding. Further off, a node that is pulled away would be
/// held by a stiffness that has no force, and equilibrium not be found.
constexpr double resting = 1e-4;
/// In an increment the wall goes on above the rim, and what is nearer to the
/// rim than this share of the mesh sees the wall below it.
constexpr double rim_margin = 1e-2;
/// A node this many times further above the rim than what counts as touching
/// is let go.
constexpr double passing = 1e3;
/// Nodes of soft powder count as this share of the stiffest.
constexpr double smallest_stiffness = 1e-3;

/// Does it end at the rim?
bool is_bore(Tool tool)
{
  return tool == die_wall || tool == core_rod;
}

Matrix identity()
{
  Matrix unit;
  unit[0][0] = unit[1][1] = unit[2][2] = 1;
  return unit;
}

/// Mean height of the elements along the die wall; a shoulder has none [m].
double mean_height(const Mesh &mesh, const NodePositions &positions)
{
  constexpr double level = 1e-6;
  const auto &faces = mesh.tools[die_wall].faces;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < faces.size(); i += mesh.nodes_per_face()) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (unsigned a = 0; a < mesh.nodes_per_face(); ++a) {
      low = std::min(low, positions[faces[i + a]][2]);
      high = std::max(high, positions[faces[i + a]][2]);
    }
    if (high - low > level * (std::abs(high) + std::abs(low))) {
      sum += high - low;
      count += 1;
    }
  }
  return count > 0 ? sum / count : 0;
}

/// Area of a face, of the whole ring if axisymmetric [m2].
double face_area(const Mesh &mesh,
                 const unsigned *face,
                 const NodePositions &positions)
{
  if (mesh.is_axisymmetric()) {
    const Vector &a = positions[face[0]], &b = positions[face[1]];
    return std::numbers::pi * (a[0] + b[0]) * (b - a).norm();
  }
  const Vector diagonal = positions[face[3]] - positions[face[0]];
  const Vector other = positions[face[2]] - positions[face[1]];
  return 0.5 * dealii::cross_product_3d(diagonal, other).norm();
}

/// Share of a face's area that belongs to one of its nodes: what the node bears
/// of a constant pressure. The nodes of a ring's face differ as their radii do.
double node_share(const Mesh &mesh,
                  const unsigned *face,
                  unsigned node,
                  const NodePositions &positions)
{
  if (!mesh.is_axisymmetric())
    return 1. / mesh.nodes_per_face();
  const double own = positions[face[node]][0];
  const double other = positions[face[1 - node]][0];
  return own + other > 0 ? (2 * own + other) / (3 * (own + other)) : 0.5;
}
} // namespace

Vector ToolContact::below_rim(Vector place, Tool tool) const
{
  if (is_bore(tool))
    place[2] = std::min(place[2], rim_ - margin_);
  return place;
}

/// How a node approaches a tool.
struct ToolContact::Approach {
  SurfacePoint surface;
  bool below_rim = true; ///< no: the surface seen is that at the rim
  bool touches = false;
  double normal = 0; ///< force [N]
  Vector motion;     ///< of the node relative to the tool in the increment [m]
  Vector trial;      ///< friction if it sticks [N]
  double limit = 0;  ///< of the friction [N]
  double limit_slope = 0; ///< d limit / d normal [-]
};

ToolContact::ToolContact(const Mesh &mesh, const Tools &tools)
    : mesh_(mesh), tools_(tools)
{
  for (unsigned tool = 0; tool < number_of_tools; ++tool)
    if (tools.surfaces[tool])
      for (const unsigned node : mesh.tools[tool].nodes)
        for (unsigned face = 0; face < tools.surfaces[tool]->faces(); ++face)
          pairs_.push_back({node, static_cast<Tool>(tool), face});
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    pairs_of_node_[pairs_[i].node].push_back(i);
  accepted_.resize(pairs_.size());
  multipliers_.assign(pairs_.size(), 0.);
  stiffness_.assign(pairs_.size(), 0.);
  densities_.assign(pairs_.size(), 0.);
  double size = 0;
  for (const Vector &node : mesh.nodes)
    size = std::max(size, node.norm());
  touch_ = touching * size;
  margin_ = rim_margin * size;
  for (const unsigned node : mesh.tools[die_wall].nodes)
    rim_ = std::max(rim_, mesh.nodes[node][2]);
  released_.assign(pairs_.size(), false);
  at_release_.resize(pairs_.size());
  release_heights_.assign(pairs_.size(), 0.);
  update_areas(mesh.nodes);
}

void ToolContact::update_areas(const NodePositions &positions)
{
  element_height_ = mean_height(mesh_, positions);
  areas_.clear();
  for (unsigned tool = 0; tool < number_of_tools; ++tool) {
    if (!tools_.surfaces[tool])
      continue;
    const Mesh::Contact &contact = mesh_.tools[tool];
    std::map<unsigned, double> share;
    const unsigned n = mesh_.nodes_per_face();
    for (std::size_t i = 0; i < contact.faces.size(); i += n) {
      const double area = face_area(mesh_, &contact.faces[i], positions);
      for (unsigned a = 0; a < n; ++a)
        share[contact.faces[i + a]] +=
            area * node_share(mesh_, &contact.faces[i], a, positions);
    }
    for (const unsigned node : contact.nodes)
      areas_.insert(areas_.end(), tools_.surfaces[tool]->faces(), share[node]);
  }
}

void ToolContact::begin(std::span<const double> node_stiffness,
                        const NodePositions &positions,
                        const ToolPositions &tools,
                        std::span<const double> densities)
{
  begin_positions_ = positions;
  begin_tools_ = tools;
  double largest = 0;
  for (const ContactPair &pair : pairs_)
    largest = std::max(largest, node_stiffness[pair.node]);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    stiffness_[i] =
        std::max(node_stiffness[pairs_[i].node], smallest_stiffness * largest);
    densities_[i] = densities[pairs_[i].node];
    multipliers_[i] = accepted_[i].normal;
    const double height = positions[pairs_[i].node][2] - tools[pairs_[i].tool];
    if (is_bore(pairs_[i].tool) && !released_[i] &&
        height > rim_ + passing * touch_) {
      released_[i] = true;
      at_release_[i] = accepted_[i];
      release_heights_[i] = height - rim_;
    }
  }
}

ToolContact::Approach ToolContact::approach(std::size_t pair,
                                            const NodePositions &positions,
                                            const ToolPositions &tools) const
{
  const auto [node, tool, face] = pairs_[pair];
  Vector place = positions[node];
  place[2] -= tools[tool];
  Approach result;
  const Vector seen = below_rim(place, tool);
  result.below_rim = seen == place;
  result.surface = tools_.surfaces[tool]->nearest(seen, face);
  result.normal = multipliers_[pair] -
                  normal_stiffness * stiffness_[pair] * result.surface.distance;
  result.touches =
      !released_[pair] &&
      result.normal >= -normal_stiffness * stiffness_[pair] * resting * touch_;
  result.normal = std::max(result.normal, 0.);
  if (!result.touches)
    return result;
  Vector before = begin_positions_[node];
  before[2] -= begin_tools_[tool];
  result.motion = place - before;
  const Vector force = accepted_[pair].friction -
                       stick_stiffness * stiffness_[pair] * result.motion;
  const Vector &n = result.surface.normal;
  result.trial = force - (force * n) * n;
  const double pressure = areas_[pair] > 0 ? result.normal / areas_[pair] : 0;
  const auto mu = tools_.friction[tool].at(densities_[pair], pressure);
  result.limit = mu.value * result.normal;
  result.limit_slope = mu.value + mu.slope * pressure;
  return result;
}

double ToolContact::fading_way(std::size_t pair) const
{
  constexpr double least = 0.25; // of a node that was let go late
  return std::max(fading_height() - release_heights_[pair],
                  least * fading_height());
}

PairForce ToolContact::fading(std::size_t pair,
                              const NodePositions &positions,
                              const ToolPositions &tools) const
{
  const auto [node, tool, face] = pairs_[pair];
  const double above = positions[node][2] - tools[tool] - rim_;
  const double share =
      std::min(1., 1 - (above - release_heights_[pair]) / fading_way(pair));
  if (share <= 0 || at_release_[pair].status == ContactStatus::open)
    return {};
  PairForce result = at_release_[pair];
  result.status = ContactStatus::fading;
  result.penetration = 0;
  result.normal *= share;
  result.friction *= share;
  result.force *= share;
  return result;
}

PairForce ToolContact::force(std::size_t pair,
                             const NodePositions &positions,
                             const ToolPositions &tools) const
{
  const Approach now = approach(pair, positions, tools);
  if (released_[pair])
    return fading(pair, positions, tools);
  if (!now.touches)
    return {};
  const FrictionForce friction = coulomb_friction(now.trial, now.limit);
  const Vector &n = now.surface.normal;
  PairForce result;
  result.status = friction.status;
  result.normal = now.normal;
  result.penetration = -now.surface.distance;
  result.normal_direction = n;
  result.friction = friction.force;
  result.force = now.normal * n + friction.force;
  result.slip = (now.motion - (now.motion * n) * n).norm();
  return result;
}

std::vector<PairForce> ToolContact::forces(const NodePositions &positions,
                                           const ToolPositions &tools) const
{
  std::vector<PairForce> result;
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    result.push_back(force(i, positions, tools));
  return result;
}

Matrix ToolContact::stiffness(std::size_t pair,
                              const PairForce &force,
                              const NodePositions &positions,
                              const ToolPositions &tools) const
{
  if (force.status == ContactStatus::open)
    return {};
  if (released_[pair]) {
    Matrix result;
    for (unsigned i = 0; i < 3; ++i)
      result[i][2] = at_release_[pair].force[i] / fading_way(pair);
    return result;
  }
  const Approach now = approach(pair, positions, tools);
  const Vector &n = now.surface.normal;
  // Above the rim neither distance nor normal changes along z.
  Matrix seen = identity();
  seen[2][2] = now.below_rim ? 1 : 0;
  const Matrix H = Matrix(now.surface.normal_gradient) * seen;
  const double epsilon = normal_stiffness * stiffness_[pair];
  const double stick = stick_stiffness * stiffness_[pair];
  // - d (N n), - d trial with trial = (I - n n) (T_n - k motion)
  const Matrix normal =
      epsilon * dealii::outer_product(n, seen * n) - now.normal * H;
  const Vector pull = accepted_[pair].friction - stick * now.motion;
  const Matrix trial = stick * (identity() - dealii::outer_product(n, n)) +
                       (n * pull) * H + dealii::outer_product(n, pull * H);
  if (force.status == ContactStatus::stick)
    return normal + trial;
  if (!(now.limit > 0))
    return normal;
  const double size = now.trial.norm();
  const Vector t = now.trial / size;
  return normal +
         epsilon * now.limit_slope * dealii::outer_product(t, seen * n) +
         (now.limit / size) *
             ((identity() - dealii::outer_product(t, t)) * trial);
}

double ToolContact::rounding(std::span<const PairForce> forces) const
{
  const double distance =
      std::numeric_limits<double>::epsilon() * touch_ / touching;
  double squares = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (forces[i].status != ContactStatus::open)
      squares += std::pow(normal_stiffness * stiffness_[i] * distance, 2);
  return std::sqrt(squares);
}

void ToolContact::augment(std::span<const PairForce> forces)
{
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    multipliers_[i] = forces[i].normal;
}

void ToolContact::take_reactions(std::span<const double> internal,
                                 const NodePositions &positions,
                                 const ToolPositions &tools)
{
  // Tools that meet at a node depend on each other through their friction.
  constexpr unsigned sweeps = 3;
  std::vector<PairForce> now = forces(positions, tools);
  for (unsigned sweep = 0; sweep < sweeps; ++sweep)
    for (const auto &[node, pairs] : pairs_of_node_)
      for (const std::size_t i : pairs) {
        if (now[i].status == ContactStatus::open ||
            now[i].status == ContactStatus::fading)
          continue;
        Vector rest;
        for (unsigned c = 0; c < mesh_.components(); ++c)
          rest[mesh_.axis(c)] = internal[mesh_.dof(node, c)];
        for (const std::size_t j : pairs)
          if (j != i)
            rest -= now[j].force;
        if (std::abs(now[i].penetration) > touch_)
          continue; // not on the tool yet: the penalty pushes it there
        multipliers_[i] +=
            std::max(rest * now[i].normal_direction, 0.) - now[i].normal;
        now[i] = force(i, positions, tools);
      }
}

void ToolContact::accept(std::span<const PairForce> forces,
                         const NodePositions &positions)
{
  accepted_.assign(forces.begin(), forces.end());
  update_areas(positions);
}

ToolForces ToolContact::sums(std::span<const PairForce> forces) const
{
  ToolForces result;
  const ContactPair *counted = nullptr;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const ContactPair &pair = pairs_[i];
    ToolForce &tool = result[pair.tool];
    tool.force += forces[i].force;
    tool.normal += forces[i].normal;
    if (forces[i].status == ContactStatus::open ||
        (counted && counted->node == pair.node && counted->tool == pair.tool))
      continue;
    tool.area += areas_[i];
    counted = &pair;
  }
  return result;
}
} // namespace tamp::fem
