// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_test_points_h
#define tests_fem_test_points_h

#include <fem/material_points.h>

#include <functional>
#include <vector>

namespace tamp::fem::test
{
/// Isotropic law between Hencky strain h = ln V and Cauchy stress:
/// sigma = lambda tr(h) I + 2 mu h, both moduli scaled with
/// exp(-stiffening tr h); exact under rotation.
struct HenckyLaw {
  double lambda = 6e8, mu = 4e8; ///< [Pa]
  double stiffening = 0;         ///< [-]
  double density = 0.5;          ///< relative, undeformed [-]

  dealii::SymmetricTensor<2, 3> stress(const dealii::Tensor<2, 3> &F) const;
};

/// Points of the Hencky law; the tangent by central differences, or scaled to
/// be wrong.
class HenckyPoints : public MaterialPoints
{
public:
  HenckyPoints(std::size_t size, const HenckyLaw &law);

  std::size_t size() const override { return committed_.size(); }
  void evaluate(std::span<const Deformation> deformations,
                Want want,
                std::span<Response> responses) override;
  void commit() override;
  void pack(std::size_t, std::vector<char> &) const override {}
  void unpack(std::size_t, std::span<const char>) override {}
  double cost(std::size_t) const override { return 0; }

  /// Called after each evaluation, with its number from 1 on, to spoil it.
  std::function<void(unsigned, std::span<Response>)> spoil;
  double tangent_scale = 1;
  unsigned evaluations = 0, commits = 0;
  bool last_was_spoilt = false, committed_spoilt = false;

  const std::vector<dealii::Tensor<2, 3>> &committed() const
  {
    return committed_;
  }

private:
  Response respond(const dealii::Tensor<2, 3> &F, Want want) const;

  HenckyLaw law_;
  std::vector<dealii::Tensor<2, 3>> committed_, trial_; ///< F since the start
};
} // namespace tamp::fem::test

#endif
