// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_return.h>
#include <fem/laws/corotation.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/expect_value.h>
#include <fem/laws/strain_derivative.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace tamp::fem
{
using dealii::SymmetricTensor;

namespace
{
using Surface = DruckerPragerCap::Surface;

/// An increment whose logarithmic stretch is larger than this fails.
constexpr double largest_strain = 1;

/// What changes during an increment, in the frame that does not turn.
template <class Number>
struct Point {
  std::array<Number, 6> deviator; ///< s, order of SymmetricTensor [Pa]
  Number p;                       ///< compression positive [Pa]
  Number compaction;              ///< eps [-]
  double plastic_shear = 0;
  Surface surface = Surface::none;
};

template <class Number>
Number deviator_norm(const std::array<Number, 6> &s)
{
  using std::sqrt;
  const Number square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] +
                        2. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  return value_of(square) > 0 ? Number(sqrt(1.5 * square)) : Number(0.);
}

/// The unknown change of compaction with its derivatives by strain, from the
/// implicit function theorem.
template <class Number>
Number lift(const DruckerPragerCapParameters &parameters,
            const CapTrial<Number> &trial,
            const CapReturn &found)
{
  Number x = found.compaction_change;
  if constexpr (!std::is_same_v<Number, double>) {
    const auto residual = return_residual<Number>(
        parameters,
        trial,
        found.surface == Surface::cap,
        {Number(found.compaction_change), Number(found.position)});
    const auto &inverse = found.inverse_jacobian[0];
    for (unsigned k = 0; k < 6; ++k)
      x.fastAccessDx(k) =
          -inverse[0] * residual[0].dx(k) - inverse[1] * residual[1].dx(k);
  }
  return x;
}

/// q / q_trial from the flow rule, in the form that is regular at q_trial = 0
/// where that is possible.
template <class Number>
Number deviator_ratio(const bool on_cap,
                      const CapSurface<Number> &s,
                      const CapTrial<Number> &trial,
                      const Number &p,
                      const Number &x)
{
  using std::sqrt;
  const Number stiffness = 3. * trial.shear * x / (s.factor * s.factor);
  if (on_cap) {
    const Number off = p - s.centre;
    if (value_of(off) > 0.7 * value_of(s.radius()))
      return Number(1. /
                    (1. + stiffness * s.eccentricity * s.eccentricity / off));
    const Number place = off / s.radius();
    return Number(s.top() * sqrt(1. - place * place) / trial.q);
  }
  const Number off = s.centre - p;
  if (value_of(off) > 0.5 * value_of(Number(s.centre - s.apex())))
    return Number(1. / (1. - stiffness / (off * s.tan_beta * s.tan_beta)));
  return Number(s.shear_limit(p) / trial.q);
}

/// One backward Euler part. False, and nothing changed, if the return did not
/// meet its tolerance.
template <class Number>
bool part(const DruckerPragerCapParameters &parameters,
          Point<Number> &point,
          const std::array<Number, 6> &strain)
{
  using std::exp;
  const Number density = parameters.reference_density * exp(point.compaction);
  const Number E = read(parameters.elasticity.youngs_modulus, density);
  const Number nu = read(parameters.elasticity.poissons_ratio, density);
  CapTrial<Number> trial;
  trial.bulk = E / (3. * (1. - 2. * nu));
  trial.shear = E / (2. * (1. + nu));
  trial.compaction = point.compaction;

  const Number volume = strain[0] + strain[1] + strain[2];
  std::array<Number, 6> deviator;
  for (unsigned k = 0; k < 6; ++k) {
    const Number shape = k < 3 ? Number(strain[k] - volume / 3.) : strain[k];
    deviator[k] = point.deviator[k] + 2. * trial.shear * shape;
  }
  trial.p = point.p - trial.bulk * volume;
  trial.q = deviator_norm(deviator);

  const CapReturn found = return_to_surface(parameters,
                                            {value_of(trial.p),
                                             value_of(trial.q),
                                             value_of(trial.bulk),
                                             value_of(trial.shear),
                                             value_of(trial.compaction)});
  if (!found.converged)
    return false;
  point.surface = found.surface;
  point.deviator = deviator;
  point.p = trial.p;
  if (found.surface == Surface::none)
    return true;

  const Number x = lift(parameters, trial, found);
  point.compaction = trial.compaction + x;
  point.p = trial.p - trial.bulk * x;
  const Number ratio = deviator_ratio(found.surface == Surface::cap,
                                      cap_surface(parameters, point.compaction),
                                      trial,
                                      point.p,
                                      x);
  for (Number &s : point.deviator)
    s *= ratio;
  point.plastic_shear +=
      value_of(trial.q) * (1 - value_of(ratio)) / (3 * value_of(trial.shear));
  return true;
}

/// A part, or its halves if it does not converge.
template <class Number>
bool advance(const DruckerPragerCapParameters &parameters,
             Point<Number> &point,
             const std::array<Number, 6> &strain,
             const unsigned halvings = 8)
{
  if (part(parameters, point, strain))
    return true;
  if (halvings == 0)
    return false;
  std::array<Number, 6> half;
  for (unsigned k = 0; k < 6; ++k)
    half[k] = 0.5 * strain[k];
  return advance(parameters, point, half, halvings - 1) &&
         advance(parameters, point, half, halvings - 1);
}

/// A point at the end of an increment; none if it failed.
template <class Number>
bool integrate(const DruckerPragerCapParameters &parameters,
               const DruckerPragerCap::State &old,
               const SymmetricTensor<2, 3> &strain,
               Point<Number> &point)
{
  const unsigned parts = std::max(
      1.,
      std::ceil(strain.norm() / parameters.maximum_strain_increment - 1e-9));
  point.p = pressure(old.stress);
  point.compaction = old.plastic_compaction;
  point.plastic_shear = old.plastic_shear;
  const auto s = deviator(old.stress);
  std::array<Number, 6> share;
  for (unsigned k = 0; k < 6; ++k) {
    point.deviator[k] = s.access_raw_entry(k);
    if constexpr (std::is_same_v<Number, double>)
      share[k] = strain.access_raw_entry(k) / parts;
    else
      share[k] = Number(6, k, strain.access_raw_entry(k)) / double(parts);
  }
  for (unsigned i = 0; i < parts; ++i)
    if (!advance(parameters, point, share))
      return false;
  return std::isfinite(value_of(point.p)) &&
         std::isfinite(value_of(deviator_norm(point.deviator)));
}

template <class Number>
SymmetricTensor<2, 3> stress_of(const Point<Number> &point)
{
  SymmetricTensor<2, 3> stress;
  for (unsigned k = 0; k < 6; ++k)
    stress.access_raw_entry(k) =
        value_of(point.deviator[k]) - (k < 3 ? value_of(point.p) : 0);
  return stress;
}

SymmetricTensor<4, 3> tangent_of(const Point<StrainDerivative> &point)
{
  SymmetricTensor<4, 3> tangent;
  for (unsigned m = 0; m < 6; ++m)
    for (unsigned k = 0; k < 6; ++k) {
      const auto ij = SymmetricTensor<2, 3>::unrolled_to_component_indices(m);
      const auto ab = SymmetricTensor<2, 3>::unrolled_to_component_indices(k);
      const double slope =
          point.deviator[m].dx(k) - (m < 3 ? point.p.dx(k) : 0);
      // A shear component stands for two entries of the strain.
      tangent[ij[0]][ij[1]][ab[0]][ab[1]] = k < 3 ? slope : slope / 2;
    }
  return tangent;
}

/// Integrates with or without derivatives. False if the increment failed.
template <class Number>
bool integrate(const DruckerPragerCapParameters &parameters,
               const DruckerPragerCap::State &old,
               const Corotation &corotation,
               DruckerPragerCap::State &now,
               Response &response)
{
  Point<Number> point;
  if (!integrate(parameters, old, corotation.log_stretch(), point))
    return false;
  CorotatedStress answer{stress_of(point), {}};
  now.stress = corotation.rotate(answer.stress);
  now.plastic_compaction = value_of(point.compaction);
  now.plastic_shear = point.plastic_shear;
  now.surface = point.surface;
  if constexpr (!std::is_same_v<Number, double>) {
    answer.by_log_stretch = tangent_of(point);
    response.tangent = corotation.tangent(answer);
    return std::isfinite(response.tangent.norm());
  }
  return true;
}

bool outside_tables(const DruckerPragerCapParameters &parameters,
                    const double compaction)
{
  const double density = parameters.reference_density * std::exp(compaction);
  return parameters.elasticity.at(density).outside ||
         parameters.cohesion.read(density).outside ||
         parameters.friction_angle.read(density).outside ||
         parameters.eccentricity.read(density).outside ||
         parameters.hardening.read(compaction).outside;
}

} // namespace

