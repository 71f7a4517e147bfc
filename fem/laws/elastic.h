// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_elastic_h
#define fem_laws_elastic_h

#include <fem/laws/density_table.h>
#include <fem/material_points.h>

#include <string_view>

namespace tamp::fem
{
/// Isotropic moduli at a density, and how they change with it.
struct ElasticModuli {
  double bulk = 0, shear = 0;             ///< [Pa]
  double bulk_slope = 0, shear_slope = 0; ///< d / d relative density [Pa]
  bool outside = false;                   ///< beyond the tables
};

/// Isotropic elasticity of a porous body.
struct PorousElasticity {
  DensityTable youngs_modulus{1e9};  ///< over relative density [Pa]
  DensityTable poissons_ratio{0.25}; ///< over relative density [-]

  ElasticModuli at(double relative_density) const;
  /// Throws std::invalid_argument unless E > 0 and -1 < nu < 0.5 everywhere.
  void check() const;
};

struct ElasticParameters {
  PorousElasticity elasticity;
  double initial_relative_density = 0.6;        ///< [-]
  dealii::SymmetricTensor<2, 3> initial_stress; ///< tension positive [Pa]

  /// Throws std::invalid_argument naming the first value that is not possible.
  void check() const;
};

/// Porous elasticity with moduli that depend on density, in rate form:
///
///   sigma_new = R (sigma_old + C(D_mid) : ln U) R^T,  dF = R U,
///
/// with the moduli at the density half-way through the increment, D_mid =
/// D_old (det dF)^(-1/2): second order in the increment. With constant moduli
/// an irrotational path with fixed axes gives sigma = C : ln V exactly,
/// whatever the number of increments. As any rate form with stiffness that
/// varies it does not derive from a potential: use it for moderate elastic
/// strains. The tangent is exact. Outside its tables the answer is doubtful; an
/// increment with det dF <= 0 fails and leaves the state as it was.
class Elastic
{
public:
  static constexpr std::string_view name = "elastic";

  struct State {
    dealii::SymmetricTensor<2, 3> stress; ///< Cauchy, tension positive [Pa]
    double relative_density = 0;          ///< [-]
  };

  /// Throws what ElasticParameters::check() throws.
  explicit Elastic(const ElasticParameters &parameters);

  State initial_state() const;
  Response respond(const State &old,
                   State &now,
                   const Deformation &deformation,
                   Want want) const;

private:
  ElasticParameters parameters_;
};
} // namespace tamp::fem

#endif
