// SPDX-License-Identifier: BSD-3-Clause
#include <fem/small_probes.h>
#include <fem/stress_search.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tamp::fem
{
namespace
{
using path::Six;
using SymmetricTensor = dealii::SymmetricTensor<2, 3>;

/// One point that is strained a little and put back.
class SmallProbe
{
public:
  SmallProbe(MaterialPoints &points, const std::function<void()> &turn)
      : points_(points), turn_(turn),
        deformations_(points.size(), {dealii::unit_symmetric_tensor<3>()}),
        responses_(points.size())
  {
    points_.pack(0, start_);
  }
  ~SmallProbe() { points_.unpack(0, start_); }
  SmallProbe(const SmallProbe &) = delete;
  SmallProbe &operator=(const SmallProbe &) = delete;

  void put_back() { points_.unpack(0, start_); }
  /// Strains the point [-] and keeps the answer; false if it failed.
  bool move(const Six &strain)
  {
    if (turn_)
      turn_();
    points_.begin_attempt();
    deformations_[0].relative_F = path::stretch(strain);
    points_.evaluate(deformations_, Want::stress, responses_);
    if (responses_[0].status == Status::failed)
      return false;
    points_.commit();
    return true;
  }
  const SymmetricTensor &stress() const { return responses_[0].stress; }

private:
  MaterialPoints &points_;
  const std::function<void()> &turn_;
  std::vector<char> start_;
  std::vector<Deformation> deformations_;
  std::vector<Response> responses_;
};

Six scaled(const Six &strain, double factor)
{
  Six result = strain;
  for (double &value : result)
    value *= factor;
  return result;
}

// Strains of equivalent strain 1 at constant volume: sqrt(2/3 e:e) = 1.
constexpr double shear = 0.8660254037844386;
constexpr std::array<Six, 6> directions{{{1, -0.5, -0.5, 0, 0, 0},
                                         {-0.5, 1, -0.5, 0, 0, 0},
                                         {-0.5, -0.5, 1, 0, 0, 0},
                                         {0, 0, 0, shear, 0, 0},
                                         {0, 0, 0, 0, shear, 0},
                                         {0, 0, 0, 0, 0, shear}}};

double product(const SymmetricTensor &stress, const Six &strain)
{
  const Six six = path::components(stress);
  double sum = 0;
  for (unsigned i = 0; i < 6; ++i)
    sum += (i < 3 ? 1 : 2) * six[i] * strain[i];
  return sum;
}

// Six of a change of volume [-].
Six dilation(double strain)
{
  return {strain / 3, strain / 3, strain / 3, 0, 0, 0};
}

std::optional<double> bulk_modulus(SmallProbe &probe, double strain)
{
  probe.put_back();
  if (!probe.move({}))
    return {};
  const double loaded = trace(probe.stress()) / 3;
  if (!probe.move(dilation(strain)))
    return {};
  const double unloaded = trace(probe.stress()) / 3;
  if (!probe.move(dilation(-strain)))
    return {};
  const double again = trace(probe.stress()) / 3;
  return (2 * unloaded - loaded - again) / (2 * strain);
}

std::optional<double>
shear_modulus(SmallProbe &probe, const Six &direction, double strain)
{
  probe.put_back();
  if (!probe.move(dilation(strain)))
    return {};
  const double before = product(probe.stress(), direction);
  const Six way = scaled(direction, before > 0 ? -strain : strain);
  if (!probe.move(way))
    return {};
  const double turned = product(probe.stress(), direction);
  if (!probe.move(scaled(way, -1)))
    return {};
  const double again = product(probe.stress(), direction);
  // ds : d = 2 G strain d : d, and d : d = 3/2.
  return std::abs(2 * turned - before - again) / (6 * strain);
}
} // namespace

std::optional<MeasuredModuli> measure_moduli(MaterialPoints &points,
                                             double strain,
                                             const std::function<void()> &turn)
{
  SmallProbe probe(points, turn);
  if (!probe.move({}))
    return {};
  MeasuredModuli moduli;
  moduli.pressure = -trace(probe.stress()) / 3;
  const auto bulk = bulk_modulus(probe, strain);
  if (!bulk)
    return {};
  moduli.bulk = *bulk;
  // Three directions along axes span two dimensions of strain, the shears one
  // each: five in all.
  for (unsigned i = 0; i < 6; ++i) {
    const auto value = shear_modulus(probe, directions[i], strain);
    if (!value)
      return {};
    moduli.shear += *value * (i < 3 ? 2. / 15 : 1. / 5);
  }
  return moduli;
}

ModuliOverPressure::ModuliOverPressure(std::vector<MeasuredModuli> measured)
    : measured_(std::move(measured))
{
  std::ranges::sort(measured_, {}, &MeasuredModuli::pressure);
}

MeasuredModuli ModuliOverPressure::at(double pressure) const
{
  const auto above = std::ranges::upper_bound(
      measured_, pressure, {}, &MeasuredModuli::pressure);
  if (above == measured_.begin() || above == measured_.end()) {
    MeasuredModuli nearest =
        above == measured_.end() ? measured_.back() : measured_.front();
    nearest.pressure = pressure;
    return nearest;
  }
  const MeasuredModuli &low = *std::prev(above), &high = *above;
  const double share = std::log(pressure / low.pressure) /
                       std::log(high.pressure / low.pressure);
  const auto between = [share](double a, double b) {
    return a * std::pow(b / a, share);
  };
  return {
      pressure, between(low.bulk, high.bulk), between(low.shear, high.shear)};
}
} // namespace tamp::fem
