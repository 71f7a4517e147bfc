// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_probe_columns_h
#define apps_output_probe_columns_h

#include <fem/path_driver.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// ln V of F = V R, compression positive [-]; exact if F is diagonal.
dealii::SymmetricTensor<2, 3> compressive_strain(const dealii::Tensor<2, 3> &F);

/// Names of what is said of a material point after each step of its path, with
/// units.
std::vector<std::string> probe_header();
/// The values, in the same order.
std::vector<double> probe_values(const fem::PathRecord &record);

/// Names of what is said of a branch to yield and of moduli, with units:
/// columns of yield.csv and moduli.csv.
std::vector<std::string> yield_header();
std::vector<std::string> moduli_header();

/// Appends the nine components, row by row, and their names: prefix "F_" gives
/// "F_xx[-]", "F_xy[-]" ...
void append_nine(const dealii::Tensor<2, 3> &tensor,
                 std::vector<double> &values);
void append_nine_names(const std::string &prefix,
                       std::vector<std::string> &names);
} // namespace tamp::apps

#endif
