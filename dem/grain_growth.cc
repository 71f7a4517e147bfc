// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_growth.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;
constexpr double largest_growth = 1.5; // R / R_o

/// A side of a contact.
struct Face {
  std::uint32_t grain = 0;
  MdrSide<double> side;
  double open = 1;    // less the obstruction
  double force = 0;   // of the contact [N]
  bool flows = false; // yielded, and at its largest overlap
  MdrMemory<double> memory;
};

/// Sums over the faces of one grain.
struct Surface {
  double contact_area = 0; // sum A_c
  double caps_area = 0;    // sum 2 pi R (delta_max + delta_B)
  double caps_volume = 0;  // sum pi/3 delta^2 (3 R - delta)
  double swept = 0;        // sum A_c d delta
  bool filled = false;     // psi < psi_b
};

double ball(double radius)
{
  return 4.0 / 3 * pi * radius * radius * radius;
}

/// Volume of the cap that a flat at `distance` from the centre cuts off.
double cap(double radius, double distance)
{
  const double height = radius - distance;
  return pi / 3 * height * height * (2 * radius + distance);
}

PairShape<double> shape(double first, double second)
{
  return {first + second, first * second / (first + second), second - first, 0};
}

std::vector<Face> faces_of(const Mdr &law,
                           std::span<const double> radius,
                           std::span<const GrownContact> contacts,
                           std::span<const double> more)
{
  std::vector<Face> faces(2 * contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const GrownContact &contact = contacts[c];
    std::array<double, Mdr::more> own;
    std::copy_n(more.begin() + c * Mdr::more, Mdr::more, own.begin());
    const auto [first, second] = contact.branch.pair;
    const std::uint32_t grain[2] = {first, second};
    const auto pair = shape(radius[first], radius[second]);
    const double overlap = pair.radius_sum - contact.branch.way.norm();
    NormalMemory<double> memory = {contact.largest_overlap, 0, own.data()};
    const auto sides = law.sides(overlap, pair, memory);
    const double force = law(overlap, pair, memory).force;
    for (int k = 0; k < 2; ++k) {
      Face &face = faces[2 * c + k];
      face = {grain[k], sides[k], 1 - own[Mdr::more - 1], force, false, {}};
      face.memory =
          MdrMemory<double>::read(own.data() + k * MdrMemory<double>::size);
      constexpr double rounding = 1 - 1e-6; // of memories in single precision
      const double largest = face.memory.largest;
      face.flows = force > 0 &&
                   largest > law.flat().yield_ratio() * radius[grain[k]] &&
                   sides[k].local_overlap >= rounding * largest;
    }
  }
  return faces;
}

std::vector<Surface> surfaces(std::span<const double> radius,
                              std::span<const Face> faces)
{
  std::vector<Surface> result(radius.size());
  for (const Face &face : faces) {
    Surface &sum = result[face.grain];
    const double R = radius[face.grain];
    const double overlap = std::max(0.0, face.side.overlap);
    const double area = face.open * face.side.area;
    sum.contact_area += area;
    sum.caps_area +=
        face.open * 2 * pi * R * (face.memory.largest + face.side.bulk_overlap);
    sum.caps_volume += cap(R, R - overlap);
    sum.swept += area * (face.side.overlap - face.memory.seen);
  }
  return result;
}

/// Obstruction of contacts by those that overlap.
std::vector<double> obstruction_of(std::span<const GrownContact> contacts,
                                   std::span<const double> radius)
{
  std::vector<Branch> branches;
  std::vector<std::size_t> place;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Branch &branch = contacts[c].branch;
    const double reach = radius[branch.pair.first] + radius[branch.pair.second];
    if (branch.way.norm() < reach) {
      branches.push_back(branch);
      place.push_back(c);
    }
  }
  const std::vector<double> touching = obstruction(branches, radius.size());
  std::vector<double> result(contacts.size(), 0.0);
  for (std::size_t t = 0; t < place.size(); ++t)
    result[place[t]] = touching[t];
  return result;
}

/// Takes the mean displacement of the flats of a grain into delta_B.
void update_bulk(Face &face, const Surface &sum, double stiffness)
{
  MdrMemory<double> &memory = face.memory;
  const double moved =
      sum.contact_area > 0 ? sum.swept / sum.contact_area : 0.0;
  const bool was_bulk = memory.bulk_stiffness > 0;
  if (was_bulk && (sum.filled || moved < 0))
    memory.bulk_overlap = std::max(0.0, memory.bulk_overlap + moved);
  memory.largest =
      std::max(memory.largest, face.side.overlap - memory.bulk_overlap);
  memory.bulk_stiffness =
      sum.filled || memory.bulk_overlap > 0 ? stiffness : 0.0;
}

