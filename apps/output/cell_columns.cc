// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/cell_columns.h>
#include <dem/dynamics.h>
#include <dem/six.h>

namespace tamp::apps
{
const std::vector<std::string> six_names{"xx", "yy", "zz", "yz", "xz", "xy"};

void append_six(const dealii::SymmetricTensor<2, 3> &tensor,
                std::vector<double> &values)
{
  for (const auto &[i, j] : dem::six_places)
    values.push_back(tensor[i][j]);
}

std::vector<std::string> cell_header(bool dynamics)
{
  std::vector<std::string> names{"coordination_number[-]",
                                 "mechanical_coordination_number[-]",
                                 "contacts[-]",
                                 "plastic_contacts[-]",
                                 "sliding_contacts[-]",
                                 "rattlers[-]"};
  for (const std::string &six : six_names)
    names.push_back("fabric_" + six + "[-]");
  for (const char *name : {"unbalance[-]",
                           "sweeps[-]",
                           "stress_asymmetry[-]",
                           "hill_mandel_residual[-]",
                           "work[J/m3]",
                           "elastic_energy[J/m3]",
                           "plastic_dissipation[J/m3]",
                           "friction_dissipation[J/m3]",
                           "adhesion_dissipation[J/m3]"})
    names.emplace_back(name);
  if (dynamics)
    for (const char *name : {"inertial_number[-]",
                             "scaling_number[-]",
                             "kinetic_energy[J/m3]",
                             "damping_dissipation[J/m3]"})
      names.emplace_back(name);
  return names;
}

std::vector<double> cell_values(const coupling::UnitCellPoints &cells,
                                std::size_t point,
                                const dem::Driving &driving)
{
  const dem::UnitCell &cell = cells.cell(point);
  const dem::CellMeasures measures = dem::measure(cell);
  const coupling::CellReport &report = cells.report();
  const dem::Matrix3 rotation = cells.rotation(point);
  const dem::Matrix3 fabric = rotation * measures.fabric * rotation.transpose();
  const double volume = cell.reference_volume;
  std::vector<double> values{measures.coordination_number,
                             measures.mechanical_coordination_number,
                             static_cast<double>(measures.contacts),
                             static_cast<double>(measures.plastic_contacts),
                             static_cast<double>(measures.sliding_contacts),
                             static_cast<double>(measures.rattlers),
                             fabric(0, 0),
                             fabric(1, 1),
                             fabric(2, 2),
                             fabric(1, 2),
                             fabric(0, 2),
                             fabric(0, 1),
                             report.worst_unbalance,
                             report.mean_evaluations(),
                             measures.asymmetry,
                             report.worst_hill_mandel,
                             cell.energy.work / volume,
                             measures.elastic_energy / volume,
                             cell.energy.plastic_dissipation / volume,
                             cell.energy.friction_dissipation / volume,
                             cell.energy.adhesion_dissipation / volume};
  if (driving.method == dem::Method::dynamics) {
    const dem::DynamicMeasures moving = dem::measure_dynamics(
        cell, driving.dynamics, -measures.stress.trace() / 3);
    values.insert(values.end(),
                  {moving.inertial_number,
                   moving.scaling_number,
                   moving.kinetic_energy / volume,
                   cell.energy.damping_dissipation / volume});
  }
  return values;
}
} // namespace tamp::apps
