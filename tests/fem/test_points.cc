// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/test_points.h>

#include <cmath>

namespace tamp::fem::test
{
namespace
{
dealii::Tensor<2, 3> unit_tensor()
{
  dealii::Tensor<2, 3> unit;
  unit[0][0] = unit[1][1] = unit[2][2] = 1;
  return unit;
}

/// ln V = ln(F F^T) / 2.
dealii::SymmetricTensor<2, 3> hencky_strain(const dealii::Tensor<2, 3> &F)
{
  const auto b = dealii::symmetrize(F * dealii::transpose(F));
  const auto pairs =
      dealii::eigenvectors(b, dealii::SymmetricTensorEigenvectorMethod::jacobi);
  dealii::SymmetricTensor<2, 3> h;
  for (const auto &[value, vector] : pairs)
    h += 0.5 * std::log(value) *
         dealii::symmetrize(dealii::outer_product(vector, vector));
  return h;
}
} // namespace

dealii::SymmetricTensor<2, 3>
HenckyLaw::stress(const dealii::Tensor<2, 3> &F) const
{
  const auto h = hencky_strain(F);
  const double volume = dealii::trace(h);
  return std::exp(-stiffening * volume) *
         (lambda * volume * dealii::unit_symmetric_tensor<3>() + 2 * mu * h);
}

HenckyPoints::HenckyPoints(std::size_t size, const HenckyLaw &law)
    : law_(law), committed_(size, unit_tensor()), trial_(committed_)
{
}

Response HenckyPoints::respond(const dealii::Tensor<2, 3> &F, Want want) const
{
  Response response;
  response.stress = law_.stress(F);
  response.relative_density = law_.density / dealii::determinant(F);
  if (want == Want::stress)
    return response;
  const double d = 1e-5;
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned l = k; l < 3; ++l) {
      dealii::Tensor<2, 3> plus = unit_tensor(), minus = unit_tensor();
      plus[k][l] += 0.5 * d;
      plus[l][k] += 0.5 * d;
      minus[k][l] -= 0.5 * d;
      minus[l][k] -= 0.5 * d;
      const auto slope =
          tangent_scale * (law_.stress(plus * F) - law_.stress(minus * F)) /
          (2 * d);
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = i; j < 3; ++j)
          response.tangent[i][j][k][l] = slope[i][j];
    }
  return response;
}

void HenckyPoints::evaluate(std::span<const Deformation> deformations,
                            Want want,
                            std::span<Response> responses)
{
  for (std::size_t point = 0; point < size(); ++point) {
    trial_[point] = deformations[point].relative_F * committed_[point];
    responses[point] = respond(trial_[point], want);
  }
  ++evaluations;
  last_was_spoilt = false;
  if (spoil)
    spoil(evaluations, responses);
  for (const Response &response : responses)
    if (response.status == Status::failed)
      last_was_spoilt = true;
}

void HenckyPoints::commit()
{
  ++commits;
  committed_spoilt = committed_spoilt || last_was_spoilt;
  committed_ = trial_;
}
} // namespace tamp::fem::test
