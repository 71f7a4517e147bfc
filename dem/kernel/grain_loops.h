// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_grain_loops_h
#define dem_kernel_grain_loops_h

#include <dem/kernel/grain_motion.h>
#include <dem/kernel/grain_row_pack.h>

#include <cstddef>

// The loops over grains, for the instruction set that the file including this
// is compiled for.
namespace tamp::dem::HWY_NAMESPACE
{
/// Sum of the numbers of a row.
inline double total(const RowPack &row)
{
  alignas(64) double n[8];
  row.store(n);
  return ((n[0] + n[1]) + (n[2] + n[3])) + ((n[4] + n[5]) + (n[6] + n[7]));
}

template <class T>
RelaxationSums
survey(const GrainRow<T> *rows, const RelaxingGrain *grains, std::size_t count)
{
  RowPack power(0.0), kinetic(0.0), steepness(0.0), norms(0.0);
  const RowPack floor(1e-300); // of the mobility in the numbers not used
  for (std::size_t i = 0; i < count; ++i) {
    const RowPack force = RowPack::load(rows[i].force);
    const RowPack velocity = RowPack::load(grains[i].velocity);
    const RowPack mobility = RowPack::load(grains[i].mobility);
    const RowPack square = force * force;
    power = power + force * velocity;
    kinetic = kinetic + velocity * velocity / larger(mobility, floor);
    steepness = steepness + square * mobility;
    norms = norms + root(half_sums(square));
  }
  alignas(64) double norm[8];
  norms.store(norm);
  return {total(power), total(kinetic), total(steepness), norm[0], norm[4]};
}

/// Rows of ones and zeros.
struct RowMasks {
  RowPack first = row({1, 1, 1, 0, 0, 0, 0, 0});
  RowPack last = row({0, 0, 0, 0, 1, 1, 1, 0});
  RowPack constant = row({0, 0, 0, 1, 0, 0, 0, 1}); ///< radius, inverse mass

private:
  struct Eight {
    alignas(64) double n[8];
  };
  static RowPack row(const Eight &eight) { return RowPack::load(eight.n); }
};

/// Writes what a grain has moved and turned; its constants stay.
template <class T>
void put_place(GrainRow<T> &row, const RowMasks &masks, const RowPack &place)
{
  T *const at = reinterpret_cast<T *>(&row);
  (place + masks.constant * RowPack::load(at)).store(at);
}

template <class T>
double relax(const RelaxationMove &move,
             GrainRow<T> *rows,
             RelaxingGrain *grains,
             std::size_t count)
{
  const RowPack retreat(move.retreat), keep(move.keep), push(move.push),
      step(move.step);
  const RowMatrix back(move.back);
  const RowMasks masks;
  RowPack farthest2(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    RelaxingGrain &grain = grains[i];
    const RowPack mobility = RowPack::load(grain.mobility);
    const RowPack old = RowPack::load(grain.velocity);
    const RowPack force = RowPack::load(rows[i].force);
    const RowPack velocity = keep * old + push * (force * mobility);
    const RowPack position =
        RowPack::load(grain.position) + retreat * old + step * velocity;
    velocity.store(grain.velocity);
    position.store(grain.position);
    const RowPack moved = position - RowPack::load(grain.listed);
    put_place(rows[i],
              masks,
              moved * (masks.first + RowPack(grain.mobility[3]) * masks.last));
    back.times(grain.position).store(rows[i].motion);
    farthest2 = larger(farthest2, half_sums(moved * moved));
  }
  alignas(64) double farthest[8];
  farthest2.store(farthest);
  return farthest[0];
}

template <class T>
TimeStepSums advance(const TimeStep &step,
                     GrainRow<T> *rows,
                     MovingGrain *grains,
                     std::size_t count)
{
  const RowPack length(step.length), half(0.5);
  const RowMatrix stretch(step.stretch), back(step.back);
  const RowMasks masks;
  RowPack heat(0.0), fastest2(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    MovingGrain &grain = grains[i];
    const RowPack gain = RowPack::load(grain.gain);
    const RowPack damping = RowPack::load(grain.damping);
    const RowPack old = RowPack::load(grain.velocity);
    const RowPack velocity =
        old + gain * (RowPack::load(rows[i].force) - damping * old);
    velocity.store(grain.velocity);
    const RowPack middle = half * (old + velocity);
    heat = heat + damping * (middle * middle);
    fastest2 = larger(fastest2, half_sums(velocity * velocity));

    alignas(64) double went[8];
    const RowPack way = length * velocity;
    way.store(went);
    back.times(went).store(rows[i].motion);
    const RowPack moved = stretch.times(grain.moved) + way;
    moved.store(grain.moved);
    put_place(rows[i],
              masks,
              masks.first * moved +
                  RowPack(grain.gain[3]) * (masks.last * way));
  }
  alignas(64) double fastest[8];
  fastest2.store(fastest);
  return {fastest[0], step.length * total(heat)};
}

template <class T>
constexpr GrainLoops<T> grain_loops()
{
  return {survey<T>, relax<T>, advance<T>};
}
} // namespace tamp::dem::HWY_NAMESPACE

#endif
