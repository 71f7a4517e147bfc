// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/packing.h>
#include <dem/probed_tangent.h>
#include <dem/sweep_layout.h>
#include <dem/unit_cell.h>
#include <dem/unit_cell_bytes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace
{
using namespace tamp::dem;

/// Processor time: on a shared machine it says more than the clock on the wall.
double seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void report(const std::string &name, double value, const std::string &unit)
{
  std::cout << name << ',' << std::setprecision(6) << value << ',' << unit
            << std::endl;
}

Stretch uniaxial(double log_strain)
{
  Stretch stretch = Stretch::Identity();
  stretch(1, 1) = std::exp(log_strain);
  return stretch;
}

/// Up to 1000 alumina granules in mid-compaction: packed at 0.5 MPa, then
/// compressed by 5 %. Made once for each count.
const UnitCell &packing(std::size_t count)
{
  static std::map<std::size_t, UnitCell> made;
  const auto found = made.find(count);
  if (found != made.end())
    return found->second;
  PackingRequest request;
  request.grain_count = std::min<std::size_t>(count, 1000);
  request.sizes.minimum_diameter = 450e-6;
  request.sizes.maximum_diameter = 650e-6;
  request.material = {3.5e9, 0.3, 2000, 50e6};
  request.contact.friction_coefficient = 0.35;
  request.goal.pressure = 0.5e6;
  UnitCell cell = make_packing(request);
  for (int k = 0; k < 25; ++k)
    deform(cell, uniaxial(-2e-3), {});
  return made.emplace(count, std::move(cell)).first->second;
}

/// The same cell `times` over, side by side along y.
UnitCell repeated(const UnitCell &cell, std::size_t times)
{
  UnitCell result = cell;
  result.neighbours = {};
  result.last = {};
  result.box.h.col(1) *= double(times);
  result.radius.clear();
  result.place.clear();
  result.contacts.clear();
  for (std::size_t copy = 0; copy < times; ++copy)
    for (std::size_t i = 0; i < cell.size(); ++i) {
      Vector3 place = cell.place[i];
      place[1] =
          (place[1] - std::floor(place[1]) + double(copy)) / double(times);
      result.place.push_back(place);
      result.radius.push_back(cell.radius[i]);
    }
  return result;
}

/// A cell of `count` grains: beyond 1000, copies of a smaller one, for making a
/// packing is no part of what is measured.
UnitCell sweep_cell(std::size_t count)
{
  const UnitCell &base = packing(count);
  return count > base.size() ? repeated(base, count / base.size()) : base;
}

/// Time steps of dynamics, everything included: forces with history and
/// rotation, integration, the moving box, lists of pairs; 5e-7 of strain each.
double step_rate(UnitCell cell, const Arithmetic &arithmetic)
{
  const double step_strain = 5e-7;
  Driving driving;
  driving.method = Method::dynamics;
  driving.arithmetic = arithmetic;
  // The strain rate that makes a step of that strain.
  const double slow_rate = 1e-7, trial_strain = 2e-5;
  driving.dynamics.strain_rate = slow_rate;
  UnitCell trial = cell;
  const double trial_steps =
      double(deform(trial, uniaxial(-trial_strain), driving).evaluations);
  driving.dynamics.strain_rate =
      step_strain * trial_steps * slow_rate / trial_strain;
  const double grains = double(cell.size());
  const double steps = std::max(20.0, 400000 / grains);
  std::vector<double> rates;
  for (int sample = 0; sample < 7; ++sample) {
    const double start = seconds();
    const CellAnswer answer =
        deform(cell, uniaxial(-step_strain * steps), driving);
    rates.push_back(double(answer.evaluations) * grains / (seconds() - start));
  }
  std::ranges::sort(rates);
  return rates[rates.size() / 2];
}

void measure_steps(std::size_t count)
{
  const UnitCell cell = sweep_cell(count);
  for (InstructionSet set : instruction_sets())
    for (Precision precision : {Precision::double_precision, Precision::mixed})
      report("sweep." + name_of(set) +
                 (precision == Precision::mixed ? ".mixed." : ".double.") +
                 std::to_string(count),
             step_rate(cell, {precision, set}),
             "particle-steps/s");
}

/// The same with other laws than Thornton-Ning and Mindlin, on the fastest
/// instruction set.
void measure_laws(std::size_t count)
{
  const auto measure = [&](const std::string &name,
                           NormalLaw normal,
                           TangentialLaw tangential,
                           double adhesion) {
    UnitCell cell = sweep_cell(count);
    cell.contact.normal_law = normal;
    cell.contact.tangential_law = tangential;
    cell.contact.work_of_adhesion = adhesion;
    // Contacts start anew: memories of one law are none of another's.
    cell.contacts.clear();
    cell.more_memory.clear();
    deform(cell, Stretch::Identity(), {});
    report("law." + name + ".double." + std::to_string(count),
           step_rate(std::move(cell), {}),
           "particle-steps/s");
  };
  const auto mindlin = TangentialLaw::mindlin;
  measure("hertz-mindlin", NormalLaw::hertz, mindlin, 0);
  measure("jkr", NormalLaw::jkr, mindlin, 1);
  measure("thornton-ning-jkr", NormalLaw::thornton_ning_jkr, mindlin, 1);
  measure("mindlin-deresiewicz",
          NormalLaw::thornton_ning,
          TangentialLaw::mindlin_deresiewicz,
          0);
}

/// What a path of 1 % in equal parts costs and where it ends.
struct Path {
  UnitCell cell;
  CellAnswer answer;
  double seconds = 0;
  std::size_t evaluations = 0;
};

Path drive(const UnitCell &from, int parts, const Driving &driving)
{
  Path path{from, {}};
  const double start = seconds();
  for (int k = 0; k < parts; ++k) {
    path.answer = deform(path.cell, uniaxial(-1e-2 / parts), driving);
    path.evaluations += path.answer.evaluations;
  }
  path.seconds = seconds() - start;
  return path;
}

constexpr double thousandths = 10; // of strain in a path

void measure_evaluations(std::size_t count)
{
  const Path path = drive(packing(count), 10, {});
  report("map.evaluations_per_1e-3." + std::to_string(count),
         double(path.evaluations) / thousandths,
         "-");
}

void measure_seconds(std::size_t count)
{
  const Path path = drive(packing(count), 10, {});
  report("map.seconds_per_1e-3." + std::to_string(count),
         path.seconds / thousandths,
         "s");
}

/// Error of the stress after 1 % against slow dynamics, relative to the stress:
/// with increments of 1e-3, and with increments of 5e-3.
void measure_stress_error(std::size_t count)
{
  Driving slow;
  slow.method = Method::dynamics;
  slow.dynamics.strain_rate = 1e-5;
  const Eigen::Matrix3d wanted = drive(packing(count), 1, slow).answer.stress;
  const auto error = [&](int parts) {
    const Path path = drive(packing(count), parts, {});
    return (path.answer.stress - wanted).norm() / wanted.norm();
  };
  const std::string name = "map.stress_error." + std::to_string(count);
  report(name, error(10), "-");
  report(name + ".5e-3", error(2), "-");
}

/// What tangents cost for the state at the end of a small step of the path,
/// and how far they are from differences of the map around that step.
void measure_tangents(std::size_t count)
{
  const UnitCell &cell = packing(count);
  constexpr double step = -1e-4;
  UnitCell stepped = cell;
  deform(stepped, uniaxial(step), {});
  Probing probing;
  probing.path(1, 1) = step;
  NetworkChoice choice;
  choice.sliding = true;

  const std::string end = '.' + std::to_string(count);
  Tangent wanted;
  const auto time = [&](const std::string &name, auto &&call) {
    const double start = seconds();
    const Tangent found = call();
    report("tangent." + name + end, seconds() - start, "s");
    return found;
  };
  const auto compare = [&](const std::string &name, const Tangent &found) {
    report("tangent." + name + "_error" + end,
           (found - wanted).norm() / wanted.norm(),
           "-");
  };
  wanted =
      time("probed", [&] { return probed_tangent(cell, probing).tangent; });
  probing.central = false;
  probing.unbalance_tolerance = 1e-6;
  compare("probed_forward", time("probed_forward", [&] {
            return probed_tangent(cell, probing).tangent;
          }));
  compare("condensed", time("condensed", [&] {
            return condensed_tangent(stepped, choice).tangent;
          }));
  choice.accuracy = 1e-4;
  compare("condensed_coarse", time("condensed_coarse", [&] {
            return condensed_tangent(stepped, choice).tangent;
          }));
  choice.sliding = false;
  compare("condensed_sticking", time("condensed_sticking", [&] {
            return condensed_tangent(stepped, choice).tangent;
          }));
  compare("voigt", time("voigt", [&] { return voigt_tangent(stepped); }));
}

void measure_bytes(std::size_t count)
{
  std::vector<char> bytes;
  to_bytes(packing(count), bytes);
  report("cell.bytes." + std::to_string(count),
         2 * double(bytes.size()), // committed and trial
         "B");
}

struct Benchmark {
  std::string name;
  std::vector<std::size_t> counts;
  std::function<void(std::size_t)> run;
};

const std::vector<Benchmark> benchmarks = {
    {"sweep.", {200, 1000, 5000, 20000}, measure_steps},
    {"law.", {1000}, measure_laws},
    {"map.evaluations_per_1e-3.", {200, 1000}, measure_evaluations},
    {"map.stress_error.", {200, 1000}, measure_stress_error},
    {"map.seconds_per_1e-3.", {200, 1000}, measure_seconds},
    {"tangent.", {200, 1000}, measure_tangents},
    {"cell.bytes.", {200, 1000}, measure_bytes},
};
} // namespace

/// dem_benchmark [FILTER]: runs the benchmarks whose name contains FILTER.
int main(int argc, char **argv)
{
  const std::string filter = argc > 1 ? argv[1] : "";
  for (const Benchmark &benchmark : benchmarks)
    for (const std::size_t count : benchmark.counts)
      if ((benchmark.name + std::to_string(count)).find(filter) !=
          std::string::npos)
        benchmark.run(count);
}