double pressure(const SymmetricTensor<2, 3> &stress)
{
  return -trace(stress) / 3;
}

double deviatoric_stress(const SymmetricTensor<2, 3> &stress)
{
  return std::sqrt(1.5) * deviator(stress).norm();
}

void DruckerPragerCapParameters::check() const
{
  elasticity.check();
  expect_value(cohesion.smallest() >= 0,
               "cohesion [Pa]",
               cohesion.smallest(),
               "not below 0");
  expect_value(friction_angle.smallest() > 0,
               "friction angle [rad]",
               friction_angle.smallest(),
               "above 0");
  expect_value(friction_angle.largest() < 1.5,
               "friction angle [rad]",
               friction_angle.largest(),
               "below 1.5 (86 degrees)");
  expect_value(eccentricity.smallest() > 0,
               "cap eccentricity [-]",
               eccentricity.smallest(),
               "above 0");
  expect_value(hardening.smallest() > 0,
               "hydrostatic yield pressure [Pa]",
               hardening.smallest(),
               "above 0");
  expect_value(hardening.is_increasing(),
               "hydrostatic yield pressure [Pa], from",
               hardening.smallest(),
               "a table that does not decrease");
  expect_value(reference_density > 0 && reference_density < 1,
               "reference density [-]",
               reference_density,
               "between 0 and 1");
  expect_value(initial_relative_density > 0 && initial_relative_density <= 1,
               "initial relative density [-]",
               initial_relative_density,
               "above 0 and up to 1");
  expect_value(transition >= 0 && transition <= 0.1 &&
                   1 + transition -
                           transition / std::cos(friction_angle.largest()) >
                       0.1,
               "transition alpha [-]",
               transition,
               "from 0 to 0.1 and below 0.9 / (1 / cos(beta) - 1)");
  expect_value(maximum_strain_increment > 0,
               "maximum strain increment [-]",
               maximum_strain_increment,
               "above 0");
}

