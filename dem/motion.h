// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_motion_h
#define dem_motion_h

#include <dem/deform.h>
#include <dem/tensors.h>

#include <cstddef>
#include <memory>

namespace tamp::dem
{
class UnitCell;

/// Damped motion of all grains of a cell: how the grains of dynamics and of
/// servos move. Leapfrog in the frame of Sheng et al. (2004): fluctuations of
/// the velocity obey Newton's law, eqs (1) and (2), places follow the box
/// besides. Velocities are those of whole steps and stay in the cell; the first
/// and the last half step of an advance are half kicks.
class Motion
{
public:
  virtual ~Motion() = default;

  /// Takes the cell along a stretch exp(log_stretch) in equal time steps. The
  /// work of the stress and all losses are booked step by step. Returns false
  /// if grains were crushed or flew apart: then the cell is of no use.
  [[nodiscard]] virtual bool
  advance(const Matrix3 &log_stretch, std::size_t steps, double time_step) = 0;

  /// Writes places, contacts and losses into the cell, which is complete until
  /// the next advance.
  virtual void write_cell() = 0;

  /// Time step now: a share of the Rayleigh step and of the stability bound of
  /// the contacts that touched when the pairs were listed or touch now [s].
  virtual double time_step() const = 0;
  /// Cauchy stress of the contacts, tension positive, not symmetrised [Pa].
  virtual Matrix3 stress() const = 0;
  /// Mean |F| of grains / mean |f| of contacts [-].
  virtual double unbalance() const = 0;
  /// Of the last time step, see hill_mandel_residual(); after write_cell().
  virtual double hill_mandel() const = 0;
  /// Time steps so far.
  virtual std::size_t steps() const = 0;
};

/// Starts the motion of a cell, which must outlive it, and gives it velocities
/// if it has none.
std::unique_ptr<Motion> start_motion(UnitCell &cell,
                                     const Dynamics &settings,
                                     const Arithmetic &arithmetic);

/// Where a cell came to: stress, unbalance, residual and the time steps so far,
/// as an outcome. Completes the cell.
CellAnswer end_motion(Motion &motion, Outcome outcome);
} // namespace tamp::dem

#endif
