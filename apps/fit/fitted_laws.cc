// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/fitted_laws.h>

#include <algorithm>
#include <cmath>

namespace tamp::apps
{
namespace
{
double poissons_ratio(const ModuliPoint &moduli)
{
  const double K = moduli.bulk_modulus, G = moduli.shear_modulus;
  return std::clamp((3 * K - 2 * G) / (2 * (3 * K + G)), 0.01, 0.45);
}

double youngs_modulus(const ModuliPoint &moduli)
{
  const double K = moduli.bulk_modulus, G = moduli.shear_modulus;
  return 9 * K * G / (3 * K + G);
}

ModuliPoint moduli_from(double bulk, double nu)
{
  ModuliPoint moduli;
  moduli.bulk_modulus = bulk;
  moduli.shear_modulus = 1.5 * (1 - 2 * nu) / (1 + nu) * bulk;
  return moduli;
}

double pressure_of(const dealii::SymmetricTensor<2, 3> &stress)
{
  return -trace(stress) / 3;
}
} // namespace

std::array<Unknown, CamClayUnknowns::count>
CamClayUnknowns::unknowns(const FirstGuess &guess)
{
  const double M = 1.5;
  // p_c of a state on the surface.
  const auto yield = [&](const PathPoint &point) {
    return point.pressure + std::pow(point.deviatoric_stress / M, 2) /
                                std::max(point.pressure, 1e-300);
  };
  const double lambda =
      (1 / guess.early.relative_density - 1 / guess.late.relative_density) /
      std::log(yield(guess.late) / yield(guess.early));
  const double kappa =
      std::min(0.5 * lambda,
               guess.late.pressure /
                   (guess.late.relative_density * guess.stiff.bulk_modulus));
  const double first =
      std::log(yield(guess.early)) -
      (1 / guess.initial_density - 1 / guess.early.relative_density) / lambda;
  return {Unknown{M, 0.1, 2.99},
          Unknown{std::log(lambda - kappa), -12, 3},
          Unknown{std::log(kappa), -15, 2},
          Unknown{poissons_ratio(guess.stiff), -0.5, 0.49},
          Unknown{first, first - 20, first + 20}};
}

CamClayUnknowns::Law CamClayUnknowns::law(const FirstGuess &guess,
                                          const double *unknowns)
{
  fem::ModifiedCamClayParameters law;
  law.critical_state_slope = unknowns[0];
  law.swelling_index = std::exp(unknowns[2]);
  law.compression_index = law.swelling_index + std::exp(unknowns[1]);
  law.poissons_ratio = unknowns[3];
  law.initial_yield_pressure = std::exp(unknowns[4]);
  law.initial_relative_density = guess.initial_density;
  return Law(law);
}

std::vector<NamedConstant> CamClayUnknowns::constants(const Law &law)
{
  const auto &p = law.parameters();
  return {{"Initial relative density", "-", p.initial_relative_density},
          {"Initial yield pressure", "Pa", p.initial_yield_pressure},
          {"Critical state slope", "-", p.critical_state_slope},
          {"Compression index", "-", p.compression_index},
          {"Swelling index", "-", p.swelling_index},
          {"Poisson's ratio", "-", p.poissons_ratio}};
}

ModuliPoint CamClayUnknowns::moduli(const Law &law, const Law::State &state)
{
  const auto &p = law.parameters();
  return moduli_from(std::max(pressure_of(state.stress), p.floor_pressure) /
                         (state.relative_density * p.swelling_index),
                     p.poissons_ratio);
}

double
CamClayUnknowns::shear_limit(const Law &law, const Law::State &state, double p)
{
  return law.surface(state).shear_limit(p);
}

double CamClayUnknowns::yield_pressure(const Law & /* law */,
                                       const Law::State &state)
{
  return state.yield_pressure;
}

coupling::MaterialChoice CamClayUnknowns::material(const Law &law)
{
  coupling::MaterialChoice choice;
  choice.kind = coupling::MaterialKind::modified_cam_clay;
  choice.cam_clay = law.parameters();
  return choice;
}

std::array<Unknown, FkmGursonUnknowns::count>
FkmGursonUnknowns::unknowns(const FirstGuess &guess)
{
  const double random = std::min(0.64, 0.97 * guess.early.relative_density);
  const double D = guess.late.relative_density;
  const double strength =
      guess.late.pressure / (2.97 * D * D * (D - random) / (1 - random));
  const double soft = youngs_modulus(guess.soft),
               stiff = youngs_modulus(guess.stiff),
               apart =
                   guess.stiff.relative_density - guess.soft.relative_density;
  const double exponent =
      apart > 1e-3 ? std::clamp(std::log(stiff / soft) / apart, 0., 40.) : 7;
  const double solid =
      std::log(stiff) + exponent * (1 - guess.stiff.relative_density);
  return {Unknown{std::log(strength),
                  std::log(strength) - 7,
                  std::log(strength) + 7},
          Unknown{solid, solid - 7, solid + 7},
          Unknown{poissons_ratio(guess.stiff), -0.5, 0.49},
          Unknown{exponent, 0, 50},
          Unknown{random, 0.1, 0.769}};
}

FkmGursonUnknowns::Law FkmGursonUnknowns::law(const FirstGuess &guess,
                                              const double *unknowns)
{
  fem::FkmGursonParameters law;
  law.solid_yield_stress = std::exp(unknowns[0]);
  law.solid_youngs_modulus = std::exp(unknowns[1]);
  law.solid_poissons_ratio = unknowns[2];
  law.elastic_exponent = unknowns[3];
  law.random_packing_density = unknowns[4];
  law.initial_relative_density = guess.initial_density;
  return Law(law);
}

std::vector<NamedConstant> FkmGursonUnknowns::constants(const Law &law)
{
  const auto &p = law.parameters();
  return {{"Initial relative density", "-", p.initial_relative_density},
          {"Random packing density", "-", p.random_packing_density},
          {"Solid yield stress", "Pa", p.solid_yield_stress},
          {"Solid Young's modulus", "Pa", p.solid_youngs_modulus},
          {"Solid Poisson's ratio", "-", p.solid_poissons_ratio},
          {"Elastic exponent", "-", p.elastic_exponent}};
}

ModuliPoint FkmGursonUnknowns::moduli(const Law &law, const Law::State &state)
{
  const auto &p = law.parameters();
  const double nu = p.solid_poissons_ratio;
  const double E =
      p.solid_youngs_modulus * std::exp(-p.elastic_exponent * state.porosity);
  return moduli_from(E / (3 * (1 - 2 * nu)), nu);
}

double FkmGursonUnknowns::shear_limit(const Law &law,
                                      const Law::State &state,
                                      double p)
{
  return law.surface(state.porosity).shear_limit(p);
}

double FkmGursonUnknowns::yield_pressure(const Law &law,
                                         const Law::State &state)
{
  return law.surface(state.porosity).largest_pressure();
}

coupling::MaterialChoice FkmGursonUnknowns::material(const Law &law)
{
  coupling::MaterialChoice choice;
  choice.kind = coupling::MaterialKind::fkm_gurson;
  choice.fkm_gurson = law.parameters();
  return choice;
}
} // namespace tamp::apps
