// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_compact_h
#define fem_compact_h

#include <fem/assembler.h>
#include <fem/kinematics.h>
#include <fem/material_points.h>
#include <fem/mesh.h>
#include <fem/ranks.h>
#include <fem/state_bytes.h>

#include <span>
#include <string>
#include <vector>

namespace tamp::fem
{
/// What is wrong with a trial, the same on all ranks.
struct Fault {
  std::string reason; ///< empty: nothing
  std::size_t point = 0;
};

/// Every node's and every point's part in the powder body between the tools.
struct CompactState {
  NodePositions positions;         ///< of all nodes [m]
  std::vector<Response> responses; ///< of this rank's points
  /// F since the start, of this rank's points.
  std::vector<dealii::Tensor<2, 3>> deformation_gradients;
};

/// The powder body: turns a displacement into deformations of the material
/// points and their answers into forces and stiffness. Keeps the accepted state
/// and one trial, which starts from it. Updated Lagrangian. Cells and points
/// are shared out over the ranks; forces are summed.
class Compact
{
public:
  /// Evaluates the points once, undeformed; throws std::runtime_error if that
  /// fails. @param points  of this rank's share of the cells. @param f_bar
  /// takes the volume change of a cell's points from its centre, which frees a
  /// nearly incompressible body from locking (de Souza Neto et al. 1996). All
  /// must outlive the object.
  Compact(const Mesh &mesh,
          MaterialPoints &points,
          const Ranks &ranks,
          bool f_bar = false);

  const Mesh &mesh() const { return mesh_; }
  const Ranks &ranks() const { return ranks_; }
  const CompactState &state() const { return state_; }
  const NodePositions &trial_positions() const { return trial_.positions; }
  std::span<const Response> trial_responses() const { return trial_.responses; }
  /// Numbers of this rank's points in the whole mesh.
  Share point_share() const;
  /// Values of this rank's points at their places among those of all points, on
  /// every rank. Collective.
  std::vector<double> whole(std::span<const double> of_this_rank) const;
  /// Position [m] and volume [m3] of this rank's points, accepted.
  const std::vector<PointGeometry> &geometry() const { return committed_; }

  void begin_attempt() { points_.begin_attempt(); }

  /// Tries this displacement since the accepted state: positions and relative
  /// deformations. Collective, as all that follows.
  [[nodiscard]] Fault deform(std::span<const double> increment);
  /// Asks the points for their answers to the last deform().
  [[nodiscard]] Fault evaluate(Want want);
  std::size_t doubtful_points() const;
  /// Largest component of relative_F - I over all points for an increment [-].
  double largest_strain(std::span<const double> increment) const;
  /// Relative volume change of this rank's points in the trial [-].
  double volume_ratio(std::size_t local_point) const;

  /// Forces of the trial, summed over the ranks [N].
  std::vector<double> internal_forces() const;
  /// Work of the stress on the strain of the trial since the accepted state, of
  /// the mesh's part of the compact [J].
  double trial_work() const;
  /// Stiffness of the trial, this rank's part [N/m].
  void assemble_stiffness(SparseRows &stiffness) const;
  const Assembler &assembler() const { return assembler_; }

  /// The trial becomes the accepted state.
  void accept();

  /// Appends the accepted state of all points and nodes, on the first rank;
  /// unpack() takes up this rank's part, on any number of ranks, from the same
  /// bytes on each. What the material points keep is not in it. Throws
  /// std::runtime_error if it is that of another mesh.
  void pack(std::vector<char> &bytes) const;
  void unpack(StateBytes &bytes);

private:
  struct Trial {
    NodePositions positions;
    std::vector<PointGeometry> geometry, centres;
    std::vector<Deformation> deformations;
    std::vector<Response> responses;
  };
  enum Kind { none, inverted, failed, not_finite };

  Fault agree(Kind kind, std::size_t point) const;
  void update_geometry(const NodePositions &positions,
                       std::vector<PointGeometry> &points,
                       std::vector<PointGeometry> &centres) const;
  dealii::Tensor<2, 3> relative_F(std::size_t local_point,
                                  std::span<const double> increment) const;
  CellPoints cell_points(std::size_t local_cell) const;

  const Mesh &mesh_;
  MaterialPoints &points_;
  Ranks ranks_;
  bool f_bar_;
  Element element_;
  Share cells_;
  Assembler assembler_;
  CompactState state_;
  std::vector<PointGeometry> committed_, committed_centres_;
  Trial trial_;
};
} // namespace tamp::fem

#endif
