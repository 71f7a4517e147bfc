// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_density_field_h
#define apps_density_field_h

#include <fem/mesh.h>

#include <vector>

namespace tamp::apps
{
class ParameterTable;

/// The relative density of every material point of a mesh at the start, from
/// Die/Initial density; empty if the powder is filled evenly. Throws InputError
/// if the formula cannot be read or gives no density somewhere.
std::vector<double> read_density_field(const ParameterTable &table,
                                       const fem::Mesh &mesh);
} // namespace tamp::apps

#endif
