// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_section_map_h
#define apps_output_section_map_h

#include <apps/output/plots.h>
#include <fem/die_model.h>
#include <fem/mesh.h>

#include <functional>
#include <vector>

namespace tamp::apps
{
/// The compact's section through the pressing axis, in the committed state,
/// with a value of the answer of each material point. It consists of the parts
/// of the elements that the points stand for: of all elements of an
/// axisymmetric mesh; in three dimensions of the elements with a face on the
/// plane y = 0 at x >= 0, with the values of the points next to it. Empty if
/// there are none, as in a whole compact with an odd number of elements across.
/// The points of an element fix its shape.
/// Collective.
std::vector<ValueQuadrilateral>
section_map(const fem::Mesh &mesh,
            const fem::DieModel &model,
            const std::function<double(const fem::Response &)> &value);
} // namespace tamp::apps

#endif
