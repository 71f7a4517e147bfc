// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/kernel/instruction_set.h>
#include <tests/benchmark/rows.h>

#include <algorithm>
#include <functional>

// Time steps of dynamics, everything included: forces with history and
// rotation, integration, the moving box, lists of pairs; 5e-7 of strain each.
namespace tamp::speed
{
namespace
{
using namespace tamp::dem;

constexpr double step_strain = 5e-7;

/// Dynamics at the strain rate that makes steps of step_strain.
Driving steady_driving(const UnitCell &cell, const Arithmetic &arithmetic)
{
  constexpr double slow_rate = 1e-7, trial_strain = 2e-5;
  Driving driving;
  driving.method = Method::dynamics;
  driving.arithmetic = arithmetic;
  driving.dynamics.strain_rate = slow_rate;
  UnitCell trial = cell;
  const double trial_steps =
      double(deform(trial, uniaxial(-trial_strain), driving).evaluations);
  driving.dynamics.strain_rate =
      step_strain * trial_steps * slow_rate / trial_strain;
  return driving;
}

/// A row of time steps. Each starts from the same state, that of the cell once
/// its pairs are listed.
void add_steps(const std::string &name,
               std::function<UnitCell()> make_cell,
               const Arithmetic &arithmetic)
{
  const auto measure = [=](benchmark::State &state) {
    UnitCell start = make_cell();
    const Driving driving = steady_driving(start, arithmetic);
    deform(start, uniaxial(-step_strain), driving);
    const double grains = double(start.size());
    const double steps = std::max(100.0, 400000 / grains);
    double done = 0;
    for (auto _ : state) {
      state.PauseTiming();
      UnitCell cell = start;
      state.ResumeTiming();
      done += double(
          deform(cell, uniaxial(-step_strain * steps), driving).evaluations);
    }
    state.counters[particle_steps] =
        benchmark::Counter(done * grains, benchmark::Counter::kIsRate);
  };
  benchmark::RegisterBenchmark(name.c_str(), measure)
      ->Unit(benchmark::kMillisecond);
}

/// With other laws than Thornton-Ning and Mindlin, on the fastest instruction
/// set.
void add_law(Packings &packings,
             const std::string &name,
             NormalLaw normal,
             TangentialLaw tangential,
             double adhesion)
{
  constexpr std::size_t count = 1000;
  const auto make_cell = [=, &packings] {
    UnitCell cell = packings.repeated(count);
    cell.contact.normal_law = normal;
    cell.contact.tangential_law = tangential;
    cell.contact.work_of_adhesion = adhesion;
    // Contacts start anew: memories of one law are none of another's.
    cell.contacts.clear();
    cell.more_memory.clear();
    deform(cell, Stretch::Identity(), {});
    return cell;
  };
  add_steps("law." + name + ".double" + of_grains(count), make_cell, {});
}
} // namespace

void add_sweeps(Packings &packings)
{
  for (std::size_t count : {200, 1000, 5000, 20000})
    for (InstructionSet set : instruction_sets())
      for (Precision precision :
           {Precision::double_precision, Precision::mixed})
        add_steps("sweep." + name_of(set) +
                      (precision == Precision::mixed ? ".mixed" : ".double") +
                      of_grains(count),
                  [=, &packings] { return packings.repeated(count); },
                  {precision, set});
  const auto mindlin = TangentialLaw::mindlin;
  add_law(packings, "hertz-mindlin", NormalLaw::hertz, mindlin, 0);
  add_law(packings, "jkr", NormalLaw::jkr, mindlin, 1);
  add_law(
      packings, "thornton-ning-jkr", NormalLaw::thornton_ning_jkr, mindlin, 1);
  add_law(packings,
          "mindlin-deresiewicz",
          NormalLaw::thornton_ning,
          TangentialLaw::mindlin_deresiewicz,
          0);
}
} // namespace tamp::speed
