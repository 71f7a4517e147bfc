// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/law_parameters.h>
#include <apps/input/parameter_table.h>

namespace tamp::apps
{
namespace
{
constexpr Range a_density{0, 1, true, false};

void declare_tolerance(ParameterTable &table, const std::string &size)
{
  table.quantity("Integration tolerance",
                 "2e-5",
                 dimension::number,
                 Range{0, 0.01, true, false},
                 "Largest estimated error of stress in a part of an "
                 "increment, over " +
                     size);
}
} // namespace

void declare_cam_clay(ParameterTable &table)
{
  table.enter("Modified Cam-Clay");
  table.quantity("Initial relative density",
                 "0.3411",
                 dimension::number,
                 a_density,
                 "Of the powder at the start");
  table.quantity("Initial yield pressure",
                 "1.4 MPa",
                 dimension::pressure,
                 positive,
                 "Preconsolidation pressure p_c at the initial relative "
                 "density; default: near Avicel PH-102");
  table.quantity("Critical state slope",
                 "1.8",
                 dimension::number,
                 Range{0, 3, true, true},
                 "M: deviatoric stress over pressure at critical state");
  table.quantity(
      "Compression index",
      "0.45",
      dimension::number,
      positive,
      "lambda: fall of specific volume 1 / D over growth of ln(pressure) on "
      "the isotropic compression line; above the swelling index");
  table.quantity("Swelling index",
                 "0.08",
                 dimension::number,
                 positive,
                 "kappa: the same in elastic unloading; bulk modulus = "
                 "pressure / (D kappa)");
  table.quantity("Poisson's ratio",
                 "0.1",
                 dimension::number,
                 Range{-1, 0.5, true, true},
                 "Constant; gives the shear modulus from the bulk modulus");
  table.quantity("Floor pressure",
                 "0.1 MPa",
                 dimension::pressure,
                 positive,
                 "Below it the bulk modulus stays as it is there, so that "
                 "powder without load has stiffness");
  declare_tolerance(table, "p_c");
  table.leave();
}

fem::ModifiedCamClayParameters read_cam_clay(const ParameterTable &table)
{
  const std::string section = "Material/Modified Cam-Clay";
  fem::ModifiedCamClayParameters law;
  law.initial_relative_density =
      table.number(section + "/Initial relative density");
  law.initial_yield_pressure =
      table.number(section + "/Initial yield pressure");
  law.critical_state_slope = table.number(section + "/Critical state slope");
  law.compression_index = table.number(section + "/Compression index");
  law.swelling_index = table.number(section + "/Swelling index");
  law.poissons_ratio = table.number(section + "/Poisson's ratio");
  law.floor_pressure = table.number(section + "/Floor pressure");
  law.integration_tolerance = table.number(section + "/Integration tolerance");
  return law;
}

void declare_fkm_gurson(ParameterTable &table)
{
  table.enter("FKM-Gurson");
  table.quantity("Initial relative density",
                 "0.66",
                 dimension::number,
                 Range{0, 1, true, true},
                 "Of the powder at the start; below the random packing density "
                 "the powder has next to no strength and answers are doubtful");
  table.quantity("Random packing density",
                 "0.64",
                 dimension::number,
                 Range{0, 0.77, true, true},
                 "D_0, from which the powder of spheres carries");
  table.quantity(
      "Solid yield stress",
      "100 MPa",
      dimension::pressure,
      positive,
      "sigma_0 of the solid, which does not harden; default: annealed copper");
  table.quantity("Solid Young's modulus",
                 "120 GPa",
                 dimension::pressure,
                 positive,
                 "E_s of the solid");
  table.quantity("Solid Poisson's ratio",
                 "0.34",
                 dimension::number,
                 Range{-1, 0.5, true, true},
                 "Taken at all relative densities");
  table.quantity("Elastic exponent",
                 "7",
                 dimension::number,
                 Range{0, 50},
                 "b in E = E_s exp(-b (1 - D))");
  table.quantity(
      "Yield floor",
      "1e-3",
      dimension::number,
      Range{0, 0.1, true, false},
      "Least hydrostatic yield pressure over the solid yield stress");
  table.quantity(
      "Vertex rounding",
      "0.01",
      dimension::number,
      Range{0, 0.1, true, false},
      "How far the corner of the loose powder's surface on the pressure axis "
      "is rounded, over its hydrostatic yield pressure");
  declare_tolerance(table, "the hydrostatic yield pressure");
  table.leave();
}

fem::FkmGursonParameters read_fkm_gurson(const ParameterTable &table)
{
  const std::string section = "Material/FKM-Gurson";
  fem::FkmGursonParameters law;
  law.initial_relative_density =
      table.number(section + "/Initial relative density");
  law.random_packing_density =
      table.number(section + "/Random packing density");
  law.solid_yield_stress = table.number(section + "/Solid yield stress");
  law.solid_youngs_modulus = table.number(section + "/Solid Young's modulus");
  law.solid_poissons_ratio = table.number(section + "/Solid Poisson's ratio");
  law.elastic_exponent = table.number(section + "/Elastic exponent");
  law.yield_floor = table.number(section + "/Yield floor");
  law.vertex_rounding = table.number(section + "/Vertex rounding");
  law.integration_tolerance = table.number(section + "/Integration tolerance");
  return law;
}
} // namespace tamp::apps
