// SPDX-License-Identifier: BSD-3-Clause
#include <fem/smooth_chain.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;

constexpr double slight = 1e-3;                          // [rad]
constexpr double sharpest = 35 * std::numbers::pi / 180; // [rad]
constexpr double alike = 1. / 3;                         // of a turn [-]

Point unit(const Point &vector)
{
  return vector / vector.norm();
}

/// What the chain says at its nodes.
class Nodes
{
public:
  explicit Nodes(const std::vector<Point> &nodes)
      : nodes_(nodes), turns_(nodes.size(), 0.)
  {
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      const Point before = way(i - 1), after = way(i);
      turns_[i] = std::atan2(before[0] * after[1] - before[1] * after[0],
                             before * after);
    }
  }

  std::size_t segments() const { return nodes_.size() - 1; }
  Point way(std::size_t segment) const
  {
    return nodes_[segment + 1] - nodes_[segment];
  }
  bool is_smooth(std::size_t i) const
  {
    if (is_end(i) || std::abs(turns_[i]) > sharpest)
      return false;
    return is_slight(i) || turns_like(i, i - 1) || turns_like(i, i + 1);
  }
  /// Tangent at a smooth node.
  Point tangent(std::size_t i) const
  {
    const Point before = way(i - 1), after = way(i);
    if (!is_slight(i) && is_straight(i - 1) != is_straight(i))
      return unit(is_straight(i) ? after : before);
    // An inversion about the node makes the circle a line along the tangent.
    return unit(before / before.norm_square() + after / after.norm_square());
  }

private:
  bool is_end(std::size_t i) const { return i == 0 || i == segments(); }
  bool is_slight(std::size_t i) const
  {
    return !is_end(i) && std::abs(turns_[i]) < slight;
  }
  bool is_straight(std::size_t segment) const
  {
    return is_slight(segment) || is_slight(segment + 1);
  }
  bool turns_like(std::size_t i, std::size_t neighbour) const
  {
    return std::abs(turns_[neighbour]) <= sharpest &&
           turns_[neighbour] * turns_[i] > 0 &&
           std::abs(turns_[neighbour]) >= alike * std::abs(turns_[i]);
  }

  const std::vector<Point> &nodes_;
  std::vector<double> turns_; ///< to the left [rad]
};

/// Tangents at a segment's ends: where a run of smooth nodes ends, of the arc
/// that has the tangent at the segment's other end.
struct Tangents {
  Point begin, end;
};

Tangents tangents_of(const Nodes &nodes, std::size_t segment)
{
  const Point along = unit(nodes.way(segment));
  const auto mirrored = [&](const Point &tangent) {
    return 2 * (tangent * along) * along - tangent;
  };
  const bool begins = nodes.is_smooth(segment);
  const bool ends = nodes.is_smooth(segment + 1);
  Tangents result{along, along};
  if (begins)
    result.begin = nodes.tangent(segment);
  if (ends)
    result.end = nodes.tangent(segment + 1);
  if (begins && !ends)
    result.end = mirrored(result.begin);
  if (ends && !begins)
    result.begin = mirrored(result.end);
  return result;
}
} // namespace

Profile smooth_chain(const std::vector<Point> &nodes)
{
  if (nodes.size() < 3)
    return Profile(nodes);
  const Nodes chain(nodes);
  std::vector<Point> corners{nodes.front()};
  std::vector<double> lengths;
  for (std::size_t i = 0; i < chain.segments(); ++i) {
    const Point way = chain.way(i);
    const auto [begin, end] = tangents_of(chain, i);
    // Both arcs have tangents of this length; it solves Bolton's quadratic.
    const double along = way * (begin + end);
    const double length =
        way.norm_square() /
        (along + std::sqrt(along * along +
                           (begin - end).norm_square() * way.norm_square()));
    corners.push_back(nodes[i] + length * begin);
    corners.push_back(nodes[i + 1] - length * end);
    corners.push_back(nodes[i + 1]);
    lengths.insert(lengths.end(), {length, length, 0.});
  }
  return Profile::with_tangents(corners, {lengths.begin(), lengths.end() - 1});
}
} // namespace tamp::fem
