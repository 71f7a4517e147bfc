// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_mixed_control_h
#define dem_mixed_control_h

#include <dem/deform.h>
#include <dem/tensors.h>

#include <array>
#include <cstddef>

namespace tamp::dem
{
class UnitCell;

/// What one component of the tensors does during an increment.
struct ComponentControl {
  enum class Kind { strain, stress } kind = Kind::strain;
  /// Strain: its increment, tension positive, tensor component [-].
  /// Stress: Cauchy stress at the end, tension positive [Pa].
  double value = 0;
};

/// An increment in which every component is either strained or stressed.
struct MixedControl {
  /// xx, yy, zz, yz, xz, xy
  std::array<ComponentControl, 6> components;
  /// A stress may miss by this share of the largest |target| or the mean
  /// pressure, whichever is larger [-].
  double accuracy = 5e-3;
  std::size_t most_trials = 40; ///< of the map
  /// Dynamics: mean |F| of grains / mean |f| at the end [-].
  double unbalance = 5e-3;
  std::size_t most_steps = 2000000; ///< of dynamics

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

struct MixedAnswer {
  /// The increment: the prescribed components to the last bit, and those that
  /// were found [-].
  Matrix3 strain = Matrix3::Zero();
  Stretch stretch = Stretch::Identity(); ///< exp(strain)
  CellAnswer cell; ///< `unsettled` if a stress missed its target, too
};

/// Takes a cell along an increment of mixed control [Sheng et al. (2004), eqs
/// (7) and (8), for each component of its own].
/// The map searches the free strains by Newton's method from the committed
/// cell, with Voigt's tangent improved by Broyden's updates; the box is then
/// stretched by exp(strain). Dynamics strains the prescribed components at the
/// strain rate while servos move the others, and then waits for the servos; the
/// strain is that of all small stretches, summed up.
/// After `diverged` the map leaves the cell as it was.
/// Source of the updates: Broyden (1965), Math. Comput. 19:577.
MixedAnswer deform_mixed(UnitCell &cell,
                         const MixedControl &control,
                         const Driving &driving);
} // namespace tamp::dem

#endif
