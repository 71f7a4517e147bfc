// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/measures.h>
#include <dem/motion.h>
#include <dem/stretch.h>
#include <dem/time_step.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

namespace tamp::dem
{
namespace
{
using test::alumina_cell;
using test::compress;

/// The speed of Rayleigh waves over that of shear waves, from the secular
/// equation.
double rayleigh_speed(double poisson)
{
  const double k = (1 - 2 * poisson) / (2 * (1 - poisson));
  const auto residual = [k](double a2) {
    return std::pow(2 - a2, 4) - 16 * (1 - a2) * (1 - k * a2);
  };
  double low = 0.75, high = 0.93; // of alpha^2; the residual rises there
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (low + high);
    (residual(middle) < 0 ? low : high) = middle;
  }
  return std::sqrt(low);
}

TEST(RayleighTimeStep, UsesTheWaveSpeedOfTheSecularEquation)
{
  EXPECT_NEAR(rayleigh_speed(0.3), 0.927413, 1e-6); // published
  for (double poisson : {0.0, 0.1, 0.25, 0.3, 0.4, 0.499}) {
    const GrainMaterial material{70e9, poisson, 2650};
    const double step = rayleigh_time_step(material, 68e-6, 1);
    const double exact = std::numbers::pi * 68e-6 / rayleigh_speed(poisson) *
                         std::sqrt(2650 / material.shear_modulus());
    EXPECT_NEAR(step / exact, 1, 3.1e-3); // error of the fitted line
  }
}

TEST(RayleighTimeStep, IsThatOfThePublishedExample)
{
  // Sheng et al. (2004): E = 70 MPa, diameter 10 um; 0.168 us by their eq (6).
  const GrainMaterial material{70e6, 0.3, 2650};
  EXPECT_NEAR(rayleigh_time_step(material, 5e-6, 1), 0.168e-6, 0.5e-9);
  EXPECT_NEAR(rayleigh_time_step(material, 5e-6, 1e12) /
                  rayleigh_time_step(material, 5e-6, 1),
              1e6,
              1e-6);
}

TEST(DynamicMeasures, NumbersAreThoseOfTheSlowestPublishedRun)
{
  UnitCell cell;
  cell.radius = {68e-6, 132e-6};
  const Dynamics settings; // 1e-5 per second, density scaled by 1e12
  const DynamicMeasures found = measure_dynamics(cell, settings, 100e3);
  EXPECT_NEAR(found.scaling_number, 1.6e-6, 0.05e-6); // two digits published
  // 2.2e-4 with the smallest diameter, 136 um; here the mean, 200 um.
  EXPECT_NEAR(found.inertial_number * 136 / 200, 2.2e-4, 0.05e-4);
  EXPECT_EQ(measure_dynamics(cell, settings, 0).inertial_number, 0);
}

TEST(DynamicMeasures, KineticEnergyCountsTranslationAndSpin)
{
  UnitCell cell;
  cell.radius = {1e-4};
  cell.velocity = {Vector3(3, 0, 4)};
  cell.spin = {Vector3(0, 2e4, 0)};
  Dynamics settings;
  settings.density_scaling = 10;
  const double mass =
      10 * 2650 * 4.0 / 3 * std::numbers::pi * std::pow(1e-4, 3);
  const double wanted = 0.5 * mass * 25 + 0.5 * 0.4 * mass * 1e-8 * 4e8;
  EXPECT_NEAR(measure_dynamics(cell, settings, 1).kinetic_energy,
              wanted,
              1e-12 * wanted);
}

Driving driven(double rate)
{
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = rate;
  return driving;
}

TEST(Dynamics, BoxIsExactlyStretched)
{
  UnitCell cell = alumina_cell();
  Matrix3 strain;
  strain << -1, .4, .1, .4, -.3, -.2, .1, -.2, .2;
  const Stretch stretch = exponential(1e-3 * strain);
  const Matrix3 wanted = stretch * cell.box.h;
  deform(cell, stretch, driven(1e-3));
  EXPECT_LT((cell.box.h - wanted).norm(), 1e-14 * wanted.norm());
}

TEST(Dynamics, SameRunGivesTheSameBits)
{
  UnitCell a = alumina_cell(), b = alumina_cell();
  compress(a, -1e-3, 2, driven(1e-4));
  compress(b, -1e-3, 2, driven(1e-4));
  EXPECT_EQ(a, b);
}

TEST(Dynamics, StepsFollowTheRate)
{
  UnitCell a = alumina_cell(), b = alumina_cell();
  const std::size_t fast = compress(a, -1e-3, 1, driven(1e-3)).evaluations;
  const std::size_t slow = compress(b, -1e-3, 1, driven(1e-4)).evaluations;
  EXPECT_NEAR(double(slow) / double(fast), 10, 10.0 / double(fast));
}

/// What a cell holds and what it has lost, without the work [J].
double held_and_lost(const UnitCell &cell, const Driving &driving)
{
  const EnergyAccount &spent = cell.energy;
  return measure(cell).elastic_energy +
         measure_dynamics(cell, driving.dynamics, 1).kinetic_energy +
         spent.plastic_dissipation + spent.friction_dissipation +
         spent.damping_dissipation;
}

TEST(Dynamics, WorkIsStoredDissipatedOrKinetic)
{
  PackingRequest request = test::alumina_request();
  request.grain_count = 300;
  const UnitCell packing = make_packing(request);
  for (double rate : {1e-4, 1e-3}) {
    UnitCell cell = packing;
    const Driving driving = driven(rate);
    const double before = held_and_lost(cell, driving) - cell.energy.work;
    const double work_before = cell.energy.work;
    compress(cell, -0.1, 20, driving);
    const double work = cell.energy.work - work_before;
    EXPECT_GT(work, 0);
    // What time steps and the loss of sliding, which is booked with the
    // contact radius of the end of a step, leave open.
    EXPECT_NEAR(
        held_and_lost(cell, driving) - cell.energy.work, before, 0.01 * work);
  }
}

TEST(Dynamics, SmoothElasticGrainsLoseNothingButByDamping)
{
  for (const auto &[damping, local] :
       {std::pair(0.0, 0.0), {0.05, 0.0}, {0.0, 0.3}}) {
    UnitCell cell = test::smooth_elastic_cell();
    Driving driving = driven(1e-4);
    driving.dynamics.global_damping = damping;
    driving.dynamics.local_damping = local;
    driving.dynamics.time_step_fraction = 0.02;
    const double before = held_and_lost(cell, driving) - cell.energy.work;
    const double work_before = cell.energy.work;
    compress(cell, -0.01, 5, driving);
    EXPECT_EQ(cell.energy.plastic_dissipation, 0);
    EXPECT_EQ(cell.energy.friction_dissipation, 0);
    EXPECT_EQ(cell.energy.damping_dissipation > 0, damping + local > 0);
    // Trapezoids of force and work over steps of 2e-2 Rayleigh steps.
    EXPECT_NEAR(held_and_lost(cell, driving) - cell.energy.work,
                before,
                1e-6 * (cell.energy.work - work_before));
  }
}

/// Two equal smooth grains that meet head on, in a resting box: the speed after
/// over that before.
double rebound(double local_damping)
{
  UnitCell cell;
  cell.materials = {{70e9, 0.3, 2650}};
  cell.contact.normal_law = NormalLaw::hertz;
  cell.contact.tangential_law = TangentialLaw::none;
  cell.box.h = 2e-3 * Matrix3::Identity();
  cell.radius = {1e-4, 1e-4};
  cell.species = {0, 0};
  cell.place = {{0.5, 0.5, 0.4495}, {0.5, 0.5, 0.5500}};
  cell.velocity = {{0, 0, 1}, {0, 0, -1}};
  cell.spin = {Vector3::Zero(), Vector3::Zero()};
  Dynamics settings;
  settings.density_scaling = 1;
  settings.global_damping = 0;
  settings.local_damping = local_damping;
  const auto motion = start_motion(cell, settings, {});
  // They touch after 0.5 us, for 0.6 us.
  EXPECT_TRUE(motion->advance(Matrix3::Zero(), 2000, 1e-9));
  return cell.velocity[1].z();
}

TEST(Dynamics, LocalDampingIsARestitution)
{
  // Cundall (1987): e^2 = (1 - a) / (1 + a). The step in which grains turn back
  // is one of 600.
  for (double damping : {0.0, 0.3, 0.7})
    EXPECT_NEAR(
        rebound(damping), std::sqrt((1 - damping) / (1 + damping)), 2e-3);
}

TEST(Dynamics, MomentumIsConserved)
{
  UnitCell cell = test::alumina_cell();
  Driving driving = driven(1e-3);
  driving.dynamics.global_damping = 0; // which holds on to the places
  compress(cell, -0.01, 2, driving);
  Vector3 momentum = Vector3::Zero();
  double traffic = 0;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    momentum += cell.mass(i) * cell.velocity[i];
    traffic += cell.mass(i) * cell.velocity[i].norm();
  }
  ASSERT_GT(traffic, 0);
  EXPECT_LT(momentum.norm(), 1e-10 * traffic); // round-off of many steps
}

