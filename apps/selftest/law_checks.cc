// SPDX-License-Identifier: BSD-3-Clause
#include <apps/selftest/self_checks.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/elastic.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/modified_cam_clay.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
using namespace fem;
using Checks = std::vector<SelfCheck>;

/// One point of a law that is taken along logarithmic strains.
template <class Law>
struct Point {
  ContinuumPoints<Law> points;
  double p = 0, q = 0, ratio = 0; ///< stress, compression positive [Pa]

  explicit Point(const Law &law) : points(law, 1) {}

  /// Compressions along the axis and across, in equal parts.
  void press(double axial, double lateral, int parts)
  {
    Deformation part;
    part.relative_F[0][0] = part.relative_F[1][1] = std::exp(-lateral / parts);
    part.relative_F[2][2] = std::exp(-axial / parts);
    Response now;
    for (int k = 0; k < parts; ++k) {
      points.evaluate({&part, 1}, Want::stress, {&now, 1});
      if (now.status == Status::failed)
        throw std::runtime_error(std::string(Law::name) + " failed");
      points.commit();
    }
    p = -trace(now.stress) / 3;
    q = std::sqrt(1.5) * deviator(now.stress).norm();
    ratio = now.stress[0][0] / now.stress[2][2];
  }
  const typename Law::State &state() const { return points.state(0); }
};

void elastic_column(Checks &checks)
{
  constexpr double rounding = 1e-12, E = 1e9, nu = .3;
  ElasticParameters parameters;
  parameters.elasticity = {E, nu};
  Point point{Elastic(parameters)};
  point.press(.05, 0, 1);
  const double axial = point.p + 2. / 3 * point.q;
  checks.push_back({"elastic, uniaxial: stress / (E ln(h_0 / h))",
                    axial / (E * .05),
                    (1 - nu) / ((1 + nu) * (1 - 2 * nu)),
                    rounding,
                    "Hooke"});
}

/// A nearly rigid, perfectly plastic cap under uniaxial strain: the radial
/// plastic strain rate vanishes, which fixes the point of the cap.
void cap_in_a_die(Checks &checks)
{
  constexpr double digits = 1e-5; // as below
  const std::string source = "Abaqus cap; flow without radial strain";
  DruckerPragerCapParameters parameters;
  parameters.elasticity = {1e12, .2};
  parameters.cohesion = 2e6;
  parameters.friction_angle = 55 * std::numbers::pi / 180;
  parameters.eccentricity = .6;
  parameters.transition = .03;
  // p_a = 40 MPa.
  parameters.hardening =
      40e6 * (1 + .6 * std::tan(55 * std::numbers::pi / 180)) + .6 * 2e6;
  Point point{DruckerPragerCap(parameters)};
  point.press(.05, 0, 50);
  checks.push_back(
      {"cap in a die: p [MPa]", point.p / 1e6, 64.0265, digits, source});
  checks.push_back({"  q [MPa]", point.q / 1e6, 42.5309, digits, source});
  checks.push_back(
      {"  radial / axial stress", point.ratio, .5396, 1e-4, source});
}

void cam_clay(Checks &checks)
{
  constexpr double exact = 1e-9; // rounding, and the return's 1e-11
  constexpr double near = 1e-6;  // what is left of the way to critical state
  const std::string source = "Muir Wood (1990)";
  const ModifiedCamClayParameters c;
  Point point{ModifiedCamClay(c)};
  point.press(.1, .1, 10);
  const double first = 1 / point.state().relative_density, p_first = point.p;
  point.press(.1, .1, 10);
  checks.push_back({"Cam-Clay, isotropic: -dv / d ln p over lambda",
                    (first - 1 / point.state().relative_density) /
                        std::log(point.p / p_first) / c.compression_index,
                    1,
                    exact,
                    source});
  const double before = point.p;
  point.press(.64, -.32, 100);
  checks.push_back({"  at constant volume: q / p over M",
                    point.q / point.p / c.critical_state_slope,
                    1,
                    near,
                    source});
  const double exponent =
      (c.compression_index - c.swelling_index) / c.compression_index;
  checks.push_back({"  p / p at the start, times 2^(1 - kappa / lambda)",
                    point.p / before * std::pow(2, exponent),
                    1,
                    near,
                    source});
}

void metal_powder(Checks &checks)
{
  constexpr double balanced = 1e-4; // tolerance of the integration
  FkmGursonParameters parameters;
  const double solid = parameters.solid_yield_stress;
  Point point{FkmGurson(parameters)};
  point.press(.02, .02, 20);
  const double D = 1 - point.state().porosity;
  checks.push_back({"metal powder, isotropic: p / FKM's p_y",
                    point.p / (2.97 * D * D * solid * (D - .64) / .36),
                    1,
                    balanced,
                    "Fleck, Kuhn & McMeeking (1992)"});
  point.press(.095, .095, 95);
  checks.push_back(
      {"  denser than 0.9: p / Gurson's",
       point.p / (-2. / 3 * solid * std::log(point.state().porosity)),
       1,
       balanced,
       "Gurson (1977)"});
}
} // namespace

std::vector<SelfCheck> check_laws()
{
  Checks checks;
  elastic_column(checks);
  cap_in_a_die(checks);
  cam_clay(checks);
  metal_powder(checks);
  return checks;
}
} // namespace tamp::apps
