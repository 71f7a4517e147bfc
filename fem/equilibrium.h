// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_equilibrium_h
#define fem_equilibrium_h

#include <fem/opening.h>
#include <fem/press.h>

#include <cstddef>
#include <string>

namespace tamp::fem
{
/// What became of an attempt to find equilibrium.
struct Attempt {
  bool converged = false;
  bool stagnated = false;  ///< converged to less than was asked, see below
  std::string reason;      ///< why not
  bool opened = false;     ///< refused because a material point opens
  std::size_t point = 0;   ///< where it went wrong, or the residual is largest
  unsigned iterations = 0; ///< evaluations of all points
  double force_residual = 0;      ///< / reactions [-]
  double displacement_change = 0; ///< / largest of a usual step [-]
  std::size_t doubtful_points = 0;
  /// Powder that bears less, a small share of its mean bulk modulus, may give
  /// way for good as it is pressed; known if openings are watched [Pa].
  double loose_pressure = 0;
  ToolForces forces; ///< of the mesh's part of the compact
};

/// Finds the increment that balances powder and tools. Two ways:
/// Newton's method on powder and contact together, with a new matrix every
/// iteration, for materials that answer at once; and, for those whose answers
/// are dear, one matrix a step: every iteration evaluates the points once,
/// balances their linearised forces with the tools at no material cost, and is
/// accelerated after Anderson. Answers of grains are not smooth: they slip or
/// give way between one trial and the next. Where no update gets nearer, the
/// nearest state is taken, and said to be, if its forces and the work of what
/// is unbalanced are within ten times the tolerance.
class Equilibrium
{
public:
  /// @param press  must outlive the object. @param largest_increment  of a
  /// point's deformation in a step; an iteration that goes further is shortened
  /// [-].
  Equilibrium(Press &press,
              const SolverSettings &settings,
              double largest_increment);

  /// Searches equilibrium for this motion of the tools from the accepted state
  /// on. Changes nothing accepted. @param guess  of the increment; what the
  /// tools prescribe is put in.
  [[nodiscard]] Attempt attempt(const Motion &motion, const Increment &guess);

  /// Refuses the last attempt, which must have converged, if a material point
  /// opens: then it has not converged. Collective.
  void refuse_opening(const OpeningLimits &limits, Attempt &attempt) const;

  /// Makes the last attempt, which must have converged, the accepted state.
  void accept() { press_.accept(); }

  /// Increment of the last attempt [m].
  const Increment &increment() const { return increment_; }

private:
  void search_newton(Attempt &attempt);
  void search_accelerated(Attempt &attempt);
  void settle_for(const Increment &nearest, Attempt &attempt);
  std::vector<double> measure(Attempt &attempt) const;
  std::vector<double> judge(Attempt &attempt);
  double relative_change(const std::vector<double> &change) const;
  bool good(const Attempt &attempt, double tolerances = 1) const;
  bool fails(const Fault &fault, Attempt &attempt) const;
  double loose_pressure() const;
  void shorten(const Increment &from, Increment &to) const;
  std::size_t point_of_largest(const std::vector<double> &imbalance) const;

  Press &press_;
  SolverSettings settings_;
  double largest_increment_;
  double height_; ///< of the compact at the start [m]
  Increment increment_;
};
} // namespace tamp::fem

#endif
