// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_compression_h
#define dem_compression_h

#include <dem/tensors.h>

#include <functional>

namespace tamp::dem
{
class UnitCell;
struct CellAnswer;

/// How the box shrinks: alike in all directions, or along the die axis z alone
/// with the lateral edges held.
enum class Compression { isotropic, uniaxial };

/// What tells that a packing is done.
enum class CompressionTarget { pressure, relative_density };

/// Where a packing is compressed to.
struct CompressionGoal {
  Compression compression = Compression::isotropic;
  CompressionTarget target = CompressionTarget::pressure;
  /// Mean stress, or axial stress if uniaxial [Pa]; within 1 %. Targets only.
  double pressure = 100e3;
  double relative_density = 0.6; ///< [-]; met to rounding. Targets only.

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// Told of the cell after every step of a compression, and the answer of that
/// step. May throw to end the compression.
using CompressionObserver =
    std::function<void(const UnitCell &cell, const CellAnswer &answer)>;

/// Compresses a loose cell, with its own contact model, in steps of the
/// quasi-static map until its goal is reached at equilibrium. Deterministic.
/// Throws std::runtime_error, with the cell left where it stands, if the goal
/// is not reached or the cell is beyond it from the start.
void compress(UnitCell &cell,
              const CompressionGoal &goal,
              const CompressionObserver &observe = {});

/// The pressure that a goal speaks of: mean or axial, compression positive, of
/// a stress with tension positive [Pa].
double goal_pressure(Compression compression, const Matrix3 &stress);
} // namespace tamp::dem

#endif
