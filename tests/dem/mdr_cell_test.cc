// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/mdr.h>
#include <dem/measures.h>
#include <array>
#include <vector>
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
  request.material = {std::atof(std::getenv("EY")) * 50e6, 0.3, 1500, 2.75 * 50e6};
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
  double top = std::atof(std::getenv("TOP")), last_pl = 0, least = 0;
  Matrix3 s0 = Matrix3::Zero();
  while (cell.relative_density() < top) {
    const CellAnswer a =
        deform(cell, std::exp(-part) * Matrix3::Identity(), driving);
    evaluations += a.evaluations;
    least = std::min(least, cell.energy.plastic_dissipation - last_pl);
    last_pl = cell.energy.plastic_dissipation;
    unsettled += a.outcome != Outcome::settled;
    const double p = -a.stress.trace() / 3, D = cell.relative_density();
    if (++k % int(std::round(0.01 / part)) == 0) {
      const CellMeasures mm = measure(cell);
      double growth = 0;
      for (std::size_t i = 0; i < cell.size(); ++i)
        growth += cell.radius[i] / cell.initial_radius_of(i) - 1;
      const EnergyAccount &e = cell.energy;
      std::printf("%.4f p %.5g MPa K/kappa %.3f Z %.2f R/Ro-1 %.4f evals %zu "
                  "uns %d work %.4g el %.4g pl %.4g fr %.4g gap %.3f hm %.1e\n",
                  D, p / 1e6,
                  (p - last_p) / std::log(D / last_d) / (std::atof(std::getenv("EY")) * 50e6 / 1.2),
                  mm.coordination_number, growth / cell.size(), evaluations,
                  unsettled, e.work, mm.elastic_energy, e.plastic_dissipation,
                  e.friction_dissipation,
                  (e.work - mm.elastic_energy - e.plastic_dissipation -
                   e.friction_dissipation) / e.work, a.hill_mandel);
      const Mdr law(std::atof(std::getenv("EY")) * 50e6, 0.3, 50e6);
      std::vector<double> Ah(cell.size(), 0.0), A(cell.size(), 0.0),
          B(cell.size(), 0.0), H(cell.size(), 0.0);
      const std::size_t all = cell.more_memory.size() / cell.contacts.size();
      for (std::size_t c = 0; c < cell.contacts.size(); ++c) {
        const auto [i, j] = cell.contacts[c].pair;
        const double d =
            cell.box.nearest_image(cell.place[j] - cell.place[i]).norm();
        const auto shape = cell.shape(cell.contacts[c].pair);
        std::array<double, Mdr::more> own;
        std::copy_n(cell.more_memory.data() + c * all, Mdr::more, own.begin());
        const double open = 1 - own[Mdr::more - 1];
        const auto sides =
            law.sides(shape.radius_sum - d, shape,
                      {cell.contacts[c].largest_overlap, 0, own.data()});
        if (shape.radius_sum < d)
          continue;
        for (int k : {0, 1}) {
          const std::uint32_t g = k ? j : i;
          const double h = cell.radius[g] - sides[k].overlap;
          A[g] += open * sides[k].area;
          Ah[g] += open * sides[k].area * h;
          B[g] += open * sides[k].area * sides[k].bulk_overlap;
          H[g] += open * sides[k].area * sides[k].overlap;
        }
      }
      double s2 = 0, m = 0, cover = 0;
      for (std::size_t g = 0; g < cell.size(); ++g) {
        const double V = 4. / 3 * M_PI * std::pow(cell.initial_radius_of(g), 3);
        const double part = Ah[g] * Ah[g] / (9 * V * cell.box.volume());
        cover += Ah[g] / 3 / cell.box.volume();
        s2 += part;
        m += part * (1 + 2 * B[g] / H[g]);
      }
      std::printf("   s2 %.3f with areas %.3f cover %.3f\n", s2, m, cover);
      last_p = p;
      last_d = D;
      evaluations = 0;
      unsettled = 0;
    }
    if (a.outcome == Outcome::diverged)
      break;
  }
  std::printf("least pl %.3g\n", least);
  double low = std::atof(std::getenv("LOW"));
  for (int cycle = 0; cycle < 3; ++cycle) {
    for (int way : {1, -1}) {
      double w = 0, g = 0;
      while (way > 0 ? cell.relative_density() > low
                     : cell.relative_density() < top) {
        const double work = cell.energy.work;
        const CellAnswer a = deform(
            cell, std::exp(way * part) * Matrix3::Identity(), driving);
        w += cell.energy.work - work;
        g += a.outcome != Outcome::settled;
      }
      std::printf("cycle %d way %d D %.4f p %.5g work %.5g uns %g pl %.5g el %.4g pl+fr-work+el-0 \n",
                  cycle, way, cell.relative_density(),
                  -love_weber_stress(cell).trace() / 3e6, w, g,
                  cell.energy.plastic_dissipation, elastic_energy(cell));
    }
  }
}
} // namespace tamp::dem
