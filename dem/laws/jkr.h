// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_jkr_h
#define dem_laws_jkr_h

#include <dem/laws/jkr_radius.h>
#include <dem/laws/pair_law.h>

#include <numbers>

namespace tamp::dem
{
/// Two elastic spheres that adhere. With s = sqrt(a) and
/// c = sqrt(2 pi Gamma / E*): delta = s^4/R* - c s,
/// N = s^3 (4 E* s^3 / (3 R*) - 2 E* c), on the branch of the larger root.
///
/// The overlap decides: grains begin to touch above delta = 0, where N jumps to
/// -8/9 N_c, and once they touch, they part at delta_f < 0, where N jumps back
/// from -5/9 N_c. Nothing else is remembered.
/// Source: Johnson, Kendall & Roberts (1971), Proc. R. Soc. A 324:301.
class Jkr
{
public:
  static constexpr int more = 0; ///< numbers of its own in the memory

  /// @param effective_modulus  E* [Pa]
  /// @param work_of_adhesion   Gamma, of the interface (twice the surface
  ///                           energy of equal solids) [J/m2]; zero gives
  ///                           Hertz's law
  Jkr(double effective_modulus, double work_of_adhesion)
      : effective_modulus_(effective_modulus),
        pull_off_(1.5 * std::numbers::pi * work_of_adhesion)
  {
    // The scale of the roots must not vanish: far below anything that tells.
    constexpr double smallest_length = 1e-33; // Gamma / E* [m]
    const double length =
        std::numbers::pi *
        max(work_of_adhesion / effective_modulus, smallest_length);
    suction_ = std::sqrt(2 * length);
    root_scale_ = std::cbrt(0.25 * suction_ * middle_radius);
    depth_scale_ = 4.0 / 3 / std::cbrt(length * length);
  }

  /// N_c = 3/2 pi Gamma R* [N].
  template <class V>
  V pull_off(const V &radius) const
  {
    return V(pull_off_) * radius;
  }
  /// c [m^(1/2)].
  double suction() const { return suction_; }
  /// About sqrt(a_f) = (c R* / 4)^(1/3), that of the tear-off [m^(1/2)].
  template <class V>
  V root_scale(const V &radius) const
  {
    return V(root_scale_) * quick_cube_root(radius * V(1 / middle_radius));
  }
  /// c R* / scale^3, near 4.
  template <class V>
  V pull(const V &radius, const V &scale) const
  {
    const V inverse = V(1.0) / scale;
    return V(suction_) * radius * inverse * (inverse * inverse);
  }
  /// s at an overlap from delta_f up [m^(1/2)].
  /// @param scale  root_scale(radius), to some digits
  template <class V>
  V root(const V &overlap, const V &radius, const V &scale) const
  {
    const V over = V(1.0) / (scale * scale);
    return scale *
           jkr_root(pull(radius, scale), (overlap * over) * (radius * over));
  }
  /// delta at s [m].
  template <class V>
  V overlap(const V &root, const V &radius) const
  {
    const V square = root * root;
    return square * square / radius - V(suction_) * root;
  }
  /// N at s [N].
  template <class V>
  V force(const V &root, const V &radius) const
  {
    const V cube = root * root * root;
    return V(effective_modulus_) * cube *
           (V(4.0 / 3) * cube / radius - V(2 * suction_));
  }
  /// Above zero while the overlap is above -depth, the one that tears off.
  /// @param depth  how far the grains are apart, at least 0 [m]
  template <class V>
  V hold(const V &depth, const V &radius) const
  {
    const V scaled = V(depth_scale_) * depth;
    return radius - scaled * scaled * scaled;
  }

  /// Force and contact radius at an overlap.
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const V none(0.0), radius = pair.reduced_radius;
    memory.largest_overlap = max(memory.largest_overlap, overlap);
    const V s = root(overlap, radius, root_scale(radius));
    const V grip = select(memory.contact_radius > none,
                          hold(max(none, none - overlap), radius),
                          overlap);
    return {select(grip > none, force(s, radius), none),
            select(grip > none, s * s, none),
            select(grip > none, pull_off(radius), none)};
  }

  /// dN/d delta, 2 E* a (4 s^3 - 3 c R*)/(4 s^3 - c R*) [N/m]: below zero from
  /// the pull-off down, without bound towards the tear-off; cut off there.
  double slope(double contact_radius, double radius) const
  {
    const double cube = 4 * contact_radius * std::sqrt(contact_radius);
    const double suck = suction_ * radius;
    return 2 * effective_modulus_ * contact_radius * (cube - 3 * suck) /
           max(cube - suck, 1e-6 * suck);
  }
  /// dN/d delta for further loading [N/m]; 0 where the grains do not touch.
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       NormalMemory<double> memory) const
  {
    return slope((*this)(overlap, pair, memory).contact_radius,
                 pair.reduced_radius);
  }
  /// A bound on dN/d delta up to the largest overlap: 2 E* a there [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const
  {
    const double radius = pair.reduced_radius;
    const double s = root(memory.largest_overlap, radius, root_scale(radius));
    return 2 * effective_modulus_ * s * s;
  }
  bool is_plastic(const PairShape<double> &, const NormalMemory<double> &) const
  {
    return false;
  }

  /// Elastic energy, and -Gamma pi a^2 of the joined surfaces [J].
  double stored(double contact_radius, double radius) const
  {
    const double a = contact_radius, s = std::sqrt(a);
    return effective_modulus_ * a * a *
           (8.0 / 15 * a * a * a / (radius * radius) -
            4.0 / 3 * suction_ * a * s / radius + 0.5 * suction_ * suction_);
  }
  /// What is stored; nothing is lost to plasticity.
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      NormalMemory<double> memory) const
  {
    return {stored((*this)(overlap, pair, memory).contact_radius,
                   pair.reduced_radius),
            0};
  }
  /// Energy that grains lose as they begin to touch [J].
  double lost_at_touch(const PairShape<double> &pair,
                       const NormalMemory<double> &) const
  {
    const double radius = pair.reduced_radius; // a_0^(3/2) = c R*
    return -stored(std::pow(suction_ * radius, 2.0 / 3), radius);
  }
  /// Energy that grains lose as they tear off; with lost_at_touch it is
  /// W_s = 7.092 (Gamma^5 R*^4 / E*^2)^(1/3) [J].
  double lost_at_tear(const PairShape<double> &pair,
                      const NormalMemory<double> &) const
  {
    const double radius = pair.reduced_radius; // a_f^(3/2) = c R* / 4
    return stored(std::pow(0.25 * suction_ * radius, 2.0 / 3), radius);
  }

private:
  static constexpr double middle_radius = 1e-3; // [m]; quick_cube_root is best here

  double effective_modulus_; // E*
  double pull_off_;          // 3/2 pi Gamma
  double suction_;           // c
  double root_scale_;        // of the middle radius
  double depth_scale_;       // -delta_f = R*^(1/3) / this
};
} // namespace tamp::dem

#endif
