// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_mindlin_deresiewicz_h
#define dem_laws_mindlin_deresiewicz_h

#include <dem/laws/mindlin.h>
#include <dem/laws/slip_branches.h>

namespace tamp::dem
{
/// Tangential force with partial slip in loading, unloading and reloading,
/// exact for finite increments along a line with a constant normal force, and
/// of the incremental form of Thornton & Yin for small ones.
///
/// The contact follows a SlipCurve from its last turning point; the first
/// loading from zero is the same curve as that from the opposite force. Passing
/// the previous turning point, or minus the first, it is back on first loading;
/// older turning points are forgotten. A rise of the normal force moves the
/// turning point by mu dN and lets the next mu dN stick; a fall shrinks the
/// core that sticks. The normal force changes first, then the grains slip.
///
/// The memory keeps count of the energy put in and not lost, and the force
/// never exceeds what could be stored with it; along a line with a constant
/// normal force this changes nothing.
///
/// In three dimensions the slip that leads on, away from the turning point,
/// continues the curve; whatever leads back or across starts a new curve, so
/// that it begins with 8 G* a. This is continuous in the slip, and isotropic
/// for a contact without history.
/// Source: Mindlin & Deresiewicz (1953), J. Appl. Mech. 20:327; Thornton & Yin
/// (1991), Powder Technol. 65:153; closed form: Ciavarella (1998), Int. J.
/// Solids Struct. 35:2349; Jaeger (1998), Arch. Appl. Mech. 68:215. The
/// treatment of three dimensions is our own.
struct MindlinDeresiewicz {
  static constexpr int more = 7; ///< a SlipMemory, in its order

  double effective_shear_modulus; ///< G* [Pa]
  double friction_coefficient;    ///< mu [-]

  /// k_t before any slip [N/m].
  template <class V>
  V stiffness(const V &contact_radius) const
  {
    return V(8 * effective_shear_modulus) * contact_radius;
  }
  /// Largest tangential force [N].
  template <class V>
  V cap(const NormalAnswer<V> &push) const
  {
    return V(friction_coefficient) * max(push.force, V(0.0));
  }

  /// The force turns with the contact as Mindlin's does. Lost is the work of
  /// the rings that slid, and what a change of the normal force takes off the
  /// energy of a first loading up to the old force.
  template <class V>
  TangentialAnswer<V> operator()(const Triple<V> &old_force,
                                 const ContactMotion<V> &now,
                                 V *own) const
  {
    const SlipCurve<V> before(stiffness(now.old_radius), own[4]);
    const SlipCurve<V> after(stiffness(now.push.contact_radius), cap(now.push));
    SlipState<V> state{
        turned(old_force, now.normal, now.spin),
        {turned(Triple<V>{own[0], own[1], own[2]}, now.normal, now.spin),
         own[3],
         own[4],
         own[5],
         own[6]}};
    const V heat = press(state, before, after);
    const V rubbed = slide(state, after, across(now.slip, now.normal));
    const SlipMemory<V> &memory = state.memory;
    own[0] = memory.turn.x, own[1] = memory.turn.y, own[2] = memory.turn.z;
    own[3] = memory.width, own[4] = memory.limit, own[5] = memory.reserve;
    own[6] = memory.energy;
    return {state.force, heat + rubbed};
  }

  /// What the memory counts as put in and not lost [J].
  double stored(const Triple<double> &,
                const NormalAnswer<double> &,
                const double *own) const
  {
    return own[6];
  }

private:
  /// The force after a fall of the normal force without slip: the rings are
  /// held to less, the core keeps its slip.
  template <class V>
  static Triple<V> sink(const SlipState<V> &state,
                        const SlipCurve<V> &before,
                        const SlipCurve<V> &after)
  {
    const Triple<V> &force = state.force;
    const V size = sqrt(dot(force, force)), gone = state.distance();
    const V fall = before.limit - after.limit;
    const V kept = after.force(before.slip(size, 1), 1);
    const Triple<V> first = kept * direction(force);
    const V reach = before.slip(gone, 2), drop = before.depth - after.depth;
    const V part = min(V(1.0), max(V(0.0), reach / max(drop, V(tiny))));
    const V left = after.force(max(V(0.0), reach - drop), 2);
    const Triple<V> along = direction(force - state.memory.turn);
    const Triple<V> turned = state.memory.turn + (fall + left) * along;
    const Triple<V> slipped = choose(
        gone >= state.memory.width, first, first + part * (turned - first));
    // What had been reserved is given back without slip, with the radius.
    const V stuck = min(V(1.0), state.memory.reserve / max(fall, V(tiny)));
    const V shrink =
        min(V(1.0), after.stiffness / max(before.stiffness, V(tiny)));
    return slipped + stuck * (shrink * force - slipped);
  }

