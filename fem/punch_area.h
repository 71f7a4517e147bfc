// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_punch_area_h
#define fem_punch_area_h

#include <fem/mesh.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace tamp::fem
{
/// Area of the faces that a punch touches at the start, seen along the pressing
/// axis, of the whole compact [m2].
double punch_area(const Mesh &mesh, Tool punch);

/// Mean height of the surface that a punch touched at the start, weighted by
/// the area it had then, when its nodes are at `positions` [m]. What happens at
/// an edge, such as a lip there, counts as little as its area.
double mean_height(const Mesh &mesh,
                   Tool punch,
                   const std::vector<dealii::Tensor<1, 3>> &positions);

/// z of the highest of these positions of nodes where a punch meets the die at
/// the start, or of the highest that it touches at all [m].
double edge_height(const Mesh &mesh,
                   Tool punch,
                   const std::vector<dealii::Tensor<1, 3>> &positions);
} // namespace tamp::fem

#endif
