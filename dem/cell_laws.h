// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_cell_laws_h
#define dem_cell_laws_h

#include <dem/contacts.h>
#include <dem/laws/pair_laws.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tamp::dem
{
class UnitCell;

/// The laws of all kinds of pairs in a cell as it is now: with S materials
/// there are S (S + 1) / 2 kinds. A limiting contact pressure that is adjusted
/// to the density is that of the density of now.
class CellLaws
{
public:
  explicit CellLaws(const UnitCell &cell);

  /// Throws std::invalid_argument if the laws of a kind do not hold for its
  /// smallest grains, see check_size(), or if a limiting contact pressure is
  /// adjusted that the law takes for constant.
  void check(const UnitCell &cell) const;

  std::size_t kinds() const { return laws_.size(); }
  const PairLaws &of_kind(std::size_t kind) const { return laws_[kind]; }

  /// Which kind a pair of grains is.
  std::size_t kind(Pair pair) const
  {
    if (species_.empty())
      return 0;
    const std::size_t a = species_[pair.first], b = species_[pair.second];
    return a < b ? b * (b + 1) / 2 + a : a * (a + 1) / 2 + b;
  }
  const PairLaws &of(Pair pair) const { return laws_[kind(pair)]; }

  /// Numbers of their own that the laws keep per contact, the same for all
  /// kinds.
  std::size_t more() const { return laws_[0].more(); }

private:
  std::vector<PairLaws> laws_;
  std::vector<std::uint8_t> species_;
};
/// The smallest radius of the grains of each material of a cell; infinite for a
/// material without any [m].
std::vector<double> smallest_radii(const UnitCell &cell);
} // namespace tamp::dem

#endif
