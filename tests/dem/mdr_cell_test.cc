// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

namespace tamp::dem
{
TEST(Explore, Curve)
{
  const char *law = std::getenv("LAW");
  PackingRequest request;
  request.grain_count = 100;
  request.material = {1e9, 0.3, 1500, 2.75 * 50e6};
  request.sizes.minimum_diameter = 150e-6;
  request.sizes.maximum_diameter = 250e-6;
  request.contact.normal_law =
      law && law[0] == 't' ? NormalLaw::thornton_ning : NormalLaw::mdr;
  if (std::getenv("ONSET"))
    request.contact.bulk_onset = std::atof(std::getenv("ONSET"));
  if (std::getenv("MU"))
    request.contact.friction_coefficient = std::atof(std::getenv("MU"));
  request.goal.pressure = 0.2e6;
  UnitCell cell = make_packing(request);
  const double part = std::atof(std::getenv("PART"));
  Driving driving;
  if (std::getenv("MIXED"))
    driving.arithmetic.precision = Precision::mixed;
  driving.quasi_static.maximum_strain_increment = 1;
  double last_p = 0, last_d = 1;
  std::size_t evaluations = 0;
  int k = 0, unsettled = 0;
  while (cell.relative_density() < 1.05) {
    const CellAnswer a =
        deform(cell, std::exp(-part) * Matrix3::Identity(), driving);
    evaluations += a.evaluations;
    unsettled += a.outcome != Outcome::settled;
    const double p = -a.stress.trace() / 3, D = cell.relative_density();
    if (++k % int(std::round(0.01 / part)) == 0) {
      const CellMeasures m = measure(cell);
      double growth = 0;
      for (std::size_t i = 0; i < cell.size(); ++i)
        growth += cell.radius[i] / cell.initial_radius_of(i) - 1;
      const EnergyAccount &e = cell.energy;
      std::printf("%.4f p %.5g MPa K/kappa %.3f Z %.2f R/Ro-1 %.4f evals %zu "
                  "uns %d work %.4g el %.4g pl %.4g fr %.4g gap %.3f hm %.1e\n",
                  D, p / 1e6,
                  (p - last_p) / std::log(D / last_d) / (1e9 / 1.2),
                  m.coordination_number, growth / cell.size(), evaluations,
                  unsettled, e.work, m.elastic_energy, e.plastic_dissipation,
                  e.friction_dissipation,
                  (e.work - m.elastic_energy - e.plastic_dissipation -
                   e.friction_dissipation) / e.work, a.hill_mandel);
      last_p = p;
      last_d = D;
      evaluations = 0;
      unsettled = 0;
    }
    if (a.outcome == Outcome::diverged)
      break;
  }
}
} // namespace tamp::dem
