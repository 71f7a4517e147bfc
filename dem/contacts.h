// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_contacts_h
#define dem_contacts_h

#include <dem/tensors.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tamp::dem
{
/// Two grains, first < second.
struct Pair {
  std::uint32_t first, second;
  auto operator<=>(const Pair &) const = default;
};

/// What a contact remembers.
struct ContactMemory {
  Pair pair;
  Vector3 tangential_force = Vector3::Zero(); ///< on the first grain [N]
  double largest_overlap = 0;                 ///< ever [m]
  double contact_radius = 0;                  ///< at the last commit [m]
  bool operator==(const ContactMemory &) const = default;
};

/// Eight pairs as the sweep sees them: what is constant, then the memory.
struct alignas(64) ContactBlock {
  static constexpr std::size_t lanes = 8;
  std::uint32_t first[lanes], second[lanes];
  double radius_sum[lanes];     ///< R_i + R_j [m]; of a padding lane -1
  double reduced_radius[lanes]; ///< R* [m]
  double force_x[lanes], force_y[lanes], force_z[lanes]; ///< tangential [N]
  double largest_overlap[lanes];                         ///< [m]
  double contact_radius[lanes];                          ///< [m]
};
static_assert(sizeof(ContactBlock) == 512);

/// The pairs that a sweep visits, in blocks. With n blocks, lane l of block b
/// holds pair l n + b of the sorted list: neighbouring pairs of one grain never
/// share a block.
class ContactBlocks
{
public:
  /// Lays out `pairs` (sorted) with the memories of those that have one
  /// (sorted, too; memories of other pairs are left out).
  void lay_out(std::span<const Pair> pairs,
               std::span<const ContactMemory> memories,
               std::span<const double> radius);

  /// The memories of all pairs with a contact radius or an overlap behind
  /// them, sorted.
  std::vector<ContactMemory> memories() const;

  std::span<ContactBlock> blocks() { return blocks_; }
  std::span<const ContactBlock> blocks() const { return blocks_; }
  std::size_t size() const { return size_; }

private:
  std::vector<ContactBlock> blocks_;
  std::size_t size_ = 0;
};
} // namespace tamp::dem

#endif
