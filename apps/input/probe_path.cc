// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/probe_path.h>
#include <apps/input/stage_reader.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
using Control = fem::ComponentTarget::Control;

constexpr unsigned xx = 0, yy = 1, zz = 2, xz = 4;
// No path is driven further than this while it waits for a stress.
constexpr double far = 1.5;
constexpr unsigned steps_to_a_pressure = 10;

fem::PathStage at_rest(const std::string &name, double increment)
{
  fem::PathStage stage;
  stage.name = name;
  stage.components.fill({Control::strain, 0, true});
  stage.maximum_increment = increment;
  return stage;
}

// Inputs are compression positive, the driver is tension positive.
void compress_to(fem::PathStage &stage, unsigned component, double strain)
{
  stage.components[component] = {Control::strain, -strain, false};
}

void press_to(fem::PathStage &stage, unsigned component, double stress)
{
  stage.components[component] = {Control::stress, -stress, false};
  stage.minimum_steps = steps_to_a_pressure;
}

void stop_at(fem::PathStage &stage, double stress, bool unloading)
{
  stage.components[zz] = {Control::strain, unloading ? far : -far, true};
  stage.has_until = true;
  stage.until_component = zz;
  stage.until_stress = -stress;
  stage.until_above = unloading;
}

double positive_strain(StageReader &reader)
{
  return reader.positive(dimension::number);
}

double positive_density(StageReader &reader)
{
  const double density = reader.positive(dimension::number);
  if (!(density < 1))
    reader.fail("a relative density between 0 and 1 before");
  return density;
}

// "to strain E", or "by strain E" since the start of the stage; only the first
// if the sign of E is free.
void read_strain(StageReader &reader,
                 fem::PathStage &stage,
                 unsigned component,
                 bool positive)
{
  const bool relative = reader.expect({"to", "by"}) == 1;
  reader.expect({"strain"});
  compress_to(stage,
              component,
              positive ? positive_strain(reader)
                       : reader.quantity(dimension::number));
  stage.components[component].relative = relative;
}

void read_isotropic(StageReader &reader, ProbeStage &probe)
{
  fem::PathStage &stage = probe.stage;
  reader.expect({"to"});
  switch (reader.expect({"strain", "pressure", "density"})) {
  case 0: {
    const double strain = positive_strain(reader);
    for (const unsigned component : {xx, yy, zz})
      compress_to(stage, component, strain);
    break;
  }
  case 1: {
    const double pressure = reader.quantity(dimension::pressure);
    for (const unsigned component : {xx, yy, zz})
      press_to(stage, component, pressure);
    break;
  }
  default:
    probe.density = positive_density(reader);
    for (const unsigned component : {xx, yy, zz})
      stage.components[component].value = -1. / 3;
  }
}

void read_uniaxial(StageReader &reader, ProbeStage &probe)
{
  reader.expect({"to"});
  switch (reader.expect({"strain", "stress", "density"})) {
  case 0:
    compress_to(probe.stage, zz, positive_strain(reader));
    break;
  case 1:
    stop_at(probe.stage, reader.quantity(dimension::pressure), false);
    break;
  default:
    probe.density = positive_density(reader);
    probe.stage.components[zz].value = -1;
  }
}

void read_unload(StageReader &reader, ProbeStage &probe)
{
  reader.expect({"to"});
  if (reader.accept("strain")) {
    compress_to(probe.stage, zz, reader.quantity(dimension::number));
    return;
  }
  reader.accept("stress");
  const Quantity target = reader.any_quantity();
  const bool share = target.dimension == dimension::number;
  if (!share && target.dimension && target.dimension != dimension::pressure)
    reader.fail("a stress such as 100 kPa before, or a share of the peak such "
                "as 1 %");
  stop_at(probe.stage, share ? 0 : target.value, true);
  if (share) {
    probe.peak_share = target.value;
    if (!(target.value > 0 && target.value < 1))
      reader.fail("a share of the peak between 0 and 100 % before");
  }
  if (reader.accept("of"))
    reader.expect({"peak"});
}

void read_triaxial(StageReader &reader, fem::PathStage &stage)
{
  read_strain(reader, stage, zz, true);
  reader.expect({"at"});
  reader.expect({"pressure"});
  const double pressure = reader.quantity(dimension::pressure);
  press_to(stage, xx, pressure);
  press_to(stage, yy, pressure);
}

