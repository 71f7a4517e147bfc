// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_density_grid_h
#define apps_input_density_grid_h

#include <deal.II/base/tensor.h>

#include <filesystem>
#include <functional>

namespace tamp::apps
{
/// The relative density at a place [m].
using DensityField = std::function<double(const dealii::Tensor<1, 3> &)>;

/// Reads relative densities on a rectilinear grid: CSV with remarks after #, a
/// header of names with units, and a line for every place of the grid, in any
/// order. The columns are `relative_density` and either `x`, `y` and `z` or `r`
/// and `z`, with r = sqrt(x^2 + y^2); others are passed over. Between places
/// the density is linear along each of them. Throws InputError, "FILE:LINE:
/// ..."; so does the field that is returned, for places outside the grid.
DensityField read_density_grid(const std::filesystem::path &file);
} // namespace tamp::apps

#endif
