// SPDX-License-Identifier: BSD-3-Clause
#include <apps/pack_results.h>
#include <dem/measures.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tamp::apps
{
namespace
{
double axial_of(const dem::Matrix3 &stress)
{
  return -stress(2, 2);
}

double lateral_of(const dem::Matrix3 &stress)
{
  return -0.5 * (stress(0, 0) + stress(1, 1));
}

double pressure_of(const dem::Matrix3 &stress)
{
  return -stress.trace() / 3;
}

double mean_of(const std::vector<double> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

// Of a sample of few.
double deviation_of(const std::vector<double> &values)
{
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values)
    sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}
} // namespace

std::vector<std::string> packing_header()
{
  return {"packing",
          "step",
          "relative_density[-]",
          "void_ratio[-]",
          "pressure[Pa]",
          "axial_stress[Pa]",
          "lateral_stress[Pa]",
          "coordination_number[-]",
          "mechanical_coordination_number[-]",
          "contacts[-]",
          "plastic_contacts[-]",
          "sliding_contacts[-]",
          "rattlers[-]",
          "unbalance[-]",
          "sweeps[-]"};
}

std::vector<double> packing_row(std::size_t packing,
                                unsigned step,
                                const dem::UnitCell &cell,
                                const dem::CellAnswer &answer)
{
  const dem::CellMeasures measures = dem::measure(cell);
  const double density = cell.relative_density();
  // Nobody wants to read -0.
  return {static_cast<double>(packing + 1),
          static_cast<double>(step),
          density,
          1 / density - 1,
          pressure_of(answer.stress) + 0.0,
          axial_of(answer.stress) + 0.0,
          lateral_of(answer.stress) + 0.0,
          measures.coordination_number,
          measures.mechanical_coordination_number,
          static_cast<double>(measures.contacts),
          static_cast<double>(measures.plastic_contacts),
          static_cast<double>(measures.sliding_contacts),
          static_cast<double>(measures.rattlers),
          answer.unbalance,
          static_cast<double>(answer.evaluations)};
}

void PackResults::take(std::size_t packing, const dem::UnitCell &cell)
{
  const auto add = [&](const std::string &name, double value) {
    values_[name][packing] = value;
    if (!std::ranges::count(names_, name))
      names_.push_back(name);
  };
  const dem::CellMeasures measures = dem::measure(cell);
  const double grains = static_cast<double>(cell.size());
  add("relative_density[-]", cell.relative_density());
  add("pressure[Pa]", pressure_of(measures.stress));
  add("axial_stress[Pa]", axial_of(measures.stress));
  add("lateral_stress[Pa]", lateral_of(measures.stress));
  add("coordination_number[-]", measures.coordination_number);
  add("mechanical_coordination_number[-]",
      measures.mechanical_coordination_number);
  if (measures.contacts > 0) {
    const double contacts = static_cast<double>(measures.contacts);
    add("lateral_over_axial_stress[-]",
        lateral_of(measures.stress) / axial_of(measures.stress));
    add("plastic_share[-]",
        static_cast<double>(measures.plastic_contacts) / contacts);
  }
  add("rattler_share[-]", static_cast<double>(measures.rattlers) / grains);
  add("cell_height[m]", cell.box.h(2, 2));
  add("cell_width[m]", cell.box.h(0, 0));
  ++count_;
}

void PackResults::give(RunSession &session) const
{
  session.result("packings[-]", static_cast<double>(count_));
  for (const std::string &name : names_) {
    std::vector<double> values;
    for (const auto &[packing, value] : values_.at(name))
      values.push_back(value);
    session.result(name, mean_of(values));
    if (values.size() < 2)
      continue;
    const std::size_t unit = name.find('[');
    session.result(name.substr(0, unit) + "_deviation" + name.substr(unit),
                   deviation_of(values));
  }
}
} // namespace tamp::apps
