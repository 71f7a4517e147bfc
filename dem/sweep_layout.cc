// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/law_choice.h>
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

SweepLayout::SweepLayout(const UnitCell &cell)
    : model_(cell.contact), material_(cell.material), radius_(cell.radius),
      gap_(near_gap * cell.mean_radius()),
      skin_(outer_skin * cell.mean_radius()), rows_(cell.size()),
      frozen_(choose_sweep(cell.contact, Memory::frozen)),
      written_(choose_sweep(cell.contact, Memory::written))
{
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = GrainRow{};
    std::copy_n(cell.place[i].data(), 3, rows_[i].place);
    rows_[i].inverse_radius = 1 / radius_[i];
  }
}

void SweepLayout::list_pairs(Neighbours &neighbours,
                             const PeriodicBox &box,
                             std::span<const Vector3> place,
                             std::span<const ContactMemory> memories)
{
  if (!still_hold(
          neighbours, box, place, *std::ranges::max_element(radius_), gap_))
    neighbours = find_neighbours(box, place, radius_, skin_);
  const std::vector<Pair> pairs =
      near_pairs(neighbours, box, place, radius_, gap_);
  contacts_.lay_out(pairs, memories, radius_);
}

SweepTotals SweepLayout::sweep(const AffineMotion &affine, Memory memory)
{
  const Sweep run = memory == Memory::frozen ? frozen_ : written_;
  return run(model_, material_, affine, rows_, contacts_.blocks());
}

SweepLayout::Stiffness SweepLayout::stiffness(const PeriodicBox &box) const
{
  Stiffness sum{std::vector<double>(rows_.size(), 0.0),
                std::vector<double>(rows_.size(), 0.0)};
  const double modulus = material_.effective_modulus();
  with_normal_law(model_, material_, [&](const auto &normal) {
    with_tangential_law(model_, material_, [&](const auto &tangential) {
      for (const ContactBlock &block : contacts_.blocks())
        for (std::size_t lane = 0; lane < ContactBlock::lanes; ++lane) {
          const std::size_t i = block.first[lane], j = block.second[lane];
          const Vector3 a(rows_[i].place), b(rows_[j].place);
          const double overlap =
              block.radius_sum[lane] - box.nearest_image(b - a).norm();
          if (block.radius_sum[lane] <= 0 || overlap <= 0)
            continue;
          const double kn = normal.steepest_slope(
              block.reduced_radius[lane],
              std::max(overlap, block.largest_overlap[lane]));
          const double kt = tangential.stiffness(kn / (2 * modulus));
          sum.largest = std::max(sum.largest, kn + kt);
          for (std::size_t grain : {i, j}) {
            sum.both[grain] += kn + kt;
            sum.tangential[grain] += kt;
          }
        }
    });
  });
  return sum;
}
} // namespace tamp::dem
