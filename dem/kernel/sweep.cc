// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/kernel.h>
#include <dem/kernel/sweep.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
const void *address_of(const auto &law)
{
  return std::visit([](const auto &l) { return static_cast<const void *>(&l); },
                    law);
}

/// Where memory goes that nobody wants.
template <class T>
struct Scratch {
  static constexpr std::size_t most_more = 32;
  ContactBlock<T> blocks[Chunk<T>::blocks];
  alignas(64) T more[most_more * Chunk<T>::size];
};

template <class T>
AffineLanes<T> lanes_of(const AffineMotion &affine)
{
  AffineLanes<T> result;
  const Matrix3 growth = affine.stretch - Matrix3::Identity();
  for (int k = 0; k < 9; ++k)
    result.growth[k] = T(growth(k / 3, k % 3));
  result.rate = affine.time > 0 ? T(1 / affine.time) : T(0);
  return result;
}

/// Takes the chunks of one kind of pairs through the loops.
template <class T>
class Passage
{
public:
  Passage(const KernelLoops<T> &loops,
          const PairLaws &laws,
          const AffineLanes<T> &affine,
          SweepRequest request,
          GrainRow<T> *rows)
      : loops_(loops), laws_(laws), affine_(affine), request_(request),
        rows_(rows), normal_(address_of(laws.normal)),
        tangential_(address_of(laws.tangential)),
        damped_(laws.viscous && affine.rate > 0),
        gather_(damped_ || std::holds_alternative<Mdr>(laws.normal)
                    ? loops.gather_with_grains
                    : loops.gather),
        push_(loops.normal[laws.normal.index()]),
        rub_(request.memory == Memory::frozen
                 ? loops.tangential[laws.tangential.index()]
                 : loops.booked_tangential[laws.tangential.index()]),
        normal_rows_(laws.normal_more()),
        rolling_rows_(normal_rows_ + laws.tangential_more())
  {
  }

  void run(const ChunkOfBlocks<T> &contacts, double (&moment)[9])
  {
    KernelTotals<T> part;
    gather_(rows_, affine_, contacts, chunk_);
    push_(normal_, contacts, chunk_, part);
    if (damped_)
      loops_.damp_push(*laws_.viscous, affine_.rate, contacts, chunk_, part);
    rub_(tangential_, contacts.past(normal_rows_), chunk_, part);
    if (damped_)
      loops_.damp_rub[laws_.tangential.index()](
          tangential_, *laws_.viscous, affine_.rate, contacts, chunk_, part);
    (damped_ ? loops_.scatter_damped : loops_.scatter)(contacts, chunk_, rows_);
    if (laws_.rolling)
      loops_.roll(
          *laws_.rolling, contacts.past(rolling_rows_), chunk_, rows_, part);
    if (request_.moment)
      (damped_ ? loops_.stress_damped
               : loops_.stress)(contacts, chunk_, moment);
    totals_.normal_force += double(part.normal_force);
    totals_.contacts += std::size_t(part.contacts);
    totals_.too_deep = totals_.too_deep || part.beyond > 0;
    totals_.lost_work += double(part.lost_work);
    totals_.damped_work += double(part.damped_work);
    totals_.adhesion_loss += double(part.adhesion_loss);
    totals_.forgotten_loss += double(part.forgotten_loss);
  }
  const SweepTotals &totals() const { return totals_; }

private:
  const KernelLoops<T> &loops_;
  const PairLaws &laws_;
  const AffineLanes<T> &affine_;
  SweepRequest request_;
  GrainRow<T> *rows_;
  const void *normal_, *tangential_;
  bool damped_;
  typename KernelLoops<T>::Gather gather_;
  typename KernelLoops<T>::Law push_, rub_;
  std::size_t normal_rows_, rolling_rows_;
  Chunk<T> chunk_;
  SweepTotals totals_;
};

void add(SweepTotals &sum, const SweepTotals &part)
{
  sum.normal_force += part.normal_force;
  sum.contacts += part.contacts;
  sum.too_deep = sum.too_deep || part.too_deep;
  sum.lost_work += part.lost_work;
  sum.damped_work += part.damped_work;
  sum.adhesion_loss += part.adhesion_loss;
  sum.forgotten_loss += part.forgotten_loss;
}
} // namespace

template <class T>
SweepTotals sweep(InstructionSet set,
                  const CellLaws &laws,
                  const AffineMotion &affine,
                  SweepRequest request,
                  GrainRows<T> &rows,
                  ContactBlocks<T> &contacts)
{
  constexpr std::size_t lanes = ContactBlock<T>::lanes;
  const AffineLanes<T> motion = lanes_of<T>(affine);
  const std::size_t more_rows = contacts.more_per_contact();
  const bool frozen = request.memory == Memory::frozen;
  Scratch<T> scratch;
  double moment[9] = {};
  SweepTotals totals;
  if (!request.forces_taken)
    for (GrainRow<T> &row : rows)
      std::fill_n(row.force, 8, T(0));
  for (const auto &group : contacts.groups()) {
    Passage<T> passage(kernel_of(set).loops<T>(),
                       laws.of_kind(group.kind),
                       motion,
                       request,
                       rows.data());
    for (std::size_t b = 0; b < group.blocks; b += Chunk<T>::blocks) {
      const std::size_t at = group.first_block + b;
      ContactBlock<T> *const memory = contacts.blocks().data() + at;
      T *const more = contacts.more().data() + at * more_rows * lanes;
      passage.run({std::min(Chunk<T>::blocks, group.blocks - b),
                   memory,
                   frozen ? scratch.blocks : memory,
                   more,
                   frozen ? scratch.more : more,
                   more_rows},
                  moment);
    }
    add(totals, passage.totals());
  }
  for (int k = 0; k < 9; ++k)
    totals.moment(k / 3, k % 3) = moment[k];
  return totals;
}

template SweepTotals sweep(InstructionSet,
                           const CellLaws &,
                           const AffineMotion &,
                           SweepRequest,
                           GrainRows<double> &,
                           ContactBlocks<double> &);
template SweepTotals sweep(InstructionSet,
                           const CellLaws &,
                           const AffineMotion &,
                           SweepRequest,
                           GrainRows<float> &,
                           ContactBlocks<float> &);
} // namespace tamp::dem
