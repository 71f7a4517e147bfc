// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/mcc_ph102.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Avicel PH-102, Drucker-Prager cap, alpha = 0, K = 1. Retyped from the public
// repository taha-re/manuscript-data-density-dependent-friction-tableting
// (commit 83e1922), which credits the tables to Panos (2007).
namespace tamp::fem::mcc_ph102
{
namespace
{
constexpr double MPa = 1e6;
constexpr double degree = std::numbers::pi / 180;

DensityTable table(const std::string &name,
                   std::vector<double> place,
                   std::vector<double> value,
                   const double unit)
{
  for (double &entry : value)
    entry *= unit;
  return DensityTable({std::move(place), std::move(value)}, name);
}

const std::vector<double> elastic_density{
    0.30, 0.40, 0.50, 0.60, 0.70, 0.803, 0.904, 0.98};
const std::vector<double> strength_density{
    0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.93, 0.96, 0.99};
} // namespace

DensityTable youngs_modulus()
{
  return table("Young's modulus",
               elastic_density,
               {45, 177, 482, 1053, 2057, 3715, 6324, 9306},
               MPa);
}

DensityTable poissons_ratio()
{
  return table("Poisson's ratio",
               elastic_density,
               {0.016, 0.035, 0.061, 0.094, 0.136, 0.188, 0.251, 0.309},
               1);
}

DensityTable cohesion()
{
  return table(
      "cohesion",
      strength_density,
      {0.0268, 0.7225, 1.156, 3.124, 5.849, 10.51, 18.65, 29.98, 34.08, 56.86},
      MPa);
}

DensityTable friction_angle()
{
  return table(
      "friction angle",
      strength_density,
      {54.35, 68.78, 68.34, 68.03, 68.07, 67.42, 66.51, 66.32, 65.69, 63.40},
      degree);
}

DensityTable eccentricity()
{
  return table(
      "cap eccentricity",
      strength_density,
      {0.271, 0.312, 0.586, 0.640, 0.690, 0.789, 0.907, 1.02, 1.30, 1.608},
      1);
}

DensityTable hardening()
{
  std::vector<double> pressure{
      0.609, 4.03, 10.7, 20.5, 35.78, 64.7, 127.9, 170, 257, 368, 823};
  for (double &entry : pressure)
    entry *= MPa;
  // The last three stand in the source as strains.
  std::vector<double> strain{0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 0.93};
  for (double &entry : strain)
    entry = std::log(entry / reference_density);
  strain.insert(strain.end(), {1.160000, 1.193922, 1.202972});
  return DensityTable({strain, pressure},
                      "hydrostatic yield pressure",
                      DensityTable::Shape::increasing,
                      DensityTable::Above::extend);
}
} // namespace tamp::fem::mcc_ph102
