// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/material_factory.h>
#include <coupling/packing_library.h>
#include <coupling/unit_cell_points.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/elastic.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace tamp::coupling
{
namespace
{
using fem::DensityTable;

DensityTable table(const std::vector<double> &nodes,
                   const std::vector<double> &values,
                   const std::string &name)
{
  if (nodes.size() == 1 && values.size() == 1)
    return DensityTable(values[0]);
  return DensityTable({nodes, values}, name);
}

fem::PorousElasticity elasticity(const ElasticTable &choice)
{
  return {
      table(choice.relative_density, choice.youngs_modulus, "Young's modulus"),
      table(choice.relative_density, choice.poissons_ratio, "Poisson's ratio")};
}

// The law reads p_b over the plastic volumetric strain since the first density
// of the table; above the table the last line goes on.
DensityTable hardening(const CapChoice &choice)
{
  if (choice.hardening_density.empty())
    throw std::invalid_argument("the hardening table is empty");
  std::vector<double> strains;
  for (const double density : choice.hardening_density)
    strains.push_back(std::log(density / choice.hardening_density.front()));
  return DensityTable({strains, choice.hydrostatic_yield},
                      "hydrostatic yield pressure",
                      DensityTable::Shape::increasing,
                      DensityTable::Above::extend);
}

// Points of a law of these parameters, each at its own density.
template <class Law, class Parameters>
Material make_points(const MaterialChoice &choice,
                     Parameters parameters,
                     std::size_t count)
{
  const Law law(parameters);
  std::vector<typename Law::State> states(count, law.initial_state());
  if (!choice.densities.empty())
    for (std::size_t i = 0; i < count; ++i) {
      parameters.initial_relative_density =
          choice.densities.at(choice.first_point + i);
      states[i] = Law(parameters).initial_state();
    }
  return {std::make_unique<fem::ContinuumPoints<Law>>(law, std::move(states)),
          nullptr};
}

fem::ElasticParameters elastic_parameters(const ElasticChoice &choice)
{
  fem::ElasticParameters parameters;
  parameters.elasticity = elasticity(choice.elasticity);
  parameters.initial_relative_density = choice.initial_relative_density;
  return parameters;
}

// Numbers of the packings of these points, each once: further points take them
// in turn.
std::vector<std::size_t> packing_numbers(const MaterialChoice &choice,
                                         std::size_t count)
{
  std::size_t different = choice.packings;
  if (const std::size_t files = choice.packing_files.size(); files > 0)
    different = different > 0 ? std::min(different, files) : files;
  std::vector<std::size_t> numbers(different > 0 ? std::min(count, different)
                                                 : count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t point = choice.first_point + i;
    numbers[i] =
        choice.first_packing + (different > 0 ? point % different : point);
  }
  return numbers;
}

StoredPackings find_packings(const MaterialChoice &choice,
                             std::size_t count,
                             const std::function<void(std::size_t)> &progress)
{
  const std::vector<std::size_t> numbers = packing_numbers(choice, count);
  if (!choice.packing_files.empty())
    return read_packings(choice.packing_files, choice.packing, numbers);
  choice.packing.check();
  std::vector<dem::PackingRequest> samples;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    samples.push_back(sample_of(choice.packing, numbers[i]));
    if (choice.densities.empty())
      continue;
    dem::CompressionGoal &goal = samples.back().goal;
    goal.target = dem::CompressionTarget::relative_density;
    goal.relative_density = choice.densities.at(choice.first_point + i);
  }
  return {make_packings(samples, choice.threads, progress), History::kept};
}

CellPointsOptions options_of(const MaterialChoice &choice)
{
  CellPointsOptions options;
  options.driving = choice.driving;
  options.threads = choice.threads;
  options.warm = choice.warm;
  options.first_point = choice.first_point;
  return options;
}

Material make_cells(const MaterialChoice &choice,
                    std::size_t count,
                    const std::function<void(std::size_t)> &progress)
{
  choice.driving.check();
  StoredPackings packings = find_packings(choice, count, progress);
  std::vector<std::size_t> cell_of(count);
  for (std::size_t i = 0; i < count; ++i)
    cell_of[i] = i % packings.cells.size();
  auto points = std::make_unique<UnitCellPoints>(
      std::move(packings.cells), std::move(cell_of), options_of(choice));
  Material material;
  material.cells = points.get();
  material.points = std::move(points);
  material.history = packings.history;
  return material;
}
} // namespace

fem::DruckerPragerCapParameters cap_parameters(const CapChoice &choice)
{
  fem::DruckerPragerCapParameters parameters;
  parameters.elasticity = elasticity(choice.elasticity);
  parameters.cohesion =
      table(choice.relative_density, choice.cohesion, "cohesion");
  parameters.friction_angle =
      table(choice.relative_density, choice.friction_angle, "friction angle");
  parameters.eccentricity = table(
      choice.relative_density, choice.cap_eccentricity, "cap eccentricity");
  parameters.hardening = hardening(choice);
  parameters.reference_density = choice.hardening_density.front();
  parameters.initial_relative_density = choice.initial_relative_density;
  parameters.transition = choice.transition;
  parameters.dilation = choice.dilation;
  parameters.integration_tolerance = choice.integration_tolerance;
  return parameters;
}

Material make_material(const MaterialChoice &choice,
                       std::size_t count,
                       const std::function<void(std::size_t)> &progress)
{
  switch (choice.kind) {
  case MaterialKind::unit_cell:
    return make_cells(choice, count, progress);
  case MaterialKind::elastic:
    return make_points<fem::Elastic>(
        choice, elastic_parameters(choice.elastic), count);
  case MaterialKind::drucker_prager_cap:
    return make_points<fem::DruckerPragerCap>(
        choice, cap_parameters(choice.cap), count);
  case MaterialKind::modified_cam_clay:
    if (!choice.densities.empty())
      throw std::invalid_argument(
          "initial densities of points need a material whose state follows "
          "from "
          "its density, which that of modified Cam-Clay does not");
    return make_points<fem::ModifiedCamClay>(choice, choice.cam_clay, count);
  case MaterialKind::fkm_gurson:
    return make_points<fem::FkmGurson>(choice, choice.fkm_gurson, count);
  }
  throw std::invalid_argument("unknown kind of material");
}

Material copy_point(const MaterialChoice &choice, const Material &material)
{
  Material copy;
  if (material.cells) {
    CellPointsOptions options = options_of(choice);
    options.threads = 1;
    auto points = std::make_unique<UnitCellPoints>(
        std::vector<dem::UnitCell>{material.cells->cell(0)}, options);
    copy.cells = points.get();
    copy.points = std::move(points);
  } else
    copy = make_material(choice, 1);
  std::vector<char> state;
  material.points->pack(0, state);
  copy.points->unpack(0, state);
  return copy;
}
} // namespace tamp::coupling
