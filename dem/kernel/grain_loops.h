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

/// Ones at the radius and the inverse mass in GrainRow::motion, else zeros.
inline RowPack constants_of_row()
{
  alignas(64) static constexpr double ones[8] = {0, 0, 0, 1, 0, 0, 0, 1};
  return RowPack::load(ones);
}

/// Writes the motion of a grain and takes its force, which becomes zero; its
/// radius and mass stay.
template <class T>
void put(const RowPack &motion, const RowPack &constants, GrainRow<T> &row)
{
  multiply_add(constants, RowPack::load(row.motion), motion).store(row.motion);
  RowPack(0.0).store(row.force);
}

template <class T>
double relax(const RelaxationMove &move,
             GrainRow<T> *rows,
             RelaxingGrain *grains,
             std::size_t count)
{
  const RowPack retreat(move.retreat), keep(move.keep), push(move.push),
      step(move.step);
  const RowPack constants = constants_of_row();
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
    put(position, constants, rows[i]);
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
  const RowPack length(step.length), half(0.5), local(step.local_damping);
  const RowMatrix stretch(step.stretch);
  const RowPack constants = constants_of_row();
  RowPack heat(0.0), fastest2(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    MovingGrain &grain = grains[i];
    const RowPack gain = RowPack::halves(grain.gain[0], grain.gain[1]);
    const RowPack damping = RowPack::halves(grain.damping[0], grain.damping[1]);
    const RowPack old = RowPack::load(grain.velocity);
    const RowPack force = RowPack::load(rows[i].force);
    const RowPack drag = local * with_sign_of(force, old);
    const RowPack velocity = old + gain * (force - drag - damping * old);
    velocity.store(grain.velocity);
    const RowPack middle = half * (old + velocity);
    heat = heat + (damping * middle + drag) * middle;
    fastest2 = larger(fastest2, velocity * velocity);

    const RowPack way = length * velocity;
    (stretch.times(RowPack::load(grain.moved)) + way).store(grain.moved);
    put(way, constants, rows[i]);
  }
  alignas(64) double fastest[8];
  fastest2.store(fastest);
  return {fastest[0] + fastest[1] + fastest[2], step.length * total(heat)};
}

template <class T>
constexpr GrainLoops<T> grain_loops()
{
  return {survey<T>, relax<T>, advance<T>};
}
} // namespace tamp::dem::HWY_NAMESPACE

#endif
