// SPDX-License-Identifier: BSD-3-Clause
#include <dem/condensed_tangent.h>
#include <dem/deform.h>
#include <dem/probed_tangent.h>
#include <dem/tangent.h>
#include <tests/benchmark/rows.h>

#include <functional>
#include <memory>
#include <optional>

// What tangents cost for the state at the end of a small step of a path, and
// how far they are from differences of the map around that step.
namespace tamp::speed
{
namespace
{
using namespace tamp::dem;

/// The step, made when it is first asked for.
class Step
{
public:
  Step(Packings &packings, std::size_t count)
      : packings_(packings), count_(count)
  {
  }
  const UnitCell &start() { return packings_.compacted(count_); }
  const UnitCell &end()
  {
    if (!end_) {
      end_ = start();
      deform(*end_, uniaxial(strain), {});
    }
    return *end_;
  }
  /// By central differences.
  const Tangent &reference()
  {
    if (!reference_)
      reference_ = probed_tangent(start(), probing()).tangent;
    return *reference_;
  }
  static Probing probing()
  {
    Probing result;
    result.path(1, 1) = strain;
    return result;
  }

private:
  static constexpr double strain = -1e-4;
  Packings &packings_;
  std::size_t count_;
  std::optional<UnitCell> end_;
  std::optional<Tangent> reference_;
};

Tangent probed_forward(Step &step)
{
  Probing probing = Step::probing();
  probing.central = false;
  probing.unbalance_tolerance = 1e-6;
  return probed_tangent(step.start(), probing).tangent;
}

Tangent
condensed(Step &step, bool sliding, double accuracy = NetworkChoice().accuracy)
{
  NetworkChoice choice;
  choice.sliding = sliding;
  choice.accuracy = accuracy;
  return condensed_tangent(step.end(), choice).tangent;
}

/// A row of time and a row of error.
void add_tangent(const std::shared_ptr<Step> &step,
                 const std::string &name,
                 const std::string &end,
                 const std::function<Tangent(Step &)> &tangent)
{
  add_time("tangent." + name + end, [=] {
    tangent(*step);
  })->Unit(benchmark::kMillisecond);
  add_value("tangent." + name + "_error" + end, relative_error, [=] {
    const Tangent &wanted = step->reference();
    return (tangent(*step) - wanted).norm() / wanted.norm();
  });
}
} // namespace

void add_tangents(Packings &packings)
{
  for (std::size_t count : {200, 1000}) {
    const auto step = std::make_shared<Step>(packings, count);
    const std::string end = of_grains(count);
    add_time("tangent.probed" + end, [=] {
      benchmark::DoNotOptimize(probed_tangent(step->start(), Step::probing()));
    })->Unit(benchmark::kMillisecond);
    add_tangent(step, "probed_forward", end, probed_forward);
    add_tangent(
        step, "condensed", end, [](Step &s) { return condensed(s, true); });
    add_tangent(step, "condensed_coarse", end, [](Step &s) {
      return condensed(s, true, 1e-4);
    });
    add_tangent(step, "condensed_sticking", end, [](Step &s) {
      return condensed(s, false, 1e-4);
    });
    add_tangent(
        step, "voigt", end, [](Step &s) { return voigt_tangent(s.end()); });
  }
}
} // namespace tamp::speed
