// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/cell_columns.h>
#include <apps/output/probe_columns.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace tamp::apps
{
using Tensor = dealii::Tensor<2, 3>;
using SymmetricTensor = dealii::SymmetricTensor<2, 3>;

SymmetricTensor compressive_strain(const Tensor &F)
{
  const SymmetricTensor b = symmetrize(F * transpose(F));
  SymmetricTensor strain;
  if (b[0][1] == 0 && b[0][2] == 0 && b[1][2] == 0) {
    for (unsigned i = 0; i < 3; ++i)
      strain[i][i] = 0.5 * std::log(b[i][i]);
    return -strain;
  }
  for (const auto &[value, axis] :
       eigenvectors(b, dealii::SymmetricTensorEigenvectorMethod::jacobi))
    strain += 0.5 * std::log(value) * symmetrize(outer_product(axis, axis));
  return -strain;
}

void append_nine(const Tensor &tensor, std::vector<double> &values)
{
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      values.push_back(tensor[i][j]);
}

void append_nine_names(const std::string &prefix,
                       std::vector<std::string> &names)
{
  for (const char first : {'x', 'y', 'z'})
    for (const char second : {'x', 'y', 'z'})
      names.push_back(prefix + first + second + "[-]");
}

std::vector<std::string> probe_header()
{
  std::vector<std::string> names{"step", "stage"};
  append_nine_names("F_", names);
  for (const std::string &six : six_names)
    names.push_back("strain_" + six + "[-]");
  for (const std::string &six : six_names)
    names.push_back("stress_" + six + "[Pa]");
  for (const char *name : {"pressure[Pa]",
                           "deviatoric_stress[Pa]",
                           "relative_density[-]",
                           "void_ratio[-]"})
    names.emplace_back(name);
  return names;
}

std::vector<std::string> yield_header()
{
  return {"replica[-]",
          "relative_density[-]",
          "reached_pressure[Pa]",
          "reached_deviatoric_stress[Pa]",
          "branch[-]",
          "criterion[-]",
          "pressure[Pa]",
          "deviatoric_stress[Pa]",
          "plastic_volumetric_strain[-]",
          "plastic_shear_strain[-]"};
}

std::vector<std::string> moduli_header()
{
  return {"replica[-]",
          "relative_density[-]",
          "pressure[Pa]",
          "bulk_modulus[Pa]",
          "shear_modulus[Pa]",
          "Young_modulus[Pa]",
          "Poisson_ratio[-]"};
}

std::vector<double> probe_values(const fem::PathRecord &record)
{
  const SymmetricTensor stress = -record.response.stress;
  const double density = record.response.relative_density;
  std::vector<double> values{static_cast<double>(record.step),
                             static_cast<double>(record.stage + 1)};
  append_nine(record.F, values);
  append_six(compressive_strain(record.F), values);
  append_six(stress, values);
  values.push_back(trace(stress) / 3);
  values.push_back(std::sqrt(1.5) * deviator(stress).norm());
  values.push_back(density);
  values.push_back(1 / density - 1);
  return values;
}
} // namespace tamp::apps
