// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_slip_curve_h
#define dem_laws_slip_curve_h

#include <dem/laws/lane_math.h>

namespace tamp::dem
{
/// What a contact answers to a slip.
template <class V>
struct SlipResponse {
  V force; ///< gained in the direction of the slip [N]
  V lost;  ///< turned into heat [J]
  V work;  ///< of the gained force, along a straight slip [J]
};

template <class V>
SlipResponse<V>
select(const auto &mask, const SlipResponse<V> &yes, const SlipResponse<V> &no)
{
  return {select(mask, yes.force, no.force),
          select(mask, yes.lost, no.lost),
          select(mask, yes.work, no.work)};
}

/// Partial slip of two spheres under a constant normal force: a ring that
/// slips grows inwards and leaves a core of radius c that sticks. With
/// theta = c/a, the first loading is T = mu N (1 - theta^3) at the slip
/// (1 - theta^2) delta_m, delta_m = 3 mu N / (16 G* a). After a turn of the
/// slip the same curve holds, twice as large, from the turning point
/// (`scale` = 2).
/// Source: Cattaneo (1938); Mindlin & Deresiewicz (1953), J. Appl. Mech.
/// 20:327; Johnson, Contact Mechanics (1985), section 7.4.
template <class V>
struct SlipCurve {
  V stiffness; ///< 8 G* a [N/m]
  V limit;     ///< mu N [N]
  V depth;     ///< delta_m, where all of the contact slips [m]

  SlipCurve(const V &k, const V &coulomb)
      : stiffness(k), limit(coulomb), depth(V(1.5) * coulomb / max(k, V(tiny)))
  {
  }

  /// theta at a slip.
  V core(const V &slip, double scale) const
  {
    return sqrt(max(V(0.0), V(1.0) - share(slip, scale)));
  }
  /// Force at a slip from the start of the curve [N].
  V force(const V &slip, double scale) const
  {
    const V c = core(slip, scale), x = min(share(slip, scale), V(1.0));
    return V(scale) * limit * x * ((V(1.0) + c + c * c) / (V(1.0) + c));
  }
  /// Slip from the start of the curve at a force [m].
  V slip(const V &force, double scale) const
  {
    const V part = min(force / max(V(scale) * limit, V(tiny)), V(1.0));
    const V c = cube_root(max(V(0.0), V(1.0) - part));
    return V(scale) * depth * (part * ((V(1.0) + c) / (V(1.0) + c + c * c)));
  }
  /// Heat from the start of the curve to a slip [J]: the traction of every
  /// ring times how far it slid. A whole loop gives Johnson's eq. 7.59.
  V lost(const V &slip, double scale) const
  {
    const V c = core(slip, scale);
    const V gap = min(share(slip, scale), V(1.0)) / (V(1.0) + c); // 1 - theta
    const V rings =
        V(2.0 / 15) * gap * gap * gap * (V(1.0) + V(3.0) * c + c * c);
    const V beyond = max(V(0.0), slip - V(scale) * depth);
    return V(scale) * stiffness * depth * depth * rings + limit * beyond;
  }
  /// Work of the force from the start of the curve to a slip [J].
  V work(const V &slip, double scale) const
  {
    const V c = core(slip, scale), x = min(share(slip, scale), V(1.0));
    const V gap = x / (V(1.0) + c); // 1 - theta
    const V sum = V(0.6) + c * (V(1.2) + c * (V(0.8) + V(0.4) * c));
    const V beyond = max(V(0.0), slip - V(scale) * depth);
    return V(scale * scale) * limit * depth * gap * gap * sum +
           V(scale) * limit * beyond;
  }
  /// Elastic energy of a first loading up to a force [J]. No other history
  /// with this force keeps less.
  V energy(const V &force) const
  {
    const V s = slip(force, 1), c = core(s, 1);
    const V gap = min(share(s, 1), V(1.0)) / (V(1.0) + c);
    const V rings =
        V(1.0 / 15) * gap * gap * gap * (V(8.0) + V(9.0) * c + V(3.0) * c * c);
    return V(0.5) * stiffness * (c * s * s + depth * depth * rings);
  }

  /// Answer to a straight slip of a contact whose only history is a first
  /// loading up to `start`, positive along the slip [N]. Against its force
  /// the contact turns, and at the opposite force the turn is forgotten.
  SlipResponse<V> first_loading(const V &start, const V &way) const
  {
    const V size = min(abs(start), limit), begin = slip(size, 1);
    const V end = begin + begin;
    const SlipResponse<V> on{force(begin + way, 1) - size,
                             lost(begin + way, 1) - lost(begin, 1),
                             work(begin + way, 1) - work(begin, 1) -
                                 size * way};
    const SlipResponse<V> turn{force(way, 2), lost(way, 2), work(way, 2)};
    const V rest = max(way - begin, V(0.0));
    const SlipResponse<V> across{size + force(rest, 1),
                                 lost(end, 2) + lost(rest, 1) - lost(begin, 1),
                                 work(end, 2) + work(rest, 1) - work(begin, 1) +
                                     size * (way - end)};
    return select(start >= V(0.0), on, select(way < end, turn, across));
  }

private:
  V share(const V &slip, double scale) const
  {
    return slip / max(V(scale) * depth, V(tiny));
  }
};
} // namespace tamp::dem

#endif
