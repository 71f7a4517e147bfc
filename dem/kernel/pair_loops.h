// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_pair_loops_h
#define dem_kernel_pair_loops_h

#include <dem/kernel/near_pairs.h>
#include <dem/kernel/pack.h>

#include <cstddef>
#include <cstdint>

// The loops that look for near pairs, for the instruction set that the file
// including this is compiled for.
namespace tamp::dem::HWY_NAMESPACE
{
/// Nearest images in a box, sums in the order of PeriodicBox::nearest_image().
class NearestImages
{
public:
  using P = Pack<double>;
  struct Branch {
    P x, y, z; ///< [m]
    P square() const { return x * x + y * y + z * z; }
  };

  explicit NearestImages(const PairSearch &search)
  {
    for (int k = 0; k < 9; ++k)
      h_[k] = P(search.box[k]);
  }
  /// For differences of fractional coordinates.
  Branch of(P x, P y, P z) const
  {
    x -= P(hn::Round(x.lanes));
    y -= P(hn::Round(y.lanes));
    z -= P(hn::Round(z.lanes));
    return {h_[0] * x + h_[1] * y + h_[2] * z,
            h_[3] * x + h_[4] * y + h_[5] * z,
            h_[6] * x + (h_[7] * y + h_[8] * z)};
  }

private:
  P h_[9];
};

/// Pairs on their way through the filter.
struct PairChunk {
  static constexpr std::size_t size = 64;
  alignas(64) double x[size], y[size], z[size]; ///< difference, then branch
  alignas(64) double radius_sum[size];          ///< then overlap [m]
  alignas(64) double excess[size];              ///< below zero: near [m2]
};

inline void fetch(const Pair *pairs,
                  std::size_t count,
                  const double *place,
                  const double *radius,
                  PairChunk &chunk)
{
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = pairs[k].first, j = pairs[k].second;
    const double *a = place + 3 * i, *b = place + 3 * j;
    chunk.x[k] = b[0] - a[0];
    chunk.y[k] = b[1] - a[1];
    chunk.z[k] = b[2] - a[2];
    chunk.radius_sum[k] = radius[i] + radius[j];
  }
}

inline void measure(const NearestImages &images,
                    Pack<double> gap,
                    std::size_t count,
                    PairChunk &chunk)
{
  using P = Pack<double>;
  for (std::size_t k = 0; k < count; k += P::size) {
    const auto branch = images.of(
        P::load(chunk.x + k), P::load(chunk.y + k), P::load(chunk.z + k));
    const P sum = P::load(chunk.radius_sum + k), limit = sum + gap;
    const P square = branch.square();
    branch.x.store(chunk.x + k);
    branch.y.store(chunk.y + k);
    branch.z.store(chunk.z + k);
    (sum - sqrt(square)).store(chunk.radius_sum + k);
    (square - limit * limit).store(chunk.excess + k);
  }
}

inline std::size_t filter_pairs(const PairSearch &search,
                                const Pair *pairs,
                                std::size_t count,
                                const double *place,
                                const double *radius,
                                NearPair *near)
{
  const NearestImages images(search);
  const Pack<double> gap(search.gap);
  PairChunk chunk{};
  std::size_t found = 0;
  for (std::size_t begin = 0; begin < count; begin += PairChunk::size) {
    const std::size_t here =
        count - begin < PairChunk::size ? count - begin : PairChunk::size;
    fetch(pairs + begin, here, place, radius, chunk);
    measure(images, gap, here, chunk);
    for (std::size_t k = 0; k < here; ++k) {
      near[found] = {pairs[begin + k],
                     {chunk.x[k], chunk.y[k], chunk.z[k]},
                     chunk.radius_sum[k]};
      found += chunk.excess[k] < 0; // else the next overwrites it
    }
  }
  return found;
}

/// One grain against others.
class Matching
{
public:
  using P = Pack<double>;
  static_assert(P::size <= OrderedGrains::room);

  Matching(const PairSearch &search, const OrderedGrains &grains)
      : images_(search), gap_(search.gap), grains_(grains)
  {
  }

  /// Writes the near pairs of the grain at a position with those at others.
  std::size_t run(std::size_t at, Positions others, Pair *pairs) const
  {
    const P x(grains_.x[at]), y(grains_.y[at]), z(grains_.z[at]);
    const P radius(grains_.radius[at]);
    const std::uint32_t grain = grains_.grain[at];
    std::size_t found = 0;
    for (std::size_t k = others.first; k < others.last; k += P::size) {
      const auto branch = images_.of(load(grains_.x + k) - x,
                                     load(grains_.y + k) - y,
                                     load(grains_.z + k) - z);
      const P limit = radius + load(grains_.radius + k) + gap_;
      const auto near = hn::And((branch.square() < limit * limit).lanes,
                                hn::FirstN(P::Tag(), others.last - k));
      found += write(near, grain, grains_.grain + k, pairs + found);
    }
    return found;
  }

private:
  static P load(const double *from) { return P(hn::LoadU(P::Tag(), from)); }

  static std::size_t write(hn::Mask<P::Tag> near,
                           std::uint32_t grain,
                           const std::uint32_t *others,
                           Pair *pairs)
  {
    std::uint8_t bytes[8] = {}; // what the library asks for
    hn::StoreMaskBits(P::Tag(), near, bytes);
    std::size_t count = 0;
    for (std::uint32_t bits = bytes[0]; bits != 0; bits &= bits - 1) {
      const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
      const std::uint32_t other = others[lane];
      pairs[count++] = grain < other ? Pair{grain, other} : Pair{other, grain};
    }
    return count;
  }

  NearestImages images_;
  P gap_;
  OrderedGrains grains_;
};

inline std::size_t match_grains(const PairSearch &search,
                                const OrderedGrains &grains,
                                Positions those,
                                const Positions *others,
                                std::size_t count,
                                Pair *pairs)
{
  const Matching matching(search, grains);
  std::size_t found = 0;
  for (std::size_t at = those.first; at < those.last; ++at) {
    found += matching.run(at, {at + 1, others[0].last}, pairs + found);
    for (std::size_t k = 1; k < count; ++k)
      found += matching.run(at, others[k], pairs + found);
  }
  return found;
}

constexpr PairLoops pair_loops()
{
  return {filter_pairs, match_grains};
}
} // namespace tamp::dem::HWY_NAMESPACE

#endif