/// The displaced volume of one grain that is not yet in its radius.
struct Displaced {
  std::vector<Face *> faces; // that flow
  double known = 0;          // caps counted, elastic change, at radius R [m3]
};

/// Radius at which the volume balance of a grain holds, at least R.
double balanced_radius(double R, double largest, const Displaced &displaced)
{
  constexpr int iterations = 30;
  double next = R;
  for (int i = 0; i < iterations; ++i) {
    double excess = ball(next) - ball(R) + displaced.known;
    double slope = 4 * pi * next * next;
    for (const Face *face : displaced.faces) {
      const double distance = R - face->side.overlap;
      excess -= face->open * cap(next, distance);
      slope -= face->open * 2 * pi * next * (next - distance);
    }
    if (slope < 0.01 * 4 * pi * R * R)
      return next; // no surface is left that could move
    const double step = excess / slope;
    next = std::clamp(next - step, R, largest);
    if (std::abs(step) < 1e-14 * R)
      break;
  }
  return next;
}

/// Marks all that a face displaced as counted.
void count(Face &face, double R)
{
  face.memory.counted = face.side.overlap;
  face.memory.counted_push = face.force * (R - face.side.overlap);
}

/// What a face that flows counted before, or where it yielded.
void start_count(MdrMemory<double> &memory, const SphereOnFlat &flat, double R)
{
  if (memory.counted > 0)
    return;
  const double yield = flat.yield_ratio() * R;
  memory.counted = yield;
  memory.counted_push = flat.peak(yield, R).force * (R - yield);
}

/// New radii; the counts of the faces that made them are brought up to date.
std::vector<double> grown_radii(const Mdr &law,
                                const GrainRadii &radii,
                                std::span<const Surface> sums,
                                std::vector<Face> &faces)
{
  std::vector<Displaced> displaced(sums.size());
  for (Face &face : faces) {
    if (!face.flows)
      continue;
    const double R = radii.apparent[face.grain];
    if (sums[face.grain].filled) {
      count(face, R); // there is nowhere to grow to
      continue;
    }
    start_count(face.memory, law.flat(), R);
    const double push = face.force * (R - face.side.overlap);
    Displaced &grain = displaced[face.grain];
    grain.faces.push_back(&face);
    grain.known += face.open * cap(R, R - face.memory.counted) +
                   (push - face.memory.counted_push) / (3 * law.bulk_modulus());
  }
  std::vector<double> radius(radii.apparent.begin(), radii.apparent.end());
  for (std::size_t g = 0; g < radius.size(); ++g) {
    const double R = radius[g];
    const double largest = std::max(R, largest_growth * radii.initial[g]);
    if (displaced[g].faces.empty())
      continue;
    radius[g] = balanced_radius(R, largest, displaced[g]);
    if (radius[g] > R)
      for (Face *face : displaced[g].faces)
        count(*face, R);
  }
  return radius;
}
} // namespace

GrainGrowth grow_grains(const Mdr &law,
                        const GrainRadii &radii,
                        std::span<const GrownContact> contacts,
                        std::span<const double> more,
                        double bulk_onset)
{
  assert(radii.apparent.size() == radii.initial.size());
  assert(more.size() == contacts.size() * Mdr::more);
  std::vector<Face> faces = faces_of(law, radii.apparent, contacts, more);
  std::vector<Surface> sums = surfaces(radii.apparent, faces);
  GrainGrowth growth;
  growth.free_surface.resize(sums.size());
  for (std::size_t g = 0; g < sums.size(); ++g) {
    const double R = radii.apparent[g];
    const double total =
        4 * pi * R * R + sums[g].contact_area - sums[g].caps_area;
    growth.free_surface[g] =
        std::max(0.0, 1 - sums[g].contact_area / std::max(total, tiny));
    sums[g].filled = growth.free_surface[g] < bulk_onset;
  }
  growth.radius = grown_radii(law, radii, sums, faces);

  growth.more.resize(more.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Face &face = faces[f];
    const Surface &sum = sums[face.grain];
    const double R = radii.apparent[face.grain];
    const double volume =
        std::min(ball(radii.initial[face.grain]), ball(R) - sum.caps_volume);
    update_bulk(face,
                sum,
                law.bulk_modulus() * sum.contact_area /
                    std::max(volume, 0.1 * ball(radii.initial[face.grain])));
    // The flat stays where it is: its overlap grows with the radius.
    const double grown = growth.radius[face.grain] - R;
    face.memory.seen = face.side.overlap + grown;
    if (face.memory.counted > 0)
      face.memory.counted += grown;
    face.memory.write(growth.more.data() + f / 2 * Mdr::more +
                      f % 2 * MdrMemory<double>::size);
  }
  const std::vector<double> obstructed =
      obstruction_of(contacts, radii.apparent);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    growth.more[(c + 1) * Mdr::more - 1] = obstructed[c];
  return growth;
}
} // namespace tamp::dem
