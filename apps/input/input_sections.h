// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_input_sections_h
#define apps_input_input_sections_h

#include <apps/input/run_input.h>
#include <fem/die_mesh.h>

namespace tamp::apps
{
/// @name Grains, Contact, Packing, Cell
/// @{
void declare_grains(ParameterTable &table);
void read_grains(const ParameterTable &table,
                 coupling::MaterialChoice &material);
/// @}

/// @name Material
/// @{
void declare_material(ParameterTable &table);
void read_material(const ParameterTable &table,
                   coupling::MaterialChoice &material);
/// @}

/// @name Die
/// @{
void declare_die_shape(ParameterTable &table);
void read_die_shape(const ParameterTable &table, fem::DieSettings &die);
/// @}

/// @name Schedule, Solver
/// @{
void declare_press(ParameterTable &table);
/// The material decides what `automatic` means. Returns the mesh
/// of the powder.
fem::ImportedMesh read_press(const ParameterTable &table,
                             const coupling::MaterialChoice &material,
                             fem::DieSettings &die);
/// @}
} // namespace tamp::apps

#endif
