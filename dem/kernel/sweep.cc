// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/sweep.h>
#include <dem/laws/law_choice.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
namespace
{
/// The geometry of a pair.
struct PairGeometry {
  Vector3 branch;  ///< l, from first to second [m]
  double distance; ///< |l| [m]
};

/// The nearest whole number, without the call that std::nearbyint is on old
/// instruction sets: adding 3/2 2^52 leaves no room for a fraction.
inline double nearest_whole(double x)
{
  constexpr double shift = 0x1.8p52;
  return (x + shift) - shift;
}

inline PairGeometry
geometry(const Matrix3 &h, const GrainRow &a, const GrainRow &b)
{
  Vector3 s(b.place[0] - a.place[0],
            b.place[1] - a.place[1],
            b.place[2] - a.place[2]);
  for (int k = 0; k < 3; ++k)
    s[k] -= nearest_whole(s[k]);
  const Vector3 branch = h * s;
  return {branch, branch.norm()};
}

inline Vector3 head(const double *row)
{
  return {row[0], row[1], row[2]};
}

/// How the surfaces moved: relative displacement of the centres less the
/// rotation of both grains over their lever arms r_i = R_i d / (R_i + R_j).
inline void surface_motion(const AffineMotion &affine,
                           const PairGeometry &pair,
                           const GrainRow &a,
                           const GrainRow &b,
                           double arm,
                           ContactMotion &motion)
{
  const Vector3 rolled_a = head(a.motion + 4), rolled_b = head(b.motion + 4);
  motion.slip = head(b.motion) - head(a.motion) +
                affine.gradient * pair.branch -
                arm * (rolled_a + rolled_b).cross(motion.normal);
  motion.spin =
      0.5 * (rolled_a * a.inverse_radius + rolled_b * b.inverse_radius)
                .dot(motion.normal);
}

inline void add(double *row, const Vector3 &value)
{
  for (int k = 0; k < 3; ++k)
    row[k] += value[k];
}

inline void forget(ContactBlock &block, std::size_t lane)
{
  block.force_x[lane] = block.force_y[lane] = block.force_z[lane] = 0;
  block.largest_overlap[lane] = block.contact_radius[lane] = 0;
}

template <class Normal, class Tangential, Memory memory>
void visit_pair(const Normal &normal_law,
                const Tangential &tangential_law,
                const AffineMotion &affine,
                std::span<GrainRow> rows,
                ContactBlock &block,
                std::size_t lane,
                SweepTotals &totals)
{
  GrainRow &a = rows[block.first[lane]], &b = rows[block.second[lane]];
  const PairGeometry pair = geometry(affine.h, a, b);
  const double overlap = block.radius_sum[lane] - pair.distance;
  if (overlap <= 0) {
    if constexpr (memory == Memory::written)
      forget(block, lane);
    return;
  }
  const double reduced = block.reduced_radius[lane];
  double largest = block.largest_overlap[lane];
  const NormalAnswer<double> push = normal_law(overlap, reduced, largest);

  const double arm = pair.distance / block.radius_sum[lane];
  ContactMotion motion;
  motion.normal = pair.branch / pair.distance;
  motion.radius = push.contact_radius;
  motion.old_radius = block.contact_radius[lane];
  motion.force = push.force;
  surface_motion(affine, pair, a, b, arm, motion);
  const Vector3 old(
      block.force_x[lane], block.force_y[lane], block.force_z[lane]);
  const Mindlin::Answer rub = tangential_law(old, motion);

  const Vector3 on_first = rub.force - push.force * motion.normal;
  const Vector3 torque = arm * motion.normal.cross(rub.force);
  add(a.force, on_first);
  add(b.force, -on_first);
  add(a.force + 4, torque);
  add(b.force + 4, torque);

  totals.normal_force += push.force;
  totals.contacts += push.force > 0;
  totals.largest_overlap = std::max(totals.largest_overlap, overlap / reduced);
  if constexpr (memory == Memory::written) {
    totals.slid_work += rub.slid_work;
    totals.yielded_work +=
        normal_law.energy(0, reduced, largest).dissipated -
        normal_law.energy(0, reduced, block.largest_overlap[lane]).dissipated;
    block.force_x[lane] = rub.force[0];
    block.force_y[lane] = rub.force[1];
    block.force_z[lane] = rub.force[2];
    block.largest_overlap[lane] = largest;
    block.contact_radius[lane] = push.contact_radius;
  }
}

template <class Normal, class Tangential, Memory memory>
SweepTotals sweep(const ContactModel &model,
                  const GrainMaterial &material,
                  const AffineMotion &affine,
                  std::span<GrainRow> rows,
                  std::span<ContactBlock> blocks)
{
  const auto normal_law = make_law<Normal>(model, material);
  const auto tangential_law = make_law<Tangential>(model, material);
  for (GrainRow &row : rows)
    std::fill_n(row.force, 8, 0.0);
  SweepTotals totals;
  for (ContactBlock &block : blocks)
    for (std::size_t lane = 0; lane < ContactBlock::lanes; ++lane)
      if (block.radius_sum[lane] > 0)
        visit_pair<Normal, Tangential, memory>(
            normal_law, tangential_law, affine, rows, block, lane, totals);
  return totals;
}

template <class Normal>
Sweep choose(TangentialLaw tangential, Memory memory)
{
  if (tangential == TangentialLaw::mindlin)
    return memory == Memory::frozen ? sweep<Normal, Mindlin, Memory::frozen>
                                    : sweep<Normal, Mindlin, Memory::written>;
  return memory == Memory::frozen
             ? sweep<Normal, NoTangentialForce, Memory::frozen>
             : sweep<Normal, NoTangentialForce, Memory::written>;
}
} // namespace

Sweep choose_sweep(const ContactModel &model, Memory memory)
{
  return model.normal_law == NormalLaw::hertz
             ? choose<Hertz>(model.tangential_law, memory)
             : choose<ThorntonNing>(model.tangential_law, memory);
}
} // namespace tamp::dem
