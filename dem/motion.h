// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_motion_h
#define dem_motion_h

#include <dem/deform.h>
#include <dem/sweep_layout.h>
#include <dem/tensors.h>

#include <cstddef>
#include <vector>

namespace tamp::dem
{
class UnitCell;

/// Mass of a grain whose density is scaled [kg].
double
grain_mass(const UnitCell &cell, std::size_t grain, double density_scaling);

/// Damped motion of all grains of a cell, from now until the object dies: how
/// the grains of dynamics and of servos move. The cell is complete
/// after every call; its velocities are those of whole steps.
/// Leapfrog in the frame of Sheng et al. (2004): fluctuations of the velocity
/// obey Newton's law, eqs (1) and (2), places follow the box besides.
class Motion
{
public:
  /// Gives the cell velocities if it has none.
  Motion(UnitCell &cell, const Dynamics &settings);

  /// Time step now: a share of the Rayleigh step and of the stability bound of
  /// the contacts that touch [s].
  double time_step() const;

  /// Takes the cell along a stretch exp(log_stretch) in equal time steps. The
  /// work of the stress and all losses are booked step by step. Returns false
  /// if grains were crushed or flew apart: then the cell is of no use.
  [[nodiscard]] bool
  advance(const Matrix3 &log_stretch, std::size_t steps, double time_step);

  /// Cauchy stress of the contacts, tension positive, not symmetrised [Pa].
  Matrix3 stress() const;
  /// Mean |F| of grains / mean |f| of contacts [-].
  double unbalance() const;
  /// Of the last time step, see hill_mandel_residual().
  double hill_mandel() const;
  /// Time steps so far.
  std::size_t steps() const { return steps_; }

private:
  void list_pairs();
  void half_kick(bool first);
  void drift(const Matrix3 &box);
  void renew_pairs(double affine_approach);
  void sweep(Memory memory);

  UnitCell &cell_;
  double time_step_fraction_, rayleigh_;
  SweepLayout layout_;
  SweepTotals totals_;
  std::vector<double> mass_;
  double damping_ = 0;      // beta_g [kg/s]
  double spin_damping_ = 0; // [kg m2/s]
  double step_ = 0;         // [s]
  AffineMotion affine_;
  Matrix3 step_back_ = Matrix3::Identity();
  Matrix3 stress_volume_; // stress times volume now [J]
  double approached_ = 0; // of unlisted pairs, since the pairs were listed [m]
  std::size_t steps_ = 0;
};
} // namespace tamp::dem

#endif