TEST(Dynamics, ADrivenPathMayBeCutAnywhere)
{
  // Velocities of whole steps stay in the cell: a path in pieces is the path
  // in one piece but for the length of the time steps, of which either has
  // thousands.
  UnitCell whole = test::alumina_cell(), pieces = whole;
  compress(whole, -2e-3, 1, driven(1e-5));
  compress(pieces, -2e-3, 20, driven(1e-5));
  const Matrix3 a = measure(whole).stress, b = measure(pieces).stress;
  EXPECT_LT((a - b).norm(), 1e-3 * a.norm());
}

TEST(Dynamics, SlowerDrivingChangesLess)
{
  const auto stress = [](double rate) {
    UnitCell cell = alumina_cell();
    return compress(cell, -0.01, 1, driven(rate)).stress;
  };
  const Matrix3 fast = stress(1.6e-2), slow = stress(4e-4),
                slower = stress(1e-5);
  EXPECT_LT((slow - slower).norm(), 0.5 * (fast - slow).norm());
  // Where rates are slow they no longer matter: to the scatter of dynamics.
  EXPECT_LT((slow - slower).norm(), 0.05 * slower.norm());
}

/// Soft grains with damping in the contacts.
UnitCell damped_cell(double restitution)
{
  PackingRequest request = test::alumina_request();
  request.material.youngs_modulus = 70e6;
  request.contact.normal_law = NormalLaw::hertz;
  UnitCell cell = make_packing(request);
  cell.contact.restitution_coefficient = restitution;
  return cell;
}

