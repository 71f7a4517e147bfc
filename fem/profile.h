// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_profile_h
#define fem_profile_h

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace tamp::fem
{
/// What a profile says at a place.
struct ProfilePoint {
  double distance = 0;         ///< [m]; positive on the left of the profile
  dealii::Tensor<1, 2> normal; ///< unit, towards the left
  double curvature = 0;        ///< d normal / d x along the tangent [1/m]
};

/// A chain of straight lines and circular arcs in a plane, the trace of a rigid
/// tool's surface. Seen along the chain the powder is on the left and the tool
/// on the right. The first and the last piece go on straight for ever, or the
/// chain is closed. It must not cross itself, which is not checked.
class Profile
{
public:
  using Point = dealii::Tensor<1, 2>;

  /// @param corners  at least two; successive ones must differ [m]. If the last
  ///                 is the first again, the chain is closed there. A corner at
  ///                 which the chain turns by less than 1e-9 is none.
  /// @param radii    of the arc that rounds each inner corner, zero: sharp; of
  ///                 a closed chain all corners are inner ones, the first comes
  ///                 last. Empty: sharp corners [m].
  /// Throws std::invalid_argument naming the corner if an arc does not fit
  /// between its neighbours, or if the chain turns back on itself.
  explicit Profile(std::vector<Point> corners, std::vector<double> radii = {});

  /// The same with arcs that begin and end at these distances from their
  /// corners [m], as many as there would be radii: so can arcs be joined that
  /// are as flat as one likes. Zero: sharp.
  static Profile with_tangents(std::vector<Point> corners,
                               const std::vector<double> &lengths);

  /// The closest place of the profile, as seen from `position`; one of them if
  /// several are. The curvature is that of the offset curve through `position`,
  /// so that the normal's derivative is exact: of an arc 1 / (distance from its
  /// centre); a sharp corner is an arc of radius zero. Closer to an arc's
  /// centre than 1e-9 of the chain's size, the normal is the mean of those at
  /// the arc's ends and the curvature zero.
  ProfilePoint nearest(const Point &position) const;

  /// The chain consists of faces: it is divided at the sharp corners that turn
  /// to the left, in which powder can touch both sides at once.
  unsigned faces() const { return faces_; }
  /// The same of one face alone, which goes on straight beyond the corners that
  /// end it, as far as the shorter of the two sides there is long. Farther off
  /// the distance is infinite.
  ProfilePoint nearest(const Point &position, unsigned face) const;

private:
  struct Line {
    Point start, direction;
    double begin, end; ///< along the direction, from the start [m]
    double reach_before, reach_after; ///< of its face beyond its ends [m]
    unsigned face;

    ProfilePoint seen_from(const Point &position) const;
  };
  /// A rounded or sharp corner.
  struct Arc {
    Point begin, end, centre;
    Point incoming, outgoing;     ///< unit tangents at the ends
    double radius;                ///< zero: sharp [m]
    double side;                  ///< 1: powder outside the circle, -1: inside
    std::optional<unsigned> face; ///< none: divides two

    double distance_of(const Point &position) const;
    ProfilePoint seen_from(const Point &position, double smallest) const;
  };
  enum class Size { radius, tangent };
  struct Corner;
  struct Chain;

  Profile(const std::vector<Point> &corners,
          const std::vector<double> &sizes,
          Size size);
  void join(const std::vector<Corner> &corners, bool closed);
  ProfilePoint closest(const Point &position,
                       const std::optional<unsigned> &face) const;

  std::vector<Line> lines_;
  std::vector<Arc> arcs_;
  unsigned faces_ = 1;
  double size_ = 0;  ///< largest extent of the corners [m]
  double slack_ = 0; ///< by which pieces overlap, against rounding [m]
};
} // namespace tamp::fem

#endif
