// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/input_sections.h>
#include <apps/input/law_parameters.h>
#include <apps/input/parameter_table.h>
#include <apps/input/value_checks.h>

#include <algorithm>
#include <iterator>

namespace tamp::apps
{
namespace
{
// Order as in coupling::MaterialKind.
const std::vector<std::string> types{"unit cell",
                                     "elastic",
                                     "drucker-prager cap",
                                     "modified cam-clay",
                                     "fkm-gurson"};

std::vector<std::string> below(const std::string &section,
                               const std::vector<std::string> &names)
{
  std::vector<std::string> paths;
  for (const std::string &name : names)
    paths.push_back(section + "/" + name);
  return paths;
}

void check_cells(const ParameterTable &table,
                 const coupling::MaterialChoice &material)
{
  check_values(table,
               below("Cell",
                     {"Method",
                      "Unbalance tolerance",
                      "Maximum strain increment",
                      "Strain rate",
                      "Density scaling",
                      "Time step fraction",
                      "Global damping",
                      "Local damping"}),
               [&] { material.driving.check(); });
}

// What the rooms below refuse is refused here, before anything is written.
void check_material(const ParameterTable &table,
                    const coupling::MaterialChoice &material)
{
  std::vector<std::string> names{"Initial relative density",
                                 "Elastic densities",
                                 "Young's modulus",
                                 "Poisson's ratio"};
  const auto make = [&] { coupling::make_material(material, 1); };
  switch (material.kind) {
  case coupling::MaterialKind::unit_cell:
    check_cells(table, material);
    break;
  case coupling::MaterialKind::elastic:
    check_values(table, below("Material/Elastic", names), make);
    break;
  case coupling::MaterialKind::drucker_prager_cap:
    for (const char *name : {"Cohesion",
                             "Friction angle",
                             "Cap eccentricity",
                             "Hardening densities",
                             "Hydrostatic yield pressure",
                             "Transition"})
      names.emplace_back(name);
    check_values(table, below("Material/Drucker-Prager cap", names), make);
    break;
  case coupling::MaterialKind::modified_cam_clay:
    check_values(table,
                 below("Material/Modified Cam-Clay",
                       {"Initial relative density",
                        "Initial yield pressure",
                        "Critical state slope",
                        "Compression index",
                        "Swelling index",
                        "Poisson's ratio",
                        "Floor pressure",
                        "Integration tolerance"}),
                 make);
    break;
  case coupling::MaterialKind::fkm_gurson:
    check_values(table,
                 below("Material/FKM-Gurson",
                       {"Initial relative density",
                        "Random packing density",
                        "Solid yield stress",
                        "Solid Young's modulus",
                        "Solid Poisson's ratio",
                        "Elastic exponent",
                        "Yield floor",
                        "Vertex rounding",
                        "Integration tolerance"}),
                 make);
    break;
  }
}
} // namespace

void declare_material(ParameterTable &table)
{
  table.enter("Material");
  table.choice("Type",
               "unit cell",
               types,
               "What material points are: grains (sections Grains, Contact, "
               "Packing, Cell), or a continuum law (a subsection here)");
  declare_elastic(table);
  declare_cap(table);
  declare_cam_clay(table);
  declare_fkm_gurson(table);
  table.leave();
}

void read_material(const ParameterTable &table,
                   coupling::MaterialChoice &material)
{
  material.kind = static_cast<coupling::MaterialKind>(std::distance(
      types.begin(), std::ranges::find(types, table.word("Material/Type"))));
  material.elastic = read_elastic(table);
  material.cap = read_cap(table);
  material.cam_clay = read_cam_clay(table);
  material.fkm_gurson = read_fkm_gurson(table);
  check_material(table, material);
}
} // namespace tamp::apps