/// Axial stress after 2 % of strain with a step that is a share of the Rayleigh
/// step [Pa].
double stress_with_step(UnitCell cell, double rayleigh_share)
{
  Driving driving = driven(5e-4);
  driving.dynamics.global_damping = 0;
  driving.dynamics.density_scaling = 1e8;
  const auto motion = start_motion(cell, driving.dynamics, driving.arithmetic);
  const double step =
      rayleigh_share * rayleigh_time_step(cell.materials[0],
                                          cell.smallest_radius(),
                                          driving.dynamics.density_scaling);
  Matrix3 strain = Matrix3::Zero();
  strain(1, 1) = -0.02;
  const double steps = 0.02 / (driving.dynamics.strain_rate * step);
  EXPECT_TRUE(motion->advance(strain, std::size_t(steps), step));
  return motion->stress()(1, 1);
}

TEST(Dynamics, StepBoundCountsHeavyContactDamping)
{
  const UnitCell cell = damped_cell(0.2);
  const double fine = stress_with_step(cell, 0.05);
  // A fifth of the Rayleigh step, fine for elastic contacts, loses stress.
  EXPECT_LT(stress_with_step(cell, 0.2) / fine, 0.6);
  EXPECT_NEAR(stress_with_step(damped_cell(0.9), 0.2) / fine, 1, 0.01);
  // A larger share, but of the bound as well, gives the stress of fine steps.
  UnitCell bounded = cell;
  Driving driving = driven(5e-4);
  driving.dynamics.global_damping = 0;
  driving.dynamics.density_scaling = 1e8;
  driving.dynamics.time_step_fraction = 0.5;
  EXPECT_NEAR(
      compress(bounded, -0.02, 1, driving).stress(1, 1) / fine, 1, 0.01);
}

TEST(Dynamics, WildStretchDiverges)
{
  UnitCell cell = alumina_cell();
  EXPECT_EQ(deform(cell, test::uniaxial(std::log(0.49)), driven(1e3)).outcome,
            Outcome::diverged);
}
} // namespace
} // namespace tamp::dem
