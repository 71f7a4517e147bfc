// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compare_plots.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tamp::apps
{
namespace
{
using Side = std::array<unsigned, 4>; // corners, around

// The side of a part that the section shows, by its undeformed places.
std::optional<Side> shown_side(const FieldGrid &grid, std::size_t part)
{
  if (grid.dimension == 2)
    return Side{0, 1, 3, 2};
  const Place *corners = &grid.undeformed[part * 8];
  double extent = 0, middle = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
    extent += std::abs(corners[7][axis] - corners[0][axis]);
  for (unsigned corner = 0; corner < 8; ++corner)
    middle += corners[corner][1] / 8;
  if (middle < 0) // a whole compact has parts on both sides: one is enough
    return {};
  const double level = 1e-4 * extent; // of single precision, with room
  for (const Side &side : {Side{0, 1, 5, 4},
                           Side{2, 3, 7, 6},
                           Side{0, 2, 6, 4},
                           Side{1, 3, 7, 5},
                           Side{0, 1, 3, 2},
                           Side{4, 5, 7, 6}})
    if (std::ranges::all_of(side, [&](unsigned corner) {
          return std::abs(corners[corner][1]) <= level &&
                 corners[corner][0] >= -level;
        }))
      return side;
  return {};
}

std::vector<ValueQuadrilateral> section_of(const FieldGrid &grid,
                                           const std::vector<double> &values,
                                           double factor)
{
  std::vector<ValueQuadrilateral> map;
  const unsigned height = grid.dimension - 1;
  for (std::size_t part = 0; part < grid.parts(); ++part) {
    const auto side = shown_side(grid, part);
    if (!side || std::isnan(values[part]))
      continue;
    ValueQuadrilateral &piece = map.emplace_back();
    piece.value = factor * values[part];
    for (unsigned k = 0; k < 4; ++k) {
      const Place &place = grid.now[part * grid.corners() + (*side)[k]];
      piece.corners[k] = {place[0], place[height]};
    }
  }
  return map;
}

struct Shown {
  const char *field, *file, *label;
  double factor;
};
constexpr Shown shown[] = {
    {"relative_density", "density", "relative density [-]", 1},
    {"stress_zz", "axial_stress", "axial stress [MPa]", 1e-6}};
} // namespace

std::string plot_text(const std::string &name)
{
  std::string text;
  for (const char letter : name) {
    if (std::string_view("_^@&~{}").find(letter) != std::string_view::npos)
      text += "\\\\";
    text += letter;
  }
  return text;
}

std::vector<Plot> write_maps(const std::filesystem::path &folder,
                             const std::vector<ComparedState> &states,
                             std::span<const ResultFolder> runs)
{
  std::vector<Plot> plots;
  for (const ComparedState &state : states)
    for (std::size_t run = 0; run < state.others.size(); ++run)
      for (const Shown &what : shown) {
        const auto &values = state.others[run].values;
        const auto found = values.find(what.field);
        if (found == values.end())
          continue;
        const auto map =
            section_of(state.reference, found->second, what.factor);
        if (std::ranges::all_of(map, [](const ValueQuadrilateral &part) {
              return part.value == 0;
            }))
          continue;
        const std::string name = fmt::format(
            "{}_difference_{}_{}", what.file, state.state.name, run + 2);
        write_map(folder / (name + ".dat"), map);
        plots.push_back(map_plot(name,
                                 name + ".dat",
                                 fmt::format("{} less {}, {}",
                                             plot_text(runs[run + 1].name),
                                             plot_text(runs.front().name),
                                             plot_text(state.state.words)),
                                 fmt::format("difference of {}", what.label),
                                 Colours::about_zero));
      }
  return plots;
}
} // namespace tamp::apps
