// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_die_mesh_h
#define fem_die_mesh_h

#include <fem/die_settings.h>

#include <deal.II/base/tensor.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace tamp::fem
{
/// The mesh of the compact with its tools' boundaries, and its material points:
/// four a cell, numbered cell by cell in the order of the mesh.
class DieMesh
{
public:
  /// Builds or reads the mesh. Throws std::runtime_error naming the file and
  /// what it lacks.
  explicit DieMesh(const DieGeometry &geometry);
  ~DieMesh();

  double radius() const;                 ///< [m]
  double height() const;                 ///< [m]
  std::size_t number_of_points() const;
  /// (r, z) of every material point at the start [m].
  const std::vector<dealii::Tensor<1, 2>> &point_positions() const;

  struct Data; ///< nodes, cells and edges: fem/die_mesh_data.h
  const Data &data() const { return *data_; }

private:
  std::unique_ptr<Data> data_;
};
} // namespace tamp::fem

#endif
