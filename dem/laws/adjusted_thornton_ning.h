// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_adjusted_thornton_ning_h
#define dem_laws_adjusted_thornton_ning_h

#include <dem/laws/pair_law.h>

#include <numbers>

namespace tamp::dem
{
/// Thornton & Ning's law for a limiting contact pressure p_y that changes
/// between increments. As long as it does not, the forces are those of
/// ThorntonNing.
///
/// ThorntonNing finds the force at the largest overlap delta* on the virgin
/// curve of the p_y of now: under another p_y it would be another force. Here
/// the contact remembers F* there, and a change of p_y leaves it, the unloading
/// (R_p* from F* and a* = sqrt(R* delta*)) and what was lost as they are. Only
/// the slope of further loading is of the p_y of now, pi p_y R*.
///
/// Under a higher p_y a contact may be too shallow to yield. Then it stores all
/// work of its loading: with Hertz's force N_H,
/// dN/d delta = 2 E* a (5/6 + N / (6 N_H)), that is N = N_H - c delta^(1/4)
/// with a constant c, 0 before it first yields. It yields where that slope
/// reaches pi p_y R*. This keeps any path from gaining energy, however p_y
/// changes: d(lost)/d delta = N (1 - 1.2 R* pi p_y / (2 E* a) + 0.2 N / N_H) is
/// then never negative.
///
/// Sources: Thornton (1997), J. Appl. Mech. 64:383; Thornton & Ning (1998),
/// Powder Technol. 99:154. A p_y adjusted during loading: Sheng et al. (2004),
/// Eng. Comput. 21:304; loading too shallow for a higher p_y is not in them.
class AdjustedThorntonNing
{
public:
  /// F* [N] and the energy lost [J]; both 0 before the contact yields.
  static constexpr int more = 2;

  /// @param effective_modulus  E* [Pa]
  /// @param limiting_pressure  p_y now [Pa]
  AdjustedThorntonNing(double effective_modulus, double limiting_pressure)
      : effective_modulus_(effective_modulus),
        stiffness_(4.0 / 3 * effective_modulus),
        plastic_slope_(std::numbers::pi * limiting_pressure),
        yield_root_(plastic_slope_ / (2 * effective_modulus))
  {
  }

  /// Force and contact radius at an overlap.
  /// @param overlap  delta [m]; zero or negative gives zero force
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const V none(0.0);
    const State<V> now = state(overlap, pair, memory);
    const V dent = max(memory.more[0], now.beyond); // above 0 if there is one
    const V new_numbers[more] = {now.force, now.lost};
    for (int m = 0; m < more; ++m) {
      const V old = memory.more[m];
      memory.more[m] = select(overlap > memory.largest_overlap,
                              select(dent > none, new_numbers[m], old),
                              old);
    }
    memory.largest_overlap = max(memory.largest_overlap, overlap);
    return {now.force, now.contact_radius, none};
  }

  /// dN/d delta for further loading [N/m].
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       const NormalMemory<double> &memory) const
  {
    const State<double> now = state(overlap, pair, memory);
    const double elastic = 2 * effective_modulus_ * now.contact_radius;
    if (overlap < memory.largest_overlap || overlap <= 0)
      return elastic;
    if (overlap >= now.elastic_limit)
      return plastic_slope_ * pair.reduced_radius;
    return elastic *
           (5 + now.force / (stiffness_ * now.contact_radius * overlap)) / 6;
  }
  /// 2 E* a at the largest overlap, or where the contact would yield [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const
  {
    const double peak = max(memory.largest_overlap,
                            pair.reduced_radius * yield_root_ * yield_root_);
    return 2 * effective_modulus_ * sqrt(pair.reduced_radius * peak);
  }
  /// Whether the contact has yielded.
  bool is_plastic(const PairShape<double> &,
                  const NormalMemory<double> &memory) const
  {
    return memory.more[0] > 0;
  }

  /// Elastic energy 2/5 N (delta - delta_p), and what yielding has taken.
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      const NormalMemory<double> &memory) const
  {
    const State<double> now = state(overlap, pair, memory);
    return {0.4 * now.force * now.recovered, now.lost};
  }
  /// Nothing is lost as grains begin to touch or part.
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

private:
  template <class V>
  struct State {
    V force, contact_radius;
    V elastic_limit; // overlap above which the contact yields now
    V beyond;        // overlap above that
    V recovered;     // delta - delta_p
    V lost;          // energy
  };

  /// The contact at an overlap; what it remembers is of the largest overlap.
  template <class V>
  State<V> state(const V &overlap,
                 const PairShape<V> &pair,
                 const NormalMemory<V> &memory) const
  {
    const V none(0.0), least(tiny), k(stiffness_);
    const V radius = pair.reduced_radius, radius_root = sqrt(radius);
    const V delta = max(overlap, none), largest = memory.largest_overlap;
    const auto hertz = [&](const V &at) {
      return k * radius_root * at * sqrt(at);
    };

    // Loading beyond delta* that stores its work, and where it ends.
    const V hertz_force = hertz(largest);
    const V old_force =
        select(memory.more[0] > none, memory.more[0], hertz_force);
    const V old_fourth = sqrt(sqrt(largest)); // delta*^(1/4)
    const V c = (hertz_force - old_force) / max(old_fourth, least);
    const V limit = max(largest, elastic_limit(c, radius_root));
    const V stored = max(largest, min(delta, limit));
    const V stored_force = old_force + (hertz(stored) - hertz_force) -
                           c * (sqrt(sqrt(stored)) - old_fourth);

    // Yielding beyond, and unloading from there.
    const V beyond = max(none, delta - limit);
    const V peak_force = stored_force + V(plastic_slope_) * radius * beyond;
    const V peak_radius = radius_root * sqrt(stored + beyond);
    const V stored_recovered =
        stored_force / max(k * radius_root * sqrt(stored), least);
    const V peak_recovered = peak_force / max(k * peak_radius, least);
    const V taken = V(0.5) * (stored_force + peak_force) * beyond +
                    V(0.4) * (stored_force * stored_recovered -
                              peak_force * peak_recovered);
    const V rho = max(
        none, V(1.0) + min(none, delta - largest) / max(peak_recovered, least));
    const V share = select(overlap > none, sqrt(rho), none);
    return {peak_force * rho * share,
            peak_radius * share,
            limit,
            beyond,
            peak_recovered * rho,
            memory.more[1] + select(beyond > none, taken, none)};
  }

  /// Where the slope of loading that stores its work reaches pi p_y R*: with
  /// u = sqrt(delta), u - c u^(-3/2) / (8 E* sqrt(R*)) = a_y / sqrt(R*).
  /// Newton's steps from there stay below the root; the fourth is exact to
  /// rounding where it is above delta*, since it is then within 1.2 of the
  /// start.
  template <class V>
  V elastic_limit(const V &c, const V &radius_root) const
  {
    const V start = radius_root * V(yield_root_);
    const V scale =
        c / max(V(6 * stiffness_) * radius_root, V(tiny)); // 8 E* = 6 (4/3 E*)
    V u = start;
    for (int step = 0; step < 4; ++step) {
      const V missing = scale / max(u * sqrt(u), V(tiny));
      u = u +
          (start + missing - u) / (V(1.0) + V(1.5) * missing / max(u, V(tiny)));
    }
    return u * u;
  }

  double effective_modulus_; // E*
  double stiffness_;         // 4/3 E*
  double plastic_slope_;     // pi p_y
  double yield_root_;        // a over the curvature where p_y is reached
};
} // namespace tamp::dem

#endif
