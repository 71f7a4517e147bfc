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

std::vector<double> size_of_each(const std::vector<Point> &corners,
                                 const std::vector<double> &sizes,
                                 bool closed)
{
  // A closed chain names its first corner twice: at its end it is an inner one.
  const std::size_t inner = corners.size() - (closed ? 1 : 2);
  if (!sizes.empty() && sizes.size() != inner)
    throw std::invalid_argument("profile: there are " +
                                std::to_string(sizes.size()) +
                                " radii; expected one for each of the " +
                                std::to_string(inner) + " inner corners");
  std::vector<double> result(corners.size(), 0.);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (!(sizes[i] >= 0))
      complain("a negative radius", corners[i + 1], "zero or more");
    result[i + 1] = sizes[i];
  }
  return result;
}
} // namespace

struct Profile::Corner {
  Point position;
  double size; ///< of its arc: see what
  Size what;

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
  /// Can powder touch both of its sides at once?
  bool is_hollow(const Corner &before, const Corner &after) const
  {
    return !(size > 0) && turn_between(before, after) > 0;
  }
  /// Between the corner and the ends of its arc [m].
  double tangent_length(const Corner &before, const Corner &after) const
  {
    return what == Size::tangent ? size : size * half_turn(before, after);
  }
  double radius(const Corner &before, const Corner &after) const
  {
    return what == Size::radius ? size : size / half_turn(before, after);
  }

private:
  /// Tangent of half the angle by which a chain turns here.
  double half_turn(const Corner &before, const Corner &after) const
  {
    return std::tan(std::abs(turn_between(before, after)) / 2);
  }
};

Profile::Profile(std::vector<Point> corners, std::vector<double> radii)
    : Profile(corners, radii, Size::radius)
{
}

Profile Profile::with_tangents(std::vector<Point> corners,
                               const std::vector<double> &lengths)
{
  return Profile(corners, lengths, Size::tangent);
}

Profile::Profile(const std::vector<Point> &corners,
                 const std::vector<double> &sizes,
                 Size what)
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
  const auto size = size_of_each(corners, sizes, closed);
  std::vector<Corner> all;
  for (std::size_t i = 0; i < corners.size(); ++i)
    all.push_back({corners[i], size[i], what});
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

/// The corners of a chain with their neighbours.
struct Profile::Chain {
  const std::vector<Corner> &corners;
  bool closed;

  std::size_t lines() const { return corners.size() - 1; }
  /// Of a closed chain the last corner is the first.
  bool is_inner(std::size_t i) const
  {
    return closed || (i > 0 && i < lines());
  }
  const Corner &before(std::size_t i) const
  {
    return corners[i == 0 ? lines() - 1 : i - 1];
  }
  const Corner &after(std::size_t i) const
  {
    return corners[i == lines() ? 1 : i + 1];
  }
  bool is_hollow(std::size_t i) const
  {
    return is_inner(i) && corners[i].is_hollow(before(i), after(i));
  }
  /// How far a face that ends at the corner goes on [m].
  double reach(std::size_t i) const
  {
    const Point &here = corners[i].position;
    return is_hollow(i) ? std::min((before(i).position - here).norm(),
                                   (after(i).position - here).norm())
                        : 0;
  }
  /// The face of each line.
  std::vector<unsigned> faces() const
  {
    std::vector<unsigned> result{0};
    for (std::size_t i = 1; i < lines(); ++i)
      result.push_back(result.back() + is_hollow(i));
    const unsigned last = result.back();
    if (closed && !is_hollow(0)) // it is in the middle of a face
      for (unsigned &face : result)
        face = face == last ? 0 : face;
    return result;
  }
};

