// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_die_run_h
#define tests_fem_die_run_h

#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/elastic.h>

#include <gtest/gtest.h>
#include <vector>

namespace tamp::fem::test
{
/// A die that continuum laws are pressed in: Newton's method to a small
/// residual, no friction unless it is set.
inline DieSettings frictionless_die(unsigned radial, unsigned axial)
{
  DieSettings settings;
  settings.geometry.radial_elements = radial;
  settings.geometry.axial_elements = axial;
  settings.friction.fill(FrictionCoefficient(0));
  settings.solver.method = NonlinearMethod::newton;
  settings.solver.force_tolerance = 1e-9;
  settings.solver.displacement_tolerance = 1e-8;
  return settings;
}

inline Elastic elastic_law(double youngs_modulus,
                           double poissons_ratio,
                           double radial_stress = 0)
{
  ElasticParameters parameters;
  parameters.elasticity.youngs_modulus = youngs_modulus;
  parameters.elasticity.poissons_ratio = poissons_ratio;
  parameters.initial_relative_density = 0.5;
  parameters.initial_stress[0][0] = radial_stress;
  parameters.initial_stress[1][1] = radial_stress;
  return Elastic(parameters);
}

/// A die model of a law with what it borrows.
template <class Law>
struct DieRun {
  DieSettings settings;
  Mesh mesh;
  ContinuumPoints<Law> points;
  DieModel model;
  std::vector<StepRecord> records; ///< of the steps since the start

  DieRun(const DieSettings &chosen, const Law &law)
      : settings(chosen), mesh(build_mesh(chosen.geometry)),
        points(law, mesh.number_of_points()), model(settings, mesh, points)
  {
    Advance advance = Advance::stepped;
    while ((advance = model.advance()) == Advance::stepped)
      records.push_back(model.last_step());
    EXPECT_EQ(advance, Advance::finished) << model.failure().reason;
  }

  const StepRecord &last() const { return model.last_step(); }
  std::vector<StepRecord> of(unsigned stage) const
  {
    std::vector<StepRecord> result;
    for (const StepRecord &record : records)
      if (record.stage == stage)
        result.push_back(record);
    return result;
  }
};
template <class Law>
DieRun(const DieSettings &, const Law &) -> DieRun<Law>;

inline Stage press_down(double displacement)
{
  return {StageKind::press, StageTarget::displacement, displacement};
}
} // namespace tamp::fem::test

#endif
