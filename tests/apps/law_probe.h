// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_apps_law_probe_h
#define tests_apps_law_probe_h

#include <apps/output/curve_writer.h>
#include <apps/output/probe_columns.h>
#include <fem/laws/cap_surface.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/material_points.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What a law is driven through to look like a folder of tamp probe.
struct LawProbe {
  bool isotropic = false;
  double last_density = 0.8;
  std::vector<double> scans; ///< relative densities under load
  /// Pressures of shear points over the reached one.
  std::vector<double> shares{0.03, 0.06, 0.12};
  bool moduli = true;
  bool unload = true;
  int replica = 0;
};

inline dealii::Tensor<2, 3> stretch(bool isotropic, double strain)
{
  dealii::Tensor<2, 3> F = dealii::unit_symmetric_tensor<3>();
  F[2][2] = std::exp(-strain);
  if (isotropic)
    F[0][0] = F[1][1] = F[2][2] = std::exp(-strain / 3);
  return F;
}

/// K and G from small strains after a small relief, so that nothing yields.
template <class Law>
std::vector<double> elastic_moduli(const Law &law,
                                   const typename Law::State &state)
{
  const auto take = [&](const auto &old, auto &now, const auto &F) {
    return law.respond(old, now, {F}, fem::Want::stress).stress;
  };
  typename Law::State relieved = state, end = state;
  const auto before = take(state, relieved, stretch(true, -2e-5));
  const auto after = take(relieved, end, stretch(true, -2e-5));
  dealii::Tensor<2, 3> shear = dealii::unit_symmetric_tensor<3>();
  shear[0][1] = shear[1][0] = 1e-6;
  const auto sheared = take(end, relieved, shear);
  return {trace(after - before) / 3 / 2e-5,
          (sheared[0][1] - after[0][1]) / 2e-6};
}

/// q at yield of a state of the law at a pressure, from its surface itself.
inline double yield_deviator(const fem::DruckerPragerCap &law,
                             const fem::DruckerPragerCap::State &state,
                             double pressure)
{
  const auto surface = law.surface(state.plastic_compaction);
  const double off = (pressure - surface.centre) / surface.radius();
  return off < 0 ? surface.shear_limit(pressure)
                 : surface.top() * std::sqrt(std::max(0., 1 - off * off));
}
template <class Law>
double yield_deviator(const Law &law,
                      const typename Law::State &state,
                      double pressure)
{
  return law.surface(state).shear_limit(pressure);
}

inline double yield_deviator(const fem::FkmGurson &law,
                             const fem::FkmGurson::State &state,
                             double pressure)
{
  return law.surface(state.porosity).shear_limit(pressure);
}

/// Writes curve.csv, yield.csv and moduli.csv of a law in `folder`.
template <class Law>
class LawProbeFolder
{
public:
  LawProbeFolder(const Law &law,
                 const LawProbe &probe,
                 const std::filesystem::path &folder)
      : law_(law), probe_(probe), state_(law.initial_state()),
        folder_((std::filesystem::create_directories(folder), folder)),
        curve_(folder / "curve.csv", probe_header()),
        yields_(folder / "yield.csv", yield_header()),
        moduli_(folder / "moduli.csv", moduli_header())
  {
    record_.F = dealii::unit_symmetric_tensor<3>();
    auto scan = probe.scans.begin();
    while (state_.relative_density < probe.last_density) {
      step(2e-3);
      if (scan != probe.scans.end() && state_.relative_density >= *scan) {
        look();
        ++scan;
      }
    }
    const double peak = -state_.stress[2][2];
    while (probe.unload && -state_.stress[2][2] > 0.3 * peak)
      step(-1e-4);
    if (!probe.moduli)
      std::filesystem::remove(folder / "moduli.csv");
  }

private:
  void step(double strain)
  {
    const auto F = stretch(probe_.isotropic, strain);
    const typename Law::State old = state_;
    record_.response = law_.respond(old, state_, {F}, fem::Want::stress);
    record_.F = F * record_.F;
    ++record_.step;
    curve_.write(probe_values(record_));
  }

  void look()
  {
    const double p = fem::pressure(state_.stress),
                 q = fem::deviatoric_stress(state_.stress),
                 number = probe_.replica, density = state_.relative_density;
    for (std::size_t branch = 0; branch < probe_.shares.size(); ++branch)
      for (const double criterion : {0., 1., 2.}) {
        const double at = probe_.shares[branch] * p;
        yields_.write(std::vector<double>{number,
                                          density,
                                          p,
                                          q,
                                          double(branch),
                                          criterion,
                                          at,
                                          yield_deviator(law_, state_, at),
                                          -1e-4,
                                          5e-4});
      }
    const auto found = elastic_moduli(law_, state_);
    const double K = found[0], G = found[1];
    moduli_.write(std::vector<double>{number,
                                      density,
                                      p,
                                      K,
                                      G,
                                      9 * K * G / (3 * K + G),
                                      (3 * K - 2 * G) / (6 * K + 2 * G)});
  }

  const Law &law_;
  LawProbe probe_;
  typename Law::State state_;
  std::filesystem::path folder_;
  fem::PathRecord record_;
  CurveWriter curve_, yields_, moduli_;
};

template <class Law>
void write_law_probe(const Law &law,
                     const LawProbe &probe,
                     const std::filesystem::path &folder)
{
  const LawProbeFolder<Law> written(law, probe, folder);
}
} // namespace tamp::apps

#endif
