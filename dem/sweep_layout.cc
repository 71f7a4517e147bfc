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
    rows_[i].motion[3] = T(radius_[i]);
    rows_[i].motion[7] = T(1 / cell.mass(i));
  }
}

template <class T>
void SweepLayout<T>::list_pairs(UnitCell &cell,
                                const PeriodicBox &box,
                                std::span<const Vector3> place,
                                const Matrix3 &stretch)
{
  if (!still_hold(cell.neighbours, box, place, largest_radius_, gap_))
    cell.neighbours = find_neighbours(box, place, radius_, skin_, set_);
  find_near_pairs(cell.neighbours, box, place, radius_, gap_, near_, set_);
  contacts_.lay_out(
      laws_, near_, radius_, rows_, stretch, cell.contacts, cell.more_memory);
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
                       std::size_t lane,
                       const NearPair &near) {
    const ContactBlock<T> &block = contacts_.blocks()[b];
    if (near.overlap <= 0 && block.contact_radius[lane] <= 0)
      return;
    const auto [i, j] = near.pair;
    const PairShape<double> shape = {block.radius_sum[lane],
                                     block.reduced_radius[lane],
                                     radius_[j] - radius_[i],
                                     0};
    for (std::size_t m = 0; m < more.size(); ++m)
      more[m] = double(contacts_.more()[(b * more.size() + m) * lanes + lane]);
    const NormalMemory<double> memory = {
        std::max(near.overlap, double(block.largest_overlap[lane])),
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
  contacts_.for_each(
      laws_, near_, [&](std::size_t b, std::size_t lane, const NearPair &near) {
        const PairLaws &laws = laws_.of_kind(laws_.kind(near.pair));
        std::visit(
            [&](const auto &normal, const auto &tangential) {
              add(normal, tangential, laws.effective_modulus, b, lane, near);
            },
            laws.normal,
            laws.tangential);
      });
  return sum;
}

template class SweepLayout<double>;
template class SweepLayout<float>;
} // namespace tamp::dem
