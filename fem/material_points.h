// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_material_points_h
#define fem_material_points_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tamp::fem
{
/// What a die model tells a material point. Always three-dimensional: an
/// axisymmetric model uses the axes (r, theta, z) and fills in the hoop
/// stretch.
struct Deformation {
  /// F_new F_old^-1 since the committed state [-].
  dealii::Tensor<2, 3> relative_F;
};

/// What is asked of an evaluation.
enum class Want { stress, stress_and_tangent };

/// How far an answer can be trusted. A failed point fails the step; a doubtful
/// one is usable and counted.
enum class Status { converged, doubtful, failed };

/// What a material point answers.
struct Response {
  /// Cauchy stress, tension positive [Pa], in the new configuration.
  dealii::SymmetricTensor<2, 3> stress;
  /// d stress / d strain for F_new -> (I + strain) F_new, strain symmetric
  /// [Pa]. Set only if asked for.
  dealii::SymmetricTensor<4, 3> tangent;
  /// Share of the volume that solid fills [-].
  double relative_density = 0;
  Status status = Status::converged;
};

/// A number that a material keeps for each point, for output.
struct Variable {
  std::string name;    ///< words joined by underscores
  std::string unit;    ///< "-" if it has none
  std::string meaning; ///< in a few words, signs and numbers included
};

/// All points of one material on this rank: the only thing a die model knows
/// of a material. `evaluate()` always starts from the last committed state;
/// `commit()` adopts the last trial. Rolling back is the absence of a commit.
class MaterialPoints
{
public:
  virtual ~MaterialPoints() = default;

  virtual std::size_t size() const = 0;

  /// Tells that a new attempt at a step begins: what a material may keep from
  /// earlier trials to be faster is forgotten, so that an attempt that was
  /// given up leaves no trace.
  virtual void begin_attempt() {}

  /// Computes a trial state for each point from its committed state, which
  /// stays as it is. @param deformations, responses  one per point.
  virtual void evaluate(std::span<const Deformation> deformations,
                        Want want,
                        std::span<Response> responses) = 0;

  /// The trial states of the last evaluate() become the committed states.
  virtual void commit() = 0;

  /// Appends the committed state of a point to `bytes`: migration, checkpoint,
  /// replay.
  virtual void pack(std::size_t point, std::vector<char> &bytes) const = 0;

  /// Replaces the committed state of a point by what pack() wrote. Throws
  /// std::runtime_error, and changes nothing, if the bytes are not such a
  /// state.
  virtual void unpack(std::size_t point, std::span<const char> bytes) = 0;

  /// What the last evaluate() took for a point, in a unit that all points of
  /// the material share: weight for load balance.
  virtual double cost(std::size_t point) const = 0;

  /// What variables_of() gives, compression positive as in all output.
  virtual std::vector<Variable> variables() const { return {}; }

  /// Writes the variables of the committed state of a point.
  /// @param values  one for each of variables().
  virtual void variables_of(std::size_t /* point */,
                            std::span<double> /* values */) const
  {
  }
};
} // namespace tamp::fem

#endif
