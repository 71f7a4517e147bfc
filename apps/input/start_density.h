// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_start_density_h
#define apps_input_start_density_h

#include <coupling/material_factory.h>

#include <optional>

namespace tamp::apps
{
/// Relative density of the powder at the start [-]; none for unit cells, which
/// only packing tells.
std::optional<double> start_density(const coupling::MaterialChoice &material);
} // namespace tamp::apps

#endif
