// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_h
#define fem_mesh_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <vector>

namespace tamp::fem
{
/// The part of the compact that a mesh holds.
enum class Section {
  axisymmetric, ///< half a section: quadrilaterals at y = 0, x = r >= 0
  quarter,      ///< hexahedra in x >= 0, y >= 0
  full          ///< hexahedra
};

/// The rigid tools around the powder, as indices.
enum Tool : unsigned { upper_punch, lower_punch, die_wall, core_rod };
inline constexpr unsigned number_of_tools = 4;
/// The physical names that a mesh file gives to the tools' faces.
inline constexpr std::array<const char *, number_of_tools> tool_names{
    "punch_top", "punch_bottom", "die_wall", "core"};

/// The compact as plain arrays: everything the solver needs to know of it. z is
/// the pressing axis, upwards. An axisymmetric mesh lies in the plane y = 0
/// with x = r. The nodes of a cell are in lexicographic order (x fastest), so
/// that the volume is positive; those of a face in the order of deal.II. Cells
/// and nodes are numbered so that neighbours have near numbers: ranges of both
/// make good shares of the work.
struct Mesh {
  /// Faces of the compact that a tool touches at the start.
  struct Contact {
    std::vector<unsigned> nodes; ///< each once, ascending
    std::vector<unsigned> faces; ///< nodes_per_face() numbers a face
  };
  /// A node whose displacement along one axis is zero: axis, symmetry plane.
  struct Held {
    unsigned node, axis;
  };

  Section section = Section::axisymmetric;
  std::vector<dealii::Tensor<1, 3>> nodes; ///< positions at the start [m]
  std::vector<unsigned> cells;             ///< nodes_per_cell() numbers a cell
  std::array<Contact, number_of_tools> tools;
  std::vector<Held> held;

  bool is_axisymmetric() const { return section == Section::axisymmetric; }
  unsigned nodes_per_cell() const { return is_axisymmetric() ? 4 : 8; }
  unsigned nodes_per_face() const { return is_axisymmetric() ? 2 : 4; }
  /// Two Gauss points along each direction of a cell.
  unsigned points_per_cell() const { return nodes_per_cell(); }
  std::size_t number_of_cells() const
  {
    return cells.size() / nodes_per_cell();
  }
  std::size_t number_of_points() const { return cells.size(); }
  const unsigned *nodes_of_cell(std::size_t cell) const
  {
    return &cells[cell * nodes_per_cell()];
  }

  /// Degrees of freedom of a node, in the order of the axes.
  unsigned components() const { return is_axisymmetric() ? 2 : 3; }
  /// The axis (0: x or r, 1: y, 2: z) along which a component of a node moves.
  unsigned axis(unsigned component) const
  {
    return is_axisymmetric() ? 2 * component : component;
  }
  std::size_t dof(std::size_t node, unsigned component) const
  {
    return components() * node + component;
  }
  /// Degree of freedom of a node along z.
  std::size_t axial_dof(std::size_t node) const
  {
    return dof(node, components() - 1);
  }
  std::size_t number_of_dofs() const { return components() * nodes.size(); }
  /// How often the mesh's forces stand in the whole compact: 4 for a quarter;
  /// an axisymmetric mesh stands for the whole ring already.
  double multiplicity() const { return section == Section::quarter ? 4 : 1; }
};
} // namespace tamp::fem

#endif
