// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_pair_path_h
#define dem_pair_path_h

#include <dem/laws/pair_laws.h>

#include <vector>

namespace tamp::dem
{
/// How the bodies of a pair moved since the memory of their contact was
/// written.
struct PairMotion {
  double overlap;               ///< now [m]
  Triple<double> slip{0, 0, 0}; ///< of the surfaces, second less first;
                                ///< its part along n is -d overlap [m]
  double spin = 0;              ///< rotation about n, the mean by radius [rad]
  Triple<double> rotation{0, 0, 0}; ///< of the first relative to the second
                                    ///< [rad]
  Triple<double> normal{0, 0, 1};   ///< n, from the first to the second
  double time = 0;                  ///< that it took [s]; 0: no damping
};

/// What the bodies of a pair do to each other.
struct PairForces {
  NormalAnswer<double> push{0, 0, 0}; ///< the normal contact with damping
  Triple<double> rub{0, 0, 0};        ///< tangential, on the first [N]
  Triple<double> moment{0, 0, 0};     ///< of rolling, on the first [N m]
};

/// Energy that a pair has lost for good, by its reason [J].
struct PairLosses {
  double plastic = 0;  ///< by yielding
  double friction = 0; ///< by sliding and rolling
  double damping = 0;  ///< in the dashpots
  double adhesion = 0; ///< in jumps of the force, at touch and tear
  double total() const { return plastic + friction + damping + adhesion; }
};

/// The contact of two bodies: laws, shape, and what it remembers. A value that
/// goes through the same laws in the same order as a contact in a unit cell.
class PairContact
{
public:
  /// Throws std::invalid_argument as check_size().
  PairContact(const PairLaws &laws, const PairShape<double> &shape);

  /// Goes on by one increment, and writes the memory.
  const PairForces &advance(const PairMotion &motion);

  const PairLaws &laws() const { return laws_; }
  const PairShape<double> &shape() const { return shape_; }
  const PairForces &forces() const { return forces_; }
  double overlap() const { return overlap_; }
  double contact_radius() const { return contact_radius_; }
  double largest_overlap() const { return largest_overlap_; }
  bool touches() const { return contact_radius_ > 0; }
  /// Whether the contact has yielded and still remembers it.
  bool plastic() const;
  /// Whether the tangential force is at the cap of friction.
  bool slides() const;
  /// Stored in the normal direction [J]; below zero where grains adhere.
  double elastic_energy() const;
  /// Stored in the tangential and the rolling spring [J].
  double spring_energy() const;
  PairLosses losses() const;

  /// A measure of the longest time step, sqrt(m* / (dN/d delta)), for a contact
  /// that gets as deep as `overlap` [s].
  double time_scale(double overlap) const;

private:
  NormalMemory<double> memory(std::vector<double> &more) const;
  NormalEnergy normal_energy() const;
  void push(double overlap);
  double damp_push(const PairMotion &motion);
  void rub(const PairMotion &motion);
  void damp_rub(const PairMotion &motion, double damping);
  void roll(const PairMotion &motion);

  PairLaws laws_;
  PairShape<double> shape_;
  PairForces forces_;
  NormalAnswer<double> elastic_push_{0, 0, 0}; // without damping
  // The memory of the contact.
  double overlap_ = 0, largest_overlap_ = 0, contact_radius_ = 0;
  double old_radius_ = 0; // before the last increment
  Triple<double> tangential_{0, 0, 0};
  std::vector<double> more_; // of the normal, tangential and rolling law
  PairLosses losses_;        // plastic: of contacts that are forgotten
};
} // namespace tamp::dem

#endif