void read_proportional(StageReader &reader, fem::PathStage &stage)
{
  const double ratio = reader.quantity(dimension::number);
  reader.expect({"to"});
  reader.expect({"strain"});
  const double strain = positive_strain(reader);
  compress_to(stage, zz, strain);
  compress_to(stage, xx, ratio * strain);
  compress_to(stage, yy, ratio * strain);
}

// Steps of a shear F_xz whose strain, half of it, keeps to the increment.
void read_simple_shear(StageReader &reader, fem::PathStage &stage)
{
  reader.expect({"shear"});
  reader.expect({"to"});
  reader.expect({"strain"});
  const double shear = -reader.quantity(dimension::number);
  const auto steps = static_cast<unsigned>(std::max(
      1., std::ceil(0.5 * std::abs(shear) / stage.maximum_increment - 1e-6)));
  for (unsigned i = 1; i <= steps; ++i) {
    stage.gradients.emplace_back(dealii::unit_symmetric_tensor<3>());
    stage.gradients.back()[0][2] = shear * (1. * i / steps);
  }
}

void read_constant_p(StageReader &reader, fem::PathStage &stage)
{
  const bool shear = reader.expect({"shear", "compression"}) == 0;
  read_strain(reader, stage, shear ? xz : zz, !shear);
  reader.expect({"at"});
  reader.expect({"pressure"});
  const double pressure = reader.quantity(dimension::pressure);
  for (const unsigned component : {xx, yy, zz})
    if (shear)
      press_to(stage, component, pressure);
    else if (component != zz)
      press_to(stage, component, 1.5 * pressure);
  if (!shear)
    stage.axial_share = 0.5;
}

void read_components(StageReader &reader, fem::PathStage &stage)
{
  do {
    const auto component = static_cast<unsigned>(
        reader.expect({"xx", "yy", "zz", "yz", "xz", "xy"}));
    if (reader.expect({"strain", "stress"}) == 0)
      compress_to(stage, component, reader.quantity(dimension::number));
    else
      press_to(stage, component, reader.quantity(dimension::pressure));
  } while (!reader.done());
}

const std::vector<std::string> stage_kinds{"isotropic",
                                           "uniaxial",
                                           "unload",
                                           "triaxial",
                                           "proportional",
                                           "shear",
                                           "components",
                                           "hold",
                                           "csv",
                                           "simple",
                                           "constant-p"};

ProbeStage read_stage(const std::string &text,
                      unsigned number,
                      const ProbeIncrements &increments)
{
  StageReader reader(text, number);
  ProbeStage probe;
  const std::size_t kind = reader.expect(stage_kinds);
  fem::PathStage &stage = probe.stage;
  stage = at_rest(stage_kinds[kind], increments.loading);
  switch (kind) {
  case 0:
    read_isotropic(reader, probe);
    break;
  case 1:
    read_uniaxial(reader, probe);
    break;
  case 2:
    stage.maximum_increment = increments.unloading;
    read_unload(reader, probe);
    break;
  case 3:
    read_triaxial(reader, stage);
    break;
  case 4:
    read_proportional(reader, stage);
    break;
  case 5:
    reader.expect({"to"});
    reader.expect({"strain"});
    compress_to(stage, xz, reader.quantity(dimension::number));
    break;
  case 6:
    read_components(reader, stage);
    break;
  case 7:
    stage.minimum_steps = reader.whole();
    reader.expect({"steps", "step"});
    break;
  case 8:
    probe.file = reader.rest();
    break;
  case 9:
    read_simple_shear(reader, stage);
    break;
  default:
    read_constant_p(reader, stage);
  }
  reader.finish();
  return probe;
}
} // namespace

ProbePath parse_path(const std::string &stages,
                     const ProbeIncrements &increments)
{
  ProbePath path;
  const auto texts = split_stages(stages);
  if (texts.empty())
    throw InputError("there is no stage; expected for example 'uniaxial to "
                     "strain 0.15; unload to 1 % of peak'");
  for (const std::string &text : texts)
    path.stages.push_back(read_stage(
        text, static_cast<unsigned>(path.stages.size() + 1), increments));
  return path;
}

void aim_at_density(const ProbeStage &probe,
                    double density_now,
                    fem::PathStage &stage)
{
  if (!(density_now < probe.density))
    throw InputError(fmt::format(
        "Path/Stages: the {} stage to density {:g} begins at a relative "
        "density of {:.4g}; expected a larger one",
        stage.name,
        probe.density,
        density_now));
  const double strain = std::log(probe.density / density_now);
  for (const unsigned component : {xx, yy, zz})
    stage.components[component].value =
        strain * probe.stage.components[component].value;
}

} // namespace tamp::apps
