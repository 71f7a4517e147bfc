// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_cell_columns_h
#define apps_output_cell_columns_h

#include <coupling/unit_cell_points.h>
#include <dem/measures.h>

#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// "xx", "yy", "zz", "yz", "xz", "xy".
extern const std::vector<std::string> six_names;

/// Appends the components in the order of six_names.
void append_six(const dealii::SymmetricTensor<2, 3> &tensor,
                std::vector<double> &values);

/// Names of what a probe's curve says of a cell, moving cells included.
std::vector<std::string> cell_header(bool dynamics);

/// The values that belong to cell_header(), of the committed cell of a point.
/// Compression positive; energies per volume of the cell when it was made.
std::vector<double> cell_values(const coupling::UnitCellPoints &cells,
                                std::size_t point,
                                const dem::Driving &driving);
} // namespace tamp::apps

#endif
