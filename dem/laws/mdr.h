// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_mdr_h
#define dem_laws_mdr_h

#include <dem/laws/mdr_side.h>

#include <array>

namespace tamp::dem
{
/// The mechanically derived contact law of two elastic-plastic grains at high
/// relative density, without adhesion. Each grain is pressed by a rigid flat in
/// the contact plane (SphereOnFlat); the force is the mean of both sides.
///
/// The flat divides the largest overlap as two intersecting spheres do; in
/// unloading both sides go to their zero of force together. Before either has
/// yielded the division follows the overlap, so that elastic contacts have no
/// memory. At small overlap the mean is Hertz's force of two spheres, of equal
/// size or not. The radii of the pair are the apparent ones, and delta_Y scales
/// with them.
///
/// Contacts of one grain learn of each other between increments only, by
/// grow_grains(): the apparent radius grows by the volume that flats displace,
/// and in a grain with little free surface a part delta_B of the overlap goes
/// into N_bulk = kappa sum(A_c) / V delta_B A_c. Within an increment, delta_B
/// follows the own overlap, as if all flats of the grain moved alike, and so
/// does the rest of the overlap in unloading, as if none other moved; either is
/// the stiffer guess, which keeps the explicit coupling stable, and
/// grow_grains() sets it right. A contact that goes through a third grain
/// carries less, by obstruction().
///
/// The law is made for relative densities above about 0.8, where contacts
/// interact, and for grains of one material. Without grow_grains() it is a
/// pairwise law and locks up no more than others.
/// Sources: Zunker & Kamrin (2024), J. Mech. Phys. Solids 183:105492 and
/// 105493; Zunker et al. (2025), Powder Technol., 120972.
class Mdr
{
public:
  /// First side, second side, obstruction() of the contact.
  static constexpr int more = 2 * MdrMemory<double>::size + 1;

  /// @param youngs_modulus  E of the grains [Pa]
  /// @param poisson_ratio   nu of the grains [-]
  /// @param yield_stress    Y of the grains [Pa]
  Mdr(double youngs_modulus, double poisson_ratio, double yield_stress)
      : flat_(youngs_modulus, poisson_ratio, yield_stress),
        bulk_modulus_(youngs_modulus / (3 * (1 - 2 * poisson_ratio)))
  {
  }

  /// A grain on a rigid flat.
  const SphereOnFlat &flat() const { return flat_; }
  /// kappa = E / (3 (1 - 2 nu)) of the grains [Pa].
  double bulk_modulus() const { return bulk_modulus_; }

  /// The two sides at an overlap, first grain first.
  template <class V>
  std::array<MdrSide<V>, 2> sides(const V &overlap,
                                  const PairShape<V> &pair,
                                  const NormalMemory<V> &memory) const;

  /// Force and contact radius at an overlap.
  /// @param overlap  delta [m]; zero or negative gives zero force
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const auto [one, two] = sides(overlap, pair, memory);
    memory.largest_overlap = max(memory.largest_overlap, max(overlap, V(0.0)));
    memory.more[0] = one.peak.overlap;
    memory.more[MdrMemory<double>::size] = two.peak.overlap;
    const auto touching = overlap > V(0.0);
    const V open = V(1.0) - memory.more[2 * MdrMemory<double>::size];
    const V force = V(0.5) * open * (one.force + two.force);
    const V radius = V(0.5) * (one.contact_radius + two.contact_radius);
    return {select(touching, force, V(0.0)),
            select(touching, radius, V(0.0)),
            V(0.0)};
  }

  /// Where both flats come within a twentieth of the radius of the centre of
  /// their grain [m]. Grains of uniaxially pressed powder are flat, and the
  /// spheres of two that differ in size intersect beyond the centre of the
  /// smaller one; the flat then stays before it and the larger one yields the
  /// rest of the overlap, as in the source.
  template <class V>
  V deepest_overlap(const PairShape<V> &pair) const
  {
    return V(SphereOnFlat::overlap_limit) * pair.radius_sum;
  }