  /// Changes the normal force. Answers with the heat.
  template <class V>
  static V press(SlipState<V> &state,
                 const SlipCurve<V> &before,
                 const SlipCurve<V> &after)
  {
    SlipMemory<V> &memory = state.memory;
    state.forget();
    const V rise = after.limit - before.limit;
    const V energy = before.energy(sqrt(dot(state.force, state.force)));
    const V gone = state.distance();
    const Triple<V> along = direction(state.force - memory.turn);
    const auto fell = rise < V(0.0);
    state.force = choose(fell, sink(state, before, after), state.force);
    const V size = sqrt(dot(state.force, state.force));
    state.force = min(V(1.0), after.limit / max(size, V(tiny))) * state.force;

    const V shift = select(gone > V(tiny), rise, V(0.0));
    const Triple<V> turn = memory.turn - shift * along;
    // A fall that takes the force past its turning point ends the turn.
    const V ahead = dot(state.force - turn, along);
    const V left = select(fell, min(ahead, memory.width - gone), V(1.0));
    const auto first = left <= V(0.0);
    const V held = min(size, after.limit);
    memory.turn = choose(first, V(-1.0) * state.force, turn);
    memory.width =
        select(first, held + held, max(V(0.0), memory.width + V(2.0) * shift));
    memory.reserve = select(first, V(0.0), max(V(0.0), memory.reserve + shift));
    memory.limit = after.limit;
    // A rise moves nothing and costs nothing.
    const V less = select(fell, energy - after.energy(held), V(0.0));
    const V heat = select(after.limit > V(tiny),
                          min(max(V(0.0), less), memory.energy),
                          memory.energy);
    memory.energy = memory.energy - heat;
    return heat;
  }
  /// Slips under a constant normal force. Answers with the heat.
  template <class V>
  static V
  slide(SlipState<V> &state, const SlipCurve<V> &curve, const Triple<V> &slip)
  {
    SlipMemory<V> &memory = state.memory;
    const SlipBranches<V> branches(state, curve);
    const V way = sqrt(dot(slip, slip)), on = dot(slip, branches.along);
    const V forward = max(V(0.0), on);
    const SlipResponse<V> fresh = branches.back(way);
    const SlipResponse<V> wrong = branches.back(forward);
    const SlipResponse<V> right = branches.on(forward);
    const Triple<V> old = state.force;
    const Triple<V> tried = old + fresh.force * direction(slip) -
                            (wrong.force - right.force) * branches.along;
    const V size = sqrt(dot(tried, tried));
    const V over = max(V(0.0), size - curve.limit);
    const V k = max(curve.stiffness, V(tiny));
    const V heat = right.lost + max(V(0.0), fresh.lost - wrong.lost) +
                   curve.limit * over / k;
    const V work = dot(old, slip) + fresh.work - wrong.work + right.work -
                   V(0.5) * over * over / k;
    // A ring whose traction a change of the normal force has lowered heats less
    // than the curve says: what the force needs stays.
    const V held = min(size, curve.limit);
    const V whole = memory.energy + work;
    const V spare = max(V(0.0), whole - V(0.5) * held * held / k);
    const V energy = max(V(0.0), whole - min(heat, spare));
    const V most = min(curve.limit, sqrt(V(2.0) * k * energy));
    state.force = min(V(1.0), most / max(size, V(tiny))) * tried;

    const auto turns = on < V(0.0);
    // The older turning point stays where it is, however much of the reserve
    // the turn takes in.
    const V ahead = select(way >= branches.wait, memory.reserve, V(0.0));
    const V behind = branches.front - memory.reserve;
    memory.turn = choose(turns, old + ahead * branches.along, memory.turn);
    memory.width = select(turns, behind + ahead, memory.width);
    memory.reserve =
        select(turns, V(0.0), max(V(0.0), memory.reserve - right.force));
    state.forget();
    const V lost = max(V(0.0), whole - energy);
    memory.energy = energy;
    return lost;
  }
};
} // namespace tamp::dem

#endif
