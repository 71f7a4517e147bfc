// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/corotation.h>
#include <fem/laws/elastic.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
using dealii::SymmetricTensor;

ElasticModuli PorousElasticity::at(const double relative_density) const
{
  const auto E = youngs_modulus.read(relative_density);
  const auto nu = poissons_ratio.read(relative_density);
  const double a = 3 * (1 - 2 * nu.value), b = 2 * (1 + nu.value);
  ElasticModuli moduli;
  moduli.bulk = E.value / a;
  moduli.shear = E.value / b;
  moduli.bulk_slope = (E.slope + 6 * moduli.bulk * nu.slope) / a;
  moduli.shear_slope = (E.slope - 2 * moduli.shear * nu.slope) / b;
  moduli.outside = E.outside || nu.outside;
  return moduli;
}

void PorousElasticity::check() const
{
  std::ostringstream text;
  if (!(youngs_modulus.smallest() > 0))
    text << "Young's modulus " << youngs_modulus.smallest()
         << " Pa: expected a positive value";
  else if (!(poissons_ratio.smallest() > -1 && poissons_ratio.largest() < 0.5))
    text << "Poisson's ratio from " << poissons_ratio.smallest() << " to "
         << poissons_ratio.largest() << ": expected between -1 and 0.5";
  if (!text.str().empty())
    throw std::invalid_argument(text.str());
}

void ElasticParameters::check() const
{
  elasticity.check();
  if (!(initial_relative_density > 0 && initial_relative_density <= 1)) {
    std::ostringstream text;
    text << "initial relative density " << initial_relative_density
         << ": expected above 0 and up to 1";
    throw std::invalid_argument(text.str());
  }
}

Elastic::Elastic(const ElasticParameters &parameters) : parameters_(parameters)
{
  parameters_.check();
}

Elastic::State Elastic::initial_state() const
{
  return {parameters_.initial_stress, parameters_.initial_relative_density};
}

Response Elastic::respond(const State &old,
                          State &now,
                          const Deformation &deformation,
                          const Want want) const
{
  now = old;
  Response response{old.stress, {}, old.relative_density, Status::failed};
  const Corotation corotation(deformation.relative_F);
  if (!corotation.is_possible())
    return response;

  const auto &strain = corotation.log_stretch();
  const double density =
      old.relative_density / std::sqrt(corotation.volume_ratio());
  const ElasticModuli moduli = parameters_.elasticity.at(density);
  const auto unit = dealii::unit_symmetric_tensor<3>();
  CorotatedStress answer;
  answer.stress = old.stress + moduli.bulk * trace(strain) * unit +
                  2 * moduli.shear * deviator(strain);

  now.stress = corotation.rotate(answer.stress);
  now.relative_density = old.relative_density / corotation.volume_ratio();
  response.stress = now.stress;
  response.relative_density = now.relative_density;
  response.status = moduli.outside ? Status::doubtful : Status::converged;
  if (want == Want::stress_and_tangent) {
    const SymmetricTensor<2, 3> stiffening =
        moduli.bulk_slope * trace(strain) * unit +
        2 * moduli.shear_slope * deviator(strain);
    answer.by_log_stretch = moduli.bulk * outer_product(unit, unit) +
                            2 * moduli.shear * dealii::deviator_tensor<3>() -
                            0.5 * density * outer_product(stiffening, unit);
    response.tangent = corotation.tangent(answer);
  }
  return response;
}
} // namespace tamp::fem