  /// dN/d delta for further loading, a difference over 1e-6 of the overlap
  /// [N/m].
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       const NormalMemory<double> &memory) const;
  /// A bound of dN/d delta at the largest overlap, or that of yield if it is
  /// larger: of unloading, and of the grains in bulk [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const;
  /// Without adhesion nothing is lost as grains touch or part [J].
  double lost_at_touch(const PairShape<double> &,
                       const NormalMemory<double> &) const
  {
    return 0;
  }
  double lost_at_tear(const PairShape<double> &,
                      const NormalMemory<double> &) const
  {
    return 0;
  }
  /// Whether a side of the contact has yielded.
  bool is_plastic(const PairShape<double> &pair,
                  const NormalMemory<double> &memory) const;

  /// Elastic energy, and the loss: work of the virgin curve up to the largest
  /// overlap less what full unloading gives back.
  ///
  /// What a yielded contact gives back is a closed form, with delta_B N_bulk /
  /// 2 as for a constant area; the work of the virgin curve is Gauss-Legendre
  /// quadrature between its kinks, good to 1e-9. The virgin curve is that of
  /// the radii now: where these have grown, the loss is an estimate.
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      const NormalMemory<double> &memory) const;

private:
  // Overlap of the first grain with the plane in which the spheres intersect.
  template <class V>
  static V split(const V &overlap, const PairShape<V> &pair);
  // One side, given its overlap at the anchor of the division.
  template <class V>
  MdrSide<V>
  at_anchor(const V &overlap, const V &radius, const MdrMemory<V> &old) const;
  // The same side at another overlap.
  template <class V>
  MdrSide<V> moved(const MdrSide<V> &side,
                   const V &overlap,
                   const V &radius,
                   const MdrMemory<V> &old) const;
  // Work of the virgin curve [J].
  double virgin_work(double overlap, const PairShape<double> &pair) const;

  SphereOnFlat flat_;
  double bulk_modulus_; // kappa
};

template <class V>
V Mdr::split(const V &overlap, const PairShape<V> &pair)
{
  const V limit = V(0.5 * SphereOnFlat::overlap_limit);
  const V first = pair.radius_sum - pair.radius_difference;  // 2 R_i
  const V second = pair.radius_sum + pair.radius_difference; // 2 R_j
  const V plane =
      overlap * (second - overlap) / (V(2.0) * (pair.radius_sum - overlap));
  return min(max(plane, overlap - limit * second), limit * first);
}

template <class V>
MdrSide<V>
Mdr::at_anchor(const V &overlap, const V &radius, const MdrMemory<V> &old) const
{
  MdrSide<V> side = {};
  side.peak = flat_.peak(
      max(old.largest, overlap - old.bulk_overlap_at(overlap)), radius);
  return side;
}

template <class V>
MdrSide<V> Mdr::moved(const MdrSide<V> &side,
                      const V &overlap,
                      const V &radius,
                      const MdrMemory<V> &old) const
{
  const V bulk = old.bulk_overlap_at(overlap);
  const V area = flat_.area(overlap, side.peak.overlap, radius);
  const V local = old.local_overlap_at(overlap, side.peak.overlap);
  const NormalAnswer<V> push = flat_.push(local, side.peak, radius);
  // Under bulk pressure the whole geometric contact is closed.
  const V closed =
      select(bulk > V(0.0), sqrt(area * V(std::numbers::inv_pi)), V(0.0));
  return {overlap,
          local,
          bulk,
          area,
          side.peak,
          push.force + old.bulk_stiffness * bulk * area,
          max(push.contact_radius, closed)};
}

template <class V>
std::array<MdrSide<V>, 2> Mdr::sides(const V &overlap,
                                     const PairShape<V> &pair,
                                     const NormalMemory<V> &memory) const
{
  const V limit = V(SphereOnFlat::overlap_limit) * pair.radius_sum;
  const V delta = min(max(overlap, V(0.0)), limit);
  const V largest = min(max(memory.largest_overlap, delta), limit);
  const V first = V(0.5) * (pair.radius_sum - pair.radius_difference);
  const V second = V(0.5) * (pair.radius_sum + pair.radius_difference);
  const auto one_old = MdrMemory<V>::read(memory.more);
  const auto two_old = MdrMemory<V>::read(memory.more + MdrMemory<V>::size);

  const V yield = V(flat_.yield_ratio());
  const V beyond_yield =
      max(one_old.largest - yield * first, two_old.largest - yield * second);
  const V anchor = select(beyond_yield > V(0.0), largest, delta);
  const V plane = split(anchor, pair);
  const MdrSide<V> one = at_anchor(plane, first, one_old);
  const MdrSide<V> two = at_anchor(anchor - plane, second, two_old);

  const V back =
      (anchor - delta) / max(one.peak.recovery + two.peak.recovery, V(tiny));
  return {
      moved(one, plane - back * one.peak.recovery, first, one_old),
      moved(two, anchor - plane - back * two.peak.recovery, second, two_old)};
}
} // namespace tamp::dem

#endif
