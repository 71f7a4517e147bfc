// SPDX-License-Identifier: BSD-3-Clause
#include <dem/sweep_layout.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
// Measured: the sweep is cheapest with near pairs up to a twentieth of a
// radius; the outer list then lasts for several increments.
constexpr double near_gap = 0.06, outer_skin = 0.3;
} // namespace

template <class T>
SweepLayout<T>::SweepLayout(const UnitCell &cell, InstructionSet set)
    : set_(set), laws_(cell), radius_(cell.radius),
      largest_radius_(cell.largest_radius()),
      gap_(near_gap * cell.mean_radius()),
      skin_(outer_skin * cell.mean_radius()), rows_(cell.size())
{
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = {};
    rows_[i].radius = T(radius_[i]);
    rows_[i].inverse_mass = T(1 / cell.mass(i));
  }
}

template <class T>
void SweepLayout<T>::list_pairs(UnitCell &cell,
                                const PeriodicBox &box,
                                std::span<const Vector3> place)
{
  if (!still_hold(cell.neighbours, box, place, largest_radius_, gap_))
    cell.neighbours = find_neighbours(box, place, radius_, skin_);
  find_near_pairs(cell.neighbours, box, place, radius_, gap_, near_);
  contacts_.lay_out(laws_, near_, radius_, cell.contacts, cell.more_memory);
  for (GrainRow<T> &row : rows_)
    std::ranges::fill(row.moved, T(0));
}

template <class T>
void SweepLayout<T>::read_memories(UnitCell &cell) const
{
  contacts_.read_memories(cell.contacts, cell.more_memory);
}

template <class T>
typename SweepLayout<T>::Stiffness SweepLayout<T>::stiffness() const
{
  constexpr std::size_t lanes = ContactBlock<T>::lanes;
  Stiffness sum{std::vector<double>(rows_.size(), 0.0),
                std::vector<double>(rows_.size(), 0.0),
                std::vector<double>(rows_.size(), 0.0)};
  std::vector<double> more(contacts_.more_per_contact());
  const auto add = [&](const auto &normal,
                       const auto &tangential,
                       double modulus,
                       std::size_t b,
                       std::size_t lane) {
    const ContactBlock<T> &block = contacts_.blocks()[b];
    const std::size_t i = block.first[lane], j = block.second[lane];
    const double overlap = block.overlap[lane];
    if (overlap <= 0 && block.contact_radius[lane] <= 0)
      return;
    const PairShape<double> shape = {block.radius_sum[lane],
                                     block.reduced_radius[lane],
                                     double(rows_[j].radius - rows_[i].radius),
                                     0};
    for (std::size_t m = 0; m < more.size(); ++m)
      more[m] = double(contacts_.more()[(b * more.size() + m) * lanes + lane]);
    const NormalMemory<double> memory = {
        std::max(overlap, double(block.largest_overlap[lane])),
        block.contact_radius[lane],
        more.data()};
    const double kn = normal.steepest_slope(shape, memory);
    const double kt = tangential.stiffness(kn / (2 * modulus));
    sum.largest = std::max(sum.largest, kn + kt);
    for (std::size_t grain : {i, j}) {
      sum.both[grain] += kn + kt;
      sum.tangential[grain] += kt;
      ++sum.contacts[grain];
    }
  };
  for (const auto &group : contacts_.groups()) {
    const PairLaws &laws = laws_.of_kind(group.kind);
    std::visit(
        [&](const auto &normal, const auto &tangential) {
          for (std::size_t b = 0; b < group.blocks; ++b)
            for (std::size_t l = 0; l < lanes; ++l)
              add(normal,
                  tangential,
                  laws.effective_modulus,
                  group.first_block + b,
                  l);
        },
        laws.normal,
        laws.tangential);
  }
  return sum;
}

template class SweepLayout<double>;
template class SweepLayout<float>;
} // namespace tamp::dem
