// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_sweep_layout_h
#define dem_sweep_layout_h

#include <dem/contact_blocks.h>
#include <dem/grains.h>
#include <dem/kernel/sweep.h>
#include <dem/unit_cell.h>

#include <span>
#include <vector>

namespace tamp::dem
{
/// A unit cell laid out for sweeping in the precision of T, double or float:
/// grains as rows, near pairs as blocks. Lives as long as one increment; what
/// must survive goes back into the cell.
template <class T>
class SweepLayout
{
public:
  /// Rows are at rest; no pairs yet.
  SweepLayout(const UnitCell &cell, InstructionSet set);

  /// Lists the near pairs at `place` in `box`, renewing the outer list of the
  /// cell if it no longer holds, and gives them the memories of the cell. The
  /// grains came there since these were written by `stretch` and the motion in
  /// the rows.
  void list_pairs(UnitCell &cell,
                  const PeriodicBox &box,
                  std::span<const Vector3> place,
                  const Matrix3 &stretch = Matrix3::Identity());

  /// Writes the memory of the contacts into the cell.
  void read_memories(UnitCell &cell) const;

  /// How far a pair outside the blocks may approach before list_pairs() is due
  /// [m].
  double gap() const { return gap_; }

  SweepTotals sweep(const AffineMotion &affine, SweepRequest request)
  {
    return dem::sweep(set_, laws_, affine, request, rows_, contacts_);
  }

  std::span<GrainRow<T>> rows() { return rows_; }
  std::span<const GrainRow<T>> rows() const { return rows_; }
  const ContactBlocks<T> &contacts() const { return contacts_; }

  /// For every grain the sum of k_n + k_t of its touching contacts and the sum
  /// of k_t alone [N/m], as the pairs were listed; k_n is that of an unloading
  /// from the largest overlap.
  struct Stiffness {
    std::vector<double> both, tangential;
    std::vector<double> contacts; ///< how many touch
    double largest = 0;           ///< of one contact [N/m]
  };
  Stiffness stiffness() const;

private:
  InstructionSet set_;
  CellLaws laws_;
  std::vector<double> radius_;
  double largest_radius_, gap_, skin_;
  GrainRows<T> rows_;
  std::vector<NearPair> near_;
  ContactBlocks<T> contacts_;
};
} // namespace tamp::dem

#endif
