// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_cell_parameters_h
#define apps_input_cell_parameters_h

#include <dem/deform.h>

#include <string>
#include <vector>

namespace tamp::apps
{
class ParameterTable;

/// Ways in which grains follow a strain, in the order of dem::Method.
inline const std::vector<std::string> methods{"quasi-static", "dynamics"};

/// @name Section Cell, but for Warm start, which is read with the grains.
/// @{
void declare_cell(ParameterTable &table);
void read_cell(const ParameterTable &table, dem::Driving &driving);
/// @}
} // namespace tamp::apps

#endif
