// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_density_field_h
#define apps_input_density_field_h

#include <fem/mesh.h>

#include <string>
#include <vector>

namespace tamp::apps
{
class ParameterTable;

/// The entry that says how unevenly a die is filled, Die/Initial density or
/// Die/Initial density file; empty if it is filled evenly.
std::string density_entry(const ParameterTable &table);

/// The relative density of every material point of a mesh at the start, from
/// that entry; empty if there is none. Throws InputError if the formula or the
/// file cannot be read or gives no density somewhere.
std::vector<double> read_density_field(const ParameterTable &table,
                                       const fem::Mesh &mesh);
} // namespace tamp::apps

#endif
