// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_tool_contact_h
#define fem_tool_contact_h

#include <fem/friction.h>
#include <fem/kinematics.h>
#include <fem/state_bytes.h>
#include <fem/tool_surface.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <limits>
#include <map>
#include <span>
#include <vector>

namespace tamp::fem
{
/// The rigid tools: their surfaces at the start and their friction.
struct Tools {
  ToolSurfaces surfaces;
  std::array<FrictionCoefficient, number_of_tools> friction;
};

/// Displacement of each tool along z since the start [m].
using ToolPositions = std::array<double, number_of_tools>;

/// Forces of a tool, of the mesh's part of the compact.
struct ToolForce {
  dealii::Tensor<1, 3> force; ///< of the tool on the powder [N]
  double normal = 0;          ///< sum of the nodes' normal forces [N]
  double area = 0;            ///< of the nodes in contact [m2]
};
using ToolForces = std::array<ToolForce, number_of_tools>;

/// A node and a tool that it may touch, or one face of it: in a hollow edge a
/// node touches two faces at once.
struct ContactPair {
  unsigned node = 0;
  Tool tool = die_wall;
  unsigned face = 0;
};

/// What a pair does in a trial.
struct PairForce {
  ContactStatus status = ContactStatus::open;
  double normal = 0;                     ///< N, compressive [N]
  double penetration = 0;                ///< [m]; meaningless if open
  dealii::Tensor<1, 3> friction;         ///< of the tool on the powder [N]
  dealii::Tensor<1, 3> force;            ///< N n + friction [N]
  double slip = 0;                       ///< tangential, in the increment [m]
  dealii::Tensor<1, 3> normal_direction; ///< from the tool into the powder
};

/// Frictional contact of the powder's nodes with the rigid tools. Normal
/// contact by an augmented Lagrangian: N = max(0, lambda - epsilon d) with the
/// distance d to the tool, the stiffness epsilon taken from that of the powder,
/// and the multiplier lambda, which takes over what N was: at the next step, or
/// within a step with augment(). Friction by return mapping. A node that leaves
/// a tool is free. Die and core end at the rim, the height of the uppermost
/// wall node at the start. A node that begins an increment above it is let go
/// for good: its force fades, from all of it, until half an element above the
/// rim, as the faces next to it leave the wall. Source: J. C. Simo and T. A.
/// Laursen (1992), An augmented Lagrangian treatment of contact problems
/// involving friction.
class ToolContact
{
public:
  /// @param mesh  must outlive the object.
  ToolContact(const Mesh &mesh, const Tools &tools);

  const std::vector<ContactPair> &pairs() const { return pairs_; }

  /// Begins an increment from the accepted state.
  /// @param node_stiffness  mean diagonal entry of each node's stiffness [N/m]
  /// @param positions       accepted, of nodes
  /// @param tools           accepted, of tools
  /// @param densities       relative, of the powder at each node [-]
  void begin(std::span<const double> node_stiffness,
             const NodePositions &positions,
             const ToolPositions &tools,
             std::span<const double> densities);

  /// Forces for these trial positions.
  std::vector<PairForce> forces(const NodePositions &positions,
                                const ToolPositions &tools) const;

  /// The derivative of minus a pair's force by the node's position [N/m], as of
  /// the last forces() for the same positions; by the tool's: its negative.
  dealii::Tensor<2, 3> stiffness(std::size_t pair,
                                 const PairForce &force,
                                 const NodePositions &positions,
                                 const ToolPositions &tools) const;

  /// By how much rounding of positions changes the norm of these forces [N].
  double rounding(std::span<const PairForce> forces) const;

  /// Multipliers become the normal forces: penetrations fall by the ratio of
  /// the stiffnesses of powder and contact.
  void augment(std::span<const PairForce> forces);

  /// Multipliers become what balances the normal parts of the internal forces,
  /// as far as that is compressive: the reactions of exact contact. For
  /// iterates that lie on the tools. @param internal  forces of all degrees of
  /// freedom [N]
  void take_reactions(std::span<const double> internal,
                      const NodePositions &positions,
                      const ToolPositions &tools);

  /// Forces and positions are those of the accepted state.
  void accept(std::span<const PairForce> forces,
              const NodePositions &positions);

  /// Forces of the accepted state.
  const std::vector<PairForce> &accepted() const { return accepted_; }
  /// Area of the powder's surface that belongs to a pair, with all faces of its
  /// tool, accepted [m2].
  double area(std::size_t pair) const { return areas_[pair]; }

  /// Mean height of the elements along the die wall, accepted [m].
  double element_height() const { return element_height_; }
  /// Height above the rim at which a node is free of the bore [m].
  double fading_height() const { return 0.5 * element_height_; }

  /// Sums over the nodes of each tool.
  ToolForces sums(std::span<const PairForce> forces) const;

  /// Appends all of the accepted state that decides what comes; unpack() takes
  /// it up. @param positions  accepted, of nodes. Throws std::runtime_error if
  /// it is that of other pairs.
  void pack(std::vector<char> &bytes) const;
  void unpack(StateBytes &bytes, const NodePositions &positions);

private:
  struct Approach;
  dealii::Tensor<1, 3> below_rim(dealii::Tensor<1, 3> place, Tool tool) const;
  Approach approach(std::size_t pair,
                    const NodePositions &positions,
                    const ToolPositions &tools) const;
  double fading_way(std::size_t pair) const;
  PairForce fading(std::size_t pair,
                   const NodePositions &positions,
                   const ToolPositions &tools) const;
  PairForce force(std::size_t pair,
                  const NodePositions &positions,
                  const ToolPositions &tools) const;
  void update_areas(const NodePositions &positions);
  template <class Self, class Use>
  static void each_part(Self &self, const Use &use);

  const Mesh &mesh_;
  Tools tools_;
  std::vector<ContactPair> pairs_;
  std::vector<PairForce> accepted_;
  std::vector<char> released_;          ///< has passed the rim, per pair
  std::vector<PairForce> at_release_;   ///< forces there
  std::vector<double> release_heights_; ///< above the rim, there [m]
  double element_height_ = 0;           ///< [m]
  double rim_ = -std::numeric_limits<double>::infinity(); ///< z at start [m]
  double margin_ = 0;                                     ///< [m]
  double touch_ = 0; ///< a node this near touches a tool [m]
  std::vector<double> multipliers_, stiffness_, areas_, densities_;
  NodePositions begin_positions_;
  ToolPositions begin_tools_{};
  /// Pairs of each node that has any.
  std::map<unsigned, std::vector<std::size_t>> pairs_of_node_;
};
} // namespace tamp::fem

#endif
