// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_all_loops_h
#define dem_kernel_all_loops_h

#include <dem/kernel/extra_loops.h>
#include <dem/kernel/gather_loop.h>
#include <dem/kernel/grain_loops.h>
#include <dem/kernel/kernel.h>
#include <dem/kernel/loops.h>
#include <dem/kernel/pair_loops.h>
#include <dem/kernel/scatter_loops.h>

#include <utility>
#include <variant>

namespace tamp::dem::HWY_NAMESPACE
{
template <std::size_t k>
using NormalLawAt = std::variant_alternative_t<k, AnyNormalLaw>;
template <std::size_t k>
using TangentialLawAt = std::variant_alternative_t<k, AnyTangentialLaw>;

template <class T, std::size_t... n, std::size_t... t>
constexpr KernelLoops<T> all_loops(std::index_sequence<n...>,
                                   std::index_sequence<t...>)
{
  KernelLoops<T> loops{};
  loops.gather = gather<T, false>;
  loops.gather_with_grains = gather<T, true>;
  loops.normal = {push<T, NormalLawAt<n>>...};
  loops.damp_push = damp_push<T>;
  loops.tangential = {rub<T, TangentialLawAt<t>, false>...};
  loops.booked_tangential = {rub<T, TangentialLawAt<t>, true>...};
  loops.damp_rub = {damp_rub<T, TangentialLawAt<t>>...};
  loops.scatter = scatter<T, false>;
  loops.scatter_damped = scatter<T, true>;
  loops.roll = roll<T>;
  loops.stress = add_stress<T, false>;
  loops.stress_damped = add_stress<T, true>;
  loops.grains = grain_loops<T>();
  return loops;
}

template <class T>
constexpr KernelLoops<T> all_loops()
{
  using Loops = KernelLoops<T>;
  return all_loops<T>(std::make_index_sequence<Loops::normal_laws>(),
                      std::make_index_sequence<Loops::tangential_laws>());
}

/// The kernel of this instruction set.
inline constexpr Kernel kernel = {
    all_loops<double>(), all_loops<float>(), pair_loops()};
} // namespace tamp::dem::HWY_NAMESPACE

#endif
