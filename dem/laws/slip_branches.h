// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_slip_branches_h
#define dem_laws_slip_branches_h

#include <dem/laws/slip_curve.h>

namespace tamp::dem
{
/// `yes` where the mask holds, `no` elsewhere.
template <class V>
Triple<V> choose(const auto &mask, const Triple<V> &yes, const Triple<V> &no)
{
  return {select(mask, yes.x, no.x),
          select(mask, yes.y, no.y),
          select(mask, yes.z, no.z)};
}
/// a / |a|, zero for zero.
template <class V>
Triple<V> direction(const Triple<V> &a)
{
  const V size = sqrt(dot(a, a));
  return select(size > V(tiny), V(1.0) / max(size, V(tiny)), V(0.0)) * a;
}

/// What a contact with partial slip remembers besides its force. All zeros is
/// a new contact.
template <class V>
struct SlipMemory {
  Triple<V> turn; ///< force where the slip last turned [N]
  V width;        ///< distance from there at which the turn is forgotten [N]
  V limit;        ///< mu N when the memory was written [N]
  V reserve;      ///< force still to be gained without slip, as the normal
                  ///< force had grown [N]
  V energy;       ///< work put in and not lost [J]
};

/// Force and memory of a contact, on their way through an increment.
template <class V>
struct SlipState {
  Triple<V> force;
  SlipMemory<V> memory;

  V distance() const // from the turning point
  {
    const Triple<V> gone = force - memory.turn;
    return sqrt(dot(gone, gone));
  }
  /// Back to first loading where the turn is to be forgotten.
  void forget()
  {
    const V size = sqrt(dot(force, force));
    const V gone = distance();
    const auto first = gone >= select(gone > V(tiny), memory.width, V(0.0));
    memory.turn = choose(first, V(-1.0) * force, memory.turn);
    memory.width = select(first, size + size, memory.width);
    memory.reserve = select(first, V(0.0), memory.reserve);
  }
};

/// Answers to a slip that leads on from the turning point, or back to it.
template <class V>
struct SlipBranches {
  const SlipCurve<V> &curve;
  Triple<V> along;               // from the turning point to the force
  V reserve, front, turn, width; // forces along it; front: where slip resumes
  V wait, reach, end;            // their slips

  SlipBranches(const SlipState<V> &state, const SlipCurve<V> &c)
      : curve(c), along(direction(state.force - state.memory.turn)),
        reserve(state.memory.reserve), front(state.distance() + reserve),
        turn(dot(state.memory.turn, along)),
        width(max(state.memory.width, front)), wait(c.slip(reserve, 1)),
        reach(c.slip(front, 2)), end(c.slip(width, 2))
  {
  }
  SlipResponse<V> on(const V &way) const
  {
    const V past = max(V(0.0), way - wait);
    const V rest = max(V(0.0), past - (end - reach));
    const SlipResponse<V> first = curve.first_loading(turn + width, rest);
    const V at = min(reach + past, end);
    const V start = curve.force(reach, 2) - reserve;
    const SlipResponse<V> moved{
        curve.force(at, 2) - start + first.force,
        curve.lost(wait, 1) + curve.lost(at, 2) - curve.lost(reach, 2) +
            first.lost,
        curve.work(wait, 1) + curve.work(at, 2) - curve.work(reach, 2) -
            start * (at - reach) + (curve.force(at, 2) - start) * rest +
            first.work};
    return select(way < wait,
                  {curve.force(way, 1), curve.lost(way, 1), curve.work(way, 1)},
                  moved);
  }
  SlipResponse<V> back(const V &way) const
  {
    const V past = max(way, wait) + wait;
    const V rest = max(V(0.0), past - reach);
    const SlipResponse<V> first = curve.first_loading(V(0.0) - turn, rest);
    const V at = min(past, reach);
    const V twice = wait + wait;
    const SlipResponse<V> moved{
        curve.force(at, 2) - reserve + first.force,
        curve.lost(at, 2) - curve.lost(wait, 1) + first.lost,
        curve.work(wait, 1) + curve.work(at, 2) - curve.work(twice, 2) -
            reserve * (at - twice) + (curve.force(at, 2) - reserve) * rest +
            first.work};
    return select(way < wait,
                  {curve.force(way, 1), curve.lost(way, 1), curve.work(way, 1)},
                  moved);
  }
};
} // namespace tamp::dem

#endif