void Profile::join(const std::vector<Corner> &corners, bool closed)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Chain chain{corners, closed};
  const std::vector<unsigned> face = chain.faces();
  faces_ = 1 + *std::max_element(face.begin(), face.end());
  // Where the arc of each corner begins and ends; none at a chain's ends.
  std::vector<double> trim(corners.size(), -infinity);
  for (std::size_t i = closed ? 0 : 1; i < chain.lines(); ++i) {
    const Corner &corner = corners[i];
    trim[i] = corner.tangent_length(chain.before(i), chain.after(i));
    const Point incoming = chain.before(i).direction_to(corner);
    const Point outgoing = corner.direction_to(chain.after(i));
    const double left = turn(incoming, outgoing) > 0 ? 1 : -1;
    const double radius = corner.radius(chain.before(i), chain.after(i));
    const Point begin = corner.position - trim[i] * incoming;
    arcs_.push_back({begin,
                     corner.position + trim[i] * outgoing,
                     begin + left * radius * left_of(incoming),
                     incoming,
                     outgoing,
                     radius,
                     -left,
                     {}});
    if (!chain.is_hollow(i))
      arcs_.back().face = face[i];
  }
  if (closed)
    trim.back() = trim.front();
  for (std::size_t i = 0; i < chain.lines(); ++i) {
    const double length =
        (corners[i + 1].position - corners[i].position).norm();
    const double rest = length - trim[i] - trim[i + 1];
    if (rest < -1e-9 * length)
      complain("an arc does not fit",
               corners[trim[i] > trim[i + 1] ? i : i + 1].position,
               "a smaller radius");
    // Nothing is left between arcs that meet.
    if (rest > slack_ || chain.is_hollow(i) || chain.is_hollow(i + 1))
      lines_.push_back({corners[i].position,
                        corners[i].direction_to(corners[i + 1]),
                        trim[i] - slack_,
                        length - trim[i + 1] + slack_,
                        chain.reach(i),
                        chain.reach(i + 1),
                        face[i]});
  }
}

ProfilePoint Profile::Line::seen_from(const Point &position) const
{
  ProfilePoint result;
  result.normal = left_of(direction);
  result.distance = (position - start) * result.normal;
  return result;
}

/// Measured from where the arc begins, since rounding would cost the difference
/// of two long ways from the centre of a flat one.
double Profile::Arc::distance_of(const Point &position) const
{
  const Point offset = position - begin;
  const Point outward = side * left_of(incoming);
  const double length = (position - centre).norm();
  if (!(length + radius > 0))
    return 0;
  return side * (offset * offset + 2 * radius * (offset * outward)) /
         (length + radius);
}

ProfilePoint Profile::Arc::seen_from(const Point &position,
                                     double smallest) const
{
  const Point offset = position - centre;
  const double length = offset.norm();
  ProfilePoint result;
  result.distance = distance_of(position);
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
  return closest(position, {});
}

ProfilePoint Profile::nearest(const Point &position, unsigned face) const
{
  return closest(position, face);
}

ProfilePoint Profile::closest(const Point &position,
                              const std::optional<unsigned> &face) const
{
  // The nearest place is in the span of a line, or in the sector of an arc; a
  // sharp corner is the nearest in the sector that its neighbours leave open.
  double smallest = std::numeric_limits<double>::infinity();
  // Of a whole chain, only a place that is no number has none.
  const Line *line = lines_.empty() || face ? nullptr : &lines_.front();
  const Arc *arc = line || face ? nullptr : &arcs_.front();
  for (const Line &candidate : lines_) {
    const Point offset = position - candidate.start;
    const double along = offset * candidate.direction;
    if (face ? candidate.face != *face ||
                   along < candidate.begin - candidate.reach_before ||
                   along > candidate.end + candidate.reach_after
             : along < candidate.begin || along > candidate.end)
      continue;
    const double across = left_of(candidate.direction) * offset;
    if (across * across < smallest) {
      smallest = across * across;
      line = &candidate;
    }
  }
  for (const Arc &candidate : arcs_) {
    if ((face && candidate.face != face) ||
        (position - candidate.begin) * candidate.incoming < -slack_ ||
        (position - candidate.end) * candidate.outgoing > slack_)
      continue;
    const double gap = candidate.distance_of(position);
    if (gap * gap < smallest) {
      smallest = gap * gap;
      arc = &candidate;
    }
  }
  if (!arc && !line)
    return {std::numeric_limits<double>::infinity(), {}, 0};
  return arc ? arc->seen_from(position, 1e-9 * size_)
             : line->seen_from(position);
}
} // namespace tamp::fem
