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

/// Writes radius, or what stands in its place, and inverse mass back into a
/// row that was stored over.
template <class T>
void put_place(GrainRow<T> &row, const RowPack &place)
{
  const T radius = row.radius, inverse_mass = row.inverse_mass;
  place.store(reinterpret_cast<T *>(&row));
  row.radius = radius;
  row.inverse_mass = inverse_mass;
}

/// 1 in the first four numbers, `last` in the others.
inline RowPack one_and(double last)
{
  alignas(64) const double scale[8] = {1, 1, 1, 1, last, last, last, last};
  return RowPack::load(scale);
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
    put_place(rows[i], moved * one_and(grain.mobility[3]));
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
  const RowPack length(step.length), half(0.5), one(1.0);
  const RowMatrix stretch(step.stretch), back(step.back);
  RowPack heat(0.0), fastest2(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    MovingGrain &grain = grains[i];
    const RowPack gain = RowPack::load(grain.gain);
    const RowPack decay = RowPack::load(grain.decay);
    const RowPack old = RowPack::load(grain.velocity);
    const RowPack velocity = decay * old + gain * RowPack::load(rows[i].force);
    velocity.store(grain.velocity);
    const RowPack middle = half * (old + velocity);
    heat = heat + (one - decay) / gain * (middle * middle);
    fastest2 = larger(fastest2, half_sums(velocity * velocity));

    alignas(64) double went[8];
    (length * velocity).store(went);
    const RowPack motion = back.times(went);
    motion.store(rows[i].motion);
    const RowPack moved = stretch.times(grain.moved) + RowPack::load(went);
    moved.store(grain.moved);
    alignas(64) const double place[8] = {grain.moved[0],
                                         grain.moved[1],
                                         grain.moved[2],
                                         0,
                                         went[4],
                                         went[5],
                                         went[6],
                                         0};
    put_place(rows[i], RowPack::load(place) * one_and(grain.gain[3]));
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