DruckerPragerCap::DruckerPragerCap(const DruckerPragerCapParameters &parameters)
    : parameters_(parameters)
{
  parameters_.check();
}

DruckerPragerCap::State DruckerPragerCap::initial_state() const
{
  State state;
  state.relative_density = parameters_.initial_relative_density;
  state.plastic_compaction = std::log(parameters_.initial_relative_density /
                                      parameters_.reference_density);
  return state;
}

Response DruckerPragerCap::respond(const State &old,
                                   State &now,
                                   const Deformation &deformation,
                                   const Want want) const
{
  now = old;
  Response response{old.stress, {}, old.relative_density, Status::failed};
  const Corotation corotation(deformation.relative_F);
  if (!corotation.is_possible() ||
      corotation.log_stretch().norm() > largest_strain)
    return response;
  const bool good =
      want == Want::stress
          ? integrate<double>(parameters_, old, corotation, now, response)
          : integrate<StrainDerivative>(
                parameters_, old, corotation, now, response);
  if (!good) {
    now = old;
    response.tangent = {};
    return response;
  }
  now.relative_density = old.relative_density / corotation.volume_ratio();
  now.outside_tables = outside_tables(parameters_, now.plastic_compaction);
  response.stress = now.stress;
  response.relative_density = now.relative_density;
  response.status = now.outside_tables ? Status::doubtful : Status::converged;
  return response;
}

CapSurface<double>
DruckerPragerCap::surface(const double plastic_compaction) const
{
  return cap_surface(parameters_, plastic_compaction);
}

double DruckerPragerCap::yield(const State &state) const
{
  const auto s = surface(state.plastic_compaction);
  return s.yield(pressure(state.stress), deviatoric_stress(state.stress)) /
         (s.radius() + s.strength);
}
} // namespace tamp::fem
