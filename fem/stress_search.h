// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_stress_search_h
#define fem_stress_search_h

#include <fem/material_points.h>

#include <array>
#include <vector>

/// What a path driver is made of: a point that is moved alone, and the search
/// for the strains that give it prescribed stresses.
namespace tamp::fem::path
{
using Six = std::array<double, 6>; ///< xx, yy, zz, yz, xz, xy

/// The six components of a tensor.
Six components(const dealii::SymmetricTensor<2, 3> &tensor);
/// The largest absolute value.
double largest(const Six &values);
/// a - b.
Six difference(const Six &a, const Six &b);
/// The symmetric stretch exp(E) of a logarithmic strain E [-]; exactly diagonal
/// if E is.
dealii::Tensor<2, 3> stretch(const Six &strain);

/// A deformation gradient F = exp(strain) rotation.
struct LeftSplit {
  Six strain; ///< ln V, V symmetric [-]
  dealii::Tensor<2, 3> rotation;
};
/// Splits a deformation gradient; the rotation is exactly none if F is diagonal
/// and positive.
LeftSplit left_split(const dealii::Tensor<2, 3> &F);

/// F_new F_old^-1; exactly diagonal if both are.
dealii::Tensor<2, 3> increment(const dealii::Tensor<2, 3> &F_new,
                               const dealii::Tensor<2, 3> &F_old);

/// Point 0 of some material points; the others stand still.
class Probe
{
public:
  /// Throws if there is no point.
  explicit Probe(MaterialPoints &points);

  /// The answer of the point at F, counted from where it was at construction.
  const Response &evaluate(const dealii::Tensor<2, 3> &F, Want want);
  /// The same after an increment since the last commit, to the bit.
  const Response &evaluate_increment(const dealii::Tensor<2, 3> &relative_F,
                                     Want want);
  void begin_attempt() { points_.begin_attempt(); }
  /// Adopts the last evaluation.
  void commit();
  /// The point is at F now: its committed state is from elsewhere.
  void stand_at(const dealii::Tensor<2, 3> &F) { F_ = F; }

  /// At the last commit [-].
  const dealii::Tensor<2, 3> &F() const { return F_; }
  /// Of the last evaluation.
  const Response &response() const { return responses_[0]; }

private:
  MaterialPoints &points_;
  dealii::Tensor<2, 3> F_, trial_F_;
  std::vector<Deformation> deformations_;
  std::vector<Response> responses_;
};

/// What an increment aims at.
struct Goal {
  std::vector<unsigned> free;    ///< components under stress control
  Six strain{};                  ///< of the components under strain control
  Six stress{};                  ///< of the free components
  double tolerance = 0;          ///< relative to the largest stress
  double stress_scale = 0;       ///< the largest stress is at least this [Pa]
  double largest_correction = 0; ///< of a strain component in an iteration
  double axial_share = 0;        ///< see PathStage [-]
  bool deviatoric = false;       ///< see PathStage
  dealii::Tensor<2, 3> rotation = dealii::unit_symmetric_tensor<3>(); ///< R [-]
};

/// Finds the free strains of one increment: Newton's method with the tangent
/// of the point, kept and improved by Broyden's rank-one updates (Broyden
/// 1965), corrections limited in size and halved where the residual grows.
class StressSearch
{
public:
  StressSearch(Probe &probe, const Goal &goal) : probe_(probe), goal_(goal) {}

  /// @param strain  in: a guess of the free strains; out: the solution, which
  ///                is also the last trial of the probe. False: none found.
  [[nodiscard]] bool find(Six &strain);

private:
  bool evaluate(const Six &strain, Want want);
  void hold_axis(Six &strain) const;
  double scale() const;
  void take_tangent();
  std::vector<double> correction() const;
  bool correct();
  void update(const std::vector<double> &step);

  Probe &probe_;
  const Goal &goal_;
  Six strain_{};
  std::vector<double> residual_, trial_residual_;
  std::vector<std::vector<double>> slope_;
};
} // namespace tamp::fem::path

#endif
