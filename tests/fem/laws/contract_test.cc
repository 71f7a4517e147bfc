// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/elastic.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/mcc_ph102.h>
#include <fem/laws/modified_cam_clay.h>
#include <tests/contract/material_points_contract.h>

namespace tamp::fem::contract
{
namespace
{
dealii::Tensor<2, 3> gradient(const std::array<double, 9> &entries)
{
  dealii::Tensor<2, 3> F;
  for (unsigned i = 0; i < 9; ++i)
    F[i / 3][i % 3] = entries[i] + (i % 4 == 0 ? 1 : 0);
  return F;
}

/// Compression along z with some shear.
std::vector<dealii::Tensor<2, 3>> press(const unsigned steps)
{
  return std::vector<dealii::Tensor<2, 3>>(
      steps, gradient({-1e-3, 0, 1e-3, 5e-4, 1e-3, 0, 0, 1e-3, -1e-2}));
}

/// Pressed, then unloaded along z to the shear line or close to it.
std::vector<dealii::Tensor<2, 3>> press_and_unload(const unsigned steps)
{
  auto path = press(30);
  path.insert(path.end(), steps, gradient({0, 0, 0, 0, 0, 0, 0, 0, 1e-3}));
  return path;
}

std::unique_ptr<MaterialPoints> cap_points(const double transition)
{
  DruckerPragerCapParameters parameters;
  parameters.transition = transition;
  return std::make_unique<ContinuumPoints<DruckerPragerCap>>(
      DruckerPragerCap(parameters), 3);
}
} // namespace

struct PorousElastic {
};
template <>
struct ContractTraits<PorousElastic> : ContractDefaults {
  static std::unique_ptr<MaterialPoints> make()
  {
    ElasticParameters parameters;
    parameters.elasticity = {mcc_ph102::youngs_modulus(),
                             mcc_ph102::poissons_ratio()};
    return std::make_unique<ContinuumPoints<Elastic>>(Elastic(parameters), 3);
  }
  static std::vector<dealii::Tensor<2, 3>> path() { return press(5); }
  static dealii::Tensor<2, 3> next()
  {
    return gradient({-2e-3, 1e-3, 0, 0, 3e-3, 4e-3, -1e-3, 0, -8e-3});
  }
};

struct OnCap {
};
template <>
struct ContractTraits<OnCap> : ContractDefaults {
  static std::unique_ptr<MaterialPoints> make() { return cap_points(0); }
  static std::vector<dealii::Tensor<2, 3>> path() { return press(20); }
  static dealii::Tensor<2, 3> next()
  {
    return gradient({-2e-4, 1e-4, 0, 0, 3e-4, 4e-4, -1e-4, 0, -9e-4});
  }
};

struct OnCapInParts : OnCap {
};
template <>
struct ContractTraits<OnCapInParts> : ContractTraits<OnCap> {
  static dealii::Tensor<2, 3> next()
  {
    return gradient({-2e-3, 1e-3, 0, 0, 3e-3, 4e-3, -1e-3, 0, -9e-3});
  }
};

struct OnShear {
};
template <>
struct ContractTraits<OnShear> : ContractTraits<OnCap> {
  static std::vector<dealii::Tensor<2, 3>> path()
  {
    return press_and_unload(40);
  }
  static dealii::Tensor<2, 3> next()
  {
    return gradient({3e-3, 4e-3, 0, -3e-3, 1e-3, 5e-3, 0, -4e-3, 5e-3});
  }
};

struct OnTransition {
};
template <>
struct ContractTraits<OnTransition> : ContractTraits<OnCap> {
  static std::unique_ptr<MaterialPoints> make() { return cap_points(0.02); }
  static std::vector<dealii::Tensor<2, 3>> path()
  {
    auto path = press_and_unload(20);
    const auto shear = gradient({-5e-4, 0, 0, 0, -5e-4, 0, 0, 0, 1e-3});
    path.insert(path.end(), 45, shear);
    return path;
  }
  static dealii::Tensor<2, 3> next()
  {
    return gradient({-5e-4, 3e-4, 0, 2e-4, -4e-4, 0, 0, -1e-3, 1e-3});
  }
};

struct OnApex {
};
template <>
struct ContractTraits<OnApex> : ContractTraits<OnCap> {
  /// The cone has an edge at q = 0: differences err by h |h|.
  static double probe_strain() { return 1e-8; }
  static std::vector<dealii::Tensor<2, 3>> path()
  {
    return std::vector<dealii::Tensor<2, 3>>(5, next());
  }
  static dealii::Tensor<2, 3> next()
  {
    return gradient({5e-3, 0, 0, 0, 5e-3, 0, 0, 0, 5e-3});
  }
};

/// Compacts: hardens.
struct CamClay {
};
template <>
struct ContractTraits<CamClay> : ContractTraits<OnCapInParts> {
  static std::unique_ptr<MaterialPoints> make()
  {
    return std::make_unique<ContinuumPoints<ModifiedCamClay>>(ModifiedCamClay(),
                                                              3);
  }
};

/// Dilates beyond the critical state: softens.
struct CamClaySoftening {
};
template <>
struct ContractTraits<CamClaySoftening> : ContractTraits<CamClay> {
  static std::vector<dealii::Tensor<2, 3>> path()
  {
    auto steps = press(20);
    for (unsigned i = 0; i < 5; ++i) // unloads, shears
      steps.push_back(gradient({2e-2, 0, 0, 0, 2e-2, 0, 0, 0, 0}));
    return steps;
  }
  static dealii::Tensor<2, 3> next()
  {
    return gradient({2e-2, 4e-3, 0, -3e-3, 1e-2, 5e-3, 0, -4e-3, 5e-3});
  }
};

/// A powder of metal spheres that starts at a density.
template <int percent>
struct MetalSpheres {
};
template <int percent>
struct ContractTraits<MetalSpheres<percent>> : ContractTraits<OnCapInParts> {
  static std::unique_ptr<MaterialPoints> make()
  {
    FkmGursonParameters parameters;
    parameters.initial_relative_density = 0.01 * percent;
    return std::make_unique<ContinuumPoints<FkmGurson>>(FkmGurson(parameters),
                                                        3);
  }
  static std::vector<dealii::Tensor<2, 3>> path() { return press(4); }
};

struct MetalSpheresPulled {
};
template <>
struct ContractTraits<MetalSpheresPulled> : ContractTraits<MetalSpheres<75>> {
  static dealii::Tensor<2, 3> next()
  {
    return gradient({6e-3, 1e-3, 0, 0, 3e-3, 4e-3, -1e-3, 0, 2e-3});
  }
};

using Laws = testing::Types<PorousElastic,
                            OnCap,
                            OnCapInParts,
                            OnShear,
                            OnTransition,
                            OnApex,
                            CamClay,
                            CamClaySoftening,
                            MetalSpheres<60>,
                            MetalSpheres<68>,
                            MetalSpheres<83>,
                            MetalSpheres<93>,
                            MetalSpheresPulled>;
INSTANTIATE_TYPED_TEST_SUITE_P(Continua, MaterialPointsContract, Laws);
} // namespace tamp::fem::contract
