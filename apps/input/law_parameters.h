// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_law_parameters_h
#define apps_input_law_parameters_h

#include <coupling/material_factory.h>

namespace tamp::apps
{
class ParameterTable;

/// @name Subsections of Material, one per continuum law. To be declared with
/// section Material entered. Reading throws InputError about what is wrong with
/// the values of an entry; what laws refuse is found when they are made.
/// @{
void declare_elastic(ParameterTable &table);
coupling::ElasticChoice read_elastic(const ParameterTable &table);

void declare_cap(ParameterTable &table);
coupling::CapChoice read_cap(const ParameterTable &table);

void declare_cam_clay(ParameterTable &table);
fem::ModifiedCamClayParameters read_cam_clay(const ParameterTable &table);

void declare_fkm_gurson(ParameterTable &table);
fem::FkmGursonParameters read_fkm_gurson(const ParameterTable &table);
/// @}
} // namespace tamp::apps

#endif
