// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_moving_cell_h
#define tests_dem_moving_cell_h

#include <dem/random_numbers.h>
#include <dem/sweep_layout.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tamp::dem::test
{
/// How the grains of a cell and its affine field moved.
struct SmallMotion {
  AffineMotion affine;
  std::vector<Vector3> relative; ///< since the memory was written [m]
  std::vector<Vector3> rolled;   ///< radius x rotation [m]
};

/// Grains at rest.
SmallMotion no_motion(std::size_t grains);

/// Every component up to `size` [m] at random, the box stretched by that order
/// over `length` [m].
SmallMotion random_motion(std::size_t grains,
                          std::uint64_t seed,
                          double size,
                          double length);

/// Forces and torques of a sweep, in double precision.
struct Forces {
  std::vector<Vector3> force;  ///< [N]
  std::vector<Vector3> torque; ///< over radius [N]
  SweepTotals totals;
};

/// A cell laid out for sweeping in the precision of T, its pairs listed.
template <class T>
struct LaidOut {
  UnitCell cell;
  SweepLayout<T> layout;

  LaidOut(const UnitCell &from, InstructionSet set)
      : cell(from), layout(cell, set)
  {
    layout.list_pairs(cell, cell.box, cell.place);
  }

  void move(const SmallMotion &motion)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        GrainRow<T> &row = layout.rows()[i];
        row.motion[k] = T(motion.relative[i][k]);
        row.motion[4 + k] = T(motion.rolled[i][k]);
      }
  }

  Forces sweep(const SmallMotion &motion, Memory memory)
  {
    move(motion);
    Forces result;
    result.totals = layout.sweep(motion.affine, {memory, true});
    for (const GrainRow<T> &row : layout.rows()) {
      result.force.emplace_back(row.force[0], row.force[1], row.force[2]);
      result.torque.emplace_back(row.force[4], row.force[5], row.force[6]);
    }
    return result;
  }

  /// The cell with the memories after the last sweep that wrote them.
  UnitCell remembering() const
  {
    UnitCell copy = cell;
    layout.read_memories(copy);
    return copy;
  }

  /// The memories after the last sweep that wrote them, sorted.
  std::vector<ContactMemory> memories() const { return remembering().contacts; }
};

/// The cell with a history of its own contact model: its grains have moved
/// twice at random, up to `size` [m], and are back in place.
UnitCell with_history(UnitCell cell, const ContactModel &contact, double size);

/// Forces and torques straight from the textbook: every pair, every image, and
/// the memories that are left.
struct Oracle : Forces {
  std::vector<ContactMemory> memories;
};

/// The cell before it moved; `motion` as in a sweep.
Oracle by_hand(const UnitCell &cell, const SmallMotion &motion);

double largest(std::span<const Vector3> values);
double largest_difference(std::span<const Vector3> a,
                          std::span<const Vector3> b);
} // namespace tamp::dem::test

#endif
