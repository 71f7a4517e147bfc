// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_deform_h
#define dem_deform_h

#include <dem/kernel/instruction_set.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace tamp::dem
{
class UnitCell;

/// A symmetric stretch increment U, det U > 0: the cell h becomes U h [-].
using Stretch = Eigen::Matrix3d;

/// How the grains follow a stretch.
enum class Method {
  quasi_static, ///< static equilibrium, rate independent
  dynamics      ///< damped motion at a strain rate
};

/// In what numbers the sweep computes. Mixed: forces in single precision from
/// displacements since the last step or commit, places in double.
enum class Precision { double_precision, mixed };

/// How the sweep computes.
struct Arithmetic {
  Precision precision = Precision::double_precision;
  InstructionSet instruction_set = best_instruction_set();
};

/// Settings of the quasi-static map.
struct QuasiStatic {
  double unbalance_tolerance = 1e-3; ///< mean |F| of grains / mean |f| [-]
  /// Contact forces below this count as this in the unbalance [N].
  double force_floor = 0;
  /// A larger stretch increment is divided into equal parts [-].
  double maximum_strain_increment = 1e-2;
  std::size_t maximum_evaluations = 3000; ///< of all forces, per part
};

/// Settings of the damped dynamics of Sheng et al. (2004), eqs (1)-(6).
struct Dynamics {
  double strain_rate = 1e-5;       ///< largest principal rate [1/s]
  double density_scaling = 1e12;   ///< factor on the density of the grains [-]
  double time_step_fraction = 0.2; ///< of the Rayleigh time step [-]
  /// beta_g as a share of the critical damping of a mean grain [-].
  double global_damping = 0.05;
  /// Share taken off each component of force and torque of a grain while it
  /// drives the motion, and added while it brakes it [-]. Source: Cundall
  /// (1987).
  double local_damping = 0;
};

struct Driving {
  Method method = Method::quasi_static;
  QuasiStatic quasi_static;
  Dynamics dynamics;
  Arithmetic arithmetic;

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// What the contacts of a cell say at the start of a step.
struct StepStart {
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero(); ///< tension positive [Pa]
  double plastic_loss = 0;                          ///< of the normal laws [J]
};

/// What trials of the same step hand on: where the grains of the last one came
/// to rest, which starts the relaxation, and what all of them start from. A
/// value of the caller's, cleared at the start of a step; no motion is ever
/// kept from a cell that did not settle.
struct WarmGuess {
  std::vector<double> motion;     ///< non-affine motion and rotation, 6 a grain
  double predictor_scale = -1;    ///< frozen within a step; negative: not set
  std::optional<StepStart> start; ///< of the committed cell; none: not set
  bool empty() const { return motion.empty(); }
  void clear()
  {
    motion.clear();
    predictor_scale = -1;
    start.reset();
  }
};

enum class Outcome { settled, unsettled, diverged };

/// What a cell says after a stretch.
struct CellAnswer {
  Outcome outcome = Outcome::settled;
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero(); ///< Cauchy, contacts only,
                                                    ///< tension positive [Pa]
  double unbalance = 0; ///< mean |F| of grains / mean |f| of contacts [-]
  /// |micro work - macro work| / sum of |contact work|, last increment [-]. Of
  /// quasi-static increments over the elastic energy, if that is more.
  double hill_mandel = 0;
  std::size_t evaluations = 0; ///< of all contact forces
};

/// Takes a cell along a stretch increment. The cell then holds the new state,
/// its contact history included. Deterministic; without a guess a pure function
/// of the cell, the stretch and the driving. After `diverged` the cell's
/// content is of no use: go back to a copy. Throws std::invalid_argument if a
/// law does not hold for the smallest grains, see CellLaws::check(). Limiting
/// contact pressures that are adjusted to the density are, in each part of a
/// divided increment, those of the density at its start.
/// @param guess  in: a warm start or empty; out: the start for the next trial
///               from the same committed cell. May be null.
CellAnswer deform(UnitCell &cell,
                  const Stretch &stretch,
                  const Driving &driving,
                  WarmGuess *guess = nullptr);
} // namespace tamp::dem

#endif
