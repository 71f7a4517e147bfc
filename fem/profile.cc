// SPDX-License-Identifier: BSD-3-Clause
#include <fem/profile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;

/// The vector turned to the left by a right angle.
Point left_of(const Point &vector)
{
  return Point({-vector[1], vector[0]});
}

/// Angle from one direction to another, positive to the left [rad].
double turn(const Point &from, const Point &to)
{
  return std::atan2(left_of(from) * to, from * to);
}

[[noreturn]] void
complain(const char *what, const Point &corner, const std::string &expected)
{
  std::ostringstream message;
  message << "profile: " << what << " at corner (" << corner[0] << ", "
          << corner[1] << ") m; expected " << expected;
  throw std::invalid_argument(message.str());
}

/// Largest extent of the corners along an axis.
double size_of(const std::vector<Point> &corners)
{
  double size = 0;
  for (const Point &corner : corners)
    for (unsigned axis = 0; axis < 2; ++axis)
      size = std::max(size, std::abs(corner[axis] - corners.front()[axis]));
  return size;
}

std::vector<double> radius_of_each(const std::vector<Point> &corners,
                                   const std::vector<double> &radii,
                                   bool closed)
{
  // A closed chain names its first corner twice: at its end it is an inner one.
  const std::size_t inner = corners.size() - (closed ? 1 : 2);
  if (!radii.empty() && radii.size() != inner)
    throw std::invalid_argument("profile: there are " +
                                std::to_string(radii.size()) +
                                " radii; expected one for each of the " +
                                std::to_string(inner) + " inner corners");
  std::vector<double> result(corners.size(), 0.);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (!(radii[i] >= 0))
      complain("a negative radius", corners[i + 1], "zero or more");
    result[i + 1] = radii[i];
  }
  return result;
}
} // namespace

struct Profile::Corner {
  Point position;
  double radius;

  Point direction_to(const Corner &other) const
  {
    const Point way = other.position - position;
    return way / way.norm();
  }
  /// Angle by which a chain turns here [rad].
  double turn_between(const Corner &before, const Corner &after) const
  {
    const double angle = turn(before.direction_to(*this), direction_to(after));
    if (std::abs(angle) > std::numbers::pi - 1e-6)
      complain("the chain turns back on itself", position, "another direction");
    return angle;
  }
  bool bends(const Corner &before, const Corner &after) const
  {
    return std::abs(turn_between(before, after)) >= 1e-9;
  }
  /// Between the corner and the ends of its arc [m].
  double tangent_length(const Corner &before, const Corner &after) const
  {
    return radius * std::tan(std::abs(turn_between(before, after)) / 2);
  }
};

Profile::Profile(std::vector<Point> corners, std::vector<double> radii)
{
  if (corners.size() < 2)
    throw std::invalid_argument("profile: there are " +
                                std::to_string(corners.size()) +
                                " corners; expected at least two");
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    if (!((corners[i + 1] - corners[i]).norm() > 0))
      complain("no length", corners[i], "the next corner elsewhere");
  size_ = size_of(corners);
  slack_ = 1e-12 * size_;
  const bool closed = corners.size() > 2 && corners.front() == corners.back();
  radii = radius_of_each(corners, radii, closed);
  std::vector<Corner> all;
  for (std::size_t i = 0; i < corners.size(); ++i)
    all.push_back({corners[i], radii[i]});
  if (closed) {
    all.erase(all.begin());
    // A closed chain begins and ends where it bends.
    while (!all.back().bends(all[all.size() - 2], all.front()))
      all.pop_back();
    all.insert(all.begin(), all.back());
  }
  std::vector<Corner> kept{all.front()};
  for (std::size_t i = 1; i + 1 < all.size(); ++i)
    if (all[i].bends(kept.back(), all[i + 1]))
      kept.push_back(all[i]);
  kept.push_back(all.back());
  join(kept, closed);
}

void Profile::join(const std::vector<Corner> &corners, bool closed)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t last = corners.size() - 1;
  // Where the arc of each corner begins and ends; none at a chain's ends.
  std::vector<double> trim(corners.size(), -infinity);
  for (std::size_t i = closed ? 0 : 1; i < last; ++i) {
    const Corner &corner = corners[i];
    const Corner &before = corners[i == 0 ? last - 1 : i - 1];
    const Corner &after = corners[i + 1];
    trim[i] = corner.tangent_length(before, after);
    const Point incoming = before.direction_to(corner);
    const Point outgoing = corner.direction_to(after);
    const double left = turn(incoming, outgoing) > 0 ? 1 : -1;
    const Point centre = corner.position - trim[i] * incoming +
                         left * corner.radius * left_of(incoming);
    arcs_.push_back({centre, incoming, outgoing, corner.radius, -left});
  }
  if (closed)
    trim[last] = trim[0];
  for (std::size_t i = 0; i < last; ++i) {
    const double length =
        (corners[i + 1].position - corners[i].position).norm();
    const double rest = length - trim[i] - trim[i + 1];
    if (rest < -1e-9 * length)
      complain("an arc does not fit",
               corners[trim[i] > trim[i + 1] ? i : i + 1].position,
               "a smaller radius");
    // Nothing is left between arcs that meet.
    if (rest > slack_)
      lines_.push_back({corners[i].position,
                        corners[i].direction_to(corners[i + 1]),
                        trim[i] - slack_,
                        length - trim[i + 1] + slack_});
  }
}

ProfilePoint Profile::Line::seen_from(const Point &position) const
{
  ProfilePoint result;
  result.normal = left_of(direction);
  result.distance = (position - start) * result.normal;
  return result;
}

ProfilePoint Profile::Arc::seen_from(const Point &position,
                                     double smallest) const
{
  const Point offset = position - centre;
  const double length = offset.norm();
  ProfilePoint result;
  result.distance = side * (length - radius);
  if (length > smallest) {
    result.normal = side / length * offset;
    result.curvature = side / length;
  } else {
    const Point mean = left_of(incoming + outgoing);
    result.normal = mean / mean.norm();
  }
  return result;
}

ProfilePoint Profile::nearest(const Point &position) const
{
  // The nearest place is in the span of a line, or in the sector of an arc; a
  // sharp corner is the nearest in the sector that its neighbours leave open.
  double smallest = std::numeric_limits<double>::infinity();
  // Only a place that is no number has none.
  const Line *line = lines_.empty() ? nullptr : &lines_.front();
  const Arc *arc = line ? nullptr : &arcs_.front();
  for (const Line &candidate : lines_) {
    const Point offset = position - candidate.start;
    const double along = offset * candidate.direction;
    if (along < candidate.begin || along > candidate.end)
      continue;
    const double across = left_of(candidate.direction) * offset;
    if (across * across < smallest) {
      smallest = across * across;
      line = &candidate;
    }
  }
  for (const Arc &candidate : arcs_) {
    const Point offset = position - candidate.centre;
    if (offset * candidate.incoming < -slack_ ||
        offset * candidate.outgoing > slack_)
      continue;
    const double gap = offset.norm() - candidate.radius;
    if (gap * gap < smallest) {
      smallest = gap * gap;
      arc = &candidate;
    }
  }
  return arc ? arc->seen_from(position, 1e-9 * size_)
             : line->seen_from(position);
}
} // namespace tamp::fem
