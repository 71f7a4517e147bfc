// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_friction_h
#define fem_friction_h

#include <fem/laws/density_table.h>

#include <deal.II/base/tensor.h>

#include <utility>

namespace tamp::fem
{
/// The friction coefficient between powder and a tool.
struct FrictionCoefficient {
  enum class Of { nothing, density, pressure };
  Of of = Of::nothing;
  /// A constant, or over the relative density [-] or contact pressure [Pa].
  DensityTable table;

  explicit FrictionCoefficient(double constant = 0) : table(constant) {}
  FrictionCoefficient(Of what, DensityTable values)
      : of(what), table(std::move(values))
  {
  }

  /// mu and its derivative by the contact pressure [1/Pa].
  /// @param density   relative, of the powder at the tool [-]
  /// @param pressure  of the contact [Pa]
  DensityTable::Reading at(double density, double pressure) const;
};

/// How a node meets a tool.
enum class ContactStatus { open, stick, slip, fading };

/// Friction of a node on a tool.
struct FrictionForce {
  ContactStatus status = ContactStatus::open;
  dealii::Tensor<1, 3> force; ///< of the tool on the powder, tangential [N]
};

/// Coulomb friction with elastic stick, integrated over an increment by return
/// mapping: the trial force is cut to the limit mu N along its direction.
/// @param trial  T_n - k s with T_n the friction at the start of the increment,
///               k the stiffness of the sticking contact and s the slip [N]
/// @param limit  mu N [N]
/// Source: P. Wriggers, Computational Contact Mechanics (2006), ch. 5.
inline FrictionForce coulomb_friction(const dealii::Tensor<1, 3> &trial,
                                      double limit)
{
  if (!(limit > 0))
    return {ContactStatus::slip, {}};
  const double size = trial.norm();
  if (size <= limit)
    return {ContactStatus::stick, trial};
  return {ContactStatus::slip, (limit / size) * trial};
}
} // namespace tamp::fem

#endif
