// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_sweep_layout_h
#define dem_sweep_layout_h

#include <dem/contacts.h>
#include <dem/grains.h>
#include <dem/kernel/sweep.h>
#include <dem/unit_cell.h>

#include <span>
#include <vector>

namespace tamp::dem
{
/// A unit cell laid out for sweeping: grains as rows, near pairs as blocks.
/// Lives as long as one increment; what must survive goes back into the cell.
class SweepLayout
{
public:
  /// Lays out the cell with its memory. Rows are at the cell's places and at
  /// rest; no pairs yet.
  explicit SweepLayout(const UnitCell &cell);

  /// Lists the near pairs at `place` in `box`, renewing the outer list in
  /// `neighbours` if it no longer holds, and gives them the memories.
  void list_pairs(Neighbours &neighbours,
                  const PeriodicBox &box,
                  std::span<const Vector3> place,
                  std::span<const ContactMemory> memories);

  /// How far a pair outside the blocks may approach before list_pairs() is due
  /// [m].
  double gap() const { return gap_; }

  SweepTotals sweep(const AffineMotion &affine, Memory memory);

  std::span<GrainRow> rows() { return rows_; }
  std::span<const GrainRow> rows() const { return rows_; }
  const ContactBlocks &contacts() const { return contacts_; }

  /// For every grain the sum of k_n + k_t of its touching contacts and the sum
  /// of k_t alone [N/m]; k_n is that of an unloading from the largest overlap.
  struct Stiffness {
    std::vector<double> both, tangential;
    double largest = 0; ///< of one contact [N/m]
  };
  Stiffness stiffness(const PeriodicBox &box) const;

private:
  ContactModel model_;
  GrainMaterial material_;
  std::vector<double> radius_;
  double gap_, skin_;
  GrainRows rows_;
  ContactBlocks contacts_;
  Sweep frozen_, written_;
};
} // namespace tamp::dem

#endif
