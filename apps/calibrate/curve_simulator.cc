// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/curve_simulator.h>
#include <apps/output/growing_file.h>
#include <apps/run/interrupt.h>
#include <coupling/unit_cell_points.h>
#include <coupling/whole_file.h>
#include <fem/die_model.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace tamp::apps
{
namespace
{
// Forces that are small against those of the peak need no perfect balance when
// it is unloaded: this share of the peak pressure on a grain's section.
constexpr double force_floor_share = 0.1;

void stop_if_told()
{
  if (caught_signal())
    throw SimulationInterrupted();
}

// The direction of loading turns.
void turn_cells(const coupling::Material &material,
                const RunInput &input,
                double peak_pressure)
{
  if (!material.cells)
    return;
  const double diameter = input.material.packing.sizes.mean_diameter;
  material.cells->turn();
  material.cells->set_force_floor(force_floor_share * peak_pressure * diameter *
                                  diameter);
}

CompactionPoint point_of(const fem::Response &response)
{
  return {response.relative_density,
          -response.stress[2][2],
          -0.5 * (response.stress[0][0] + response.stress[1][1])};
}

CompactionPoint point_of(const fem::StepRecord &record)
{
  const auto ratio = [](double force, double area) {
    return area > 0 ? force / area : 0;
  };
  return {record.mean_relative_density,
          ratio(record.upper_force, record.punch_area),
          ratio(record.wall_normal_force, record.wall_area)};
}
} // namespace

coupling::Material
CurveSimulator::make_material(const coupling::MaterialChoice &choice,
                              std::size_t count) const
{
  const std::lock_guard lock(reading_);
  try {
    return coupling::make_material(choice, count);
  } catch (const coupling::FileError &error) {
    throw OutputError(error.what());
  }
}

SimulatedCurve CurveSimulator::run(const RunInput &input) const
{
  try {
    return model_ == Model::die ? press(input) : probe(input);
  } catch (const OutputError &) {
    throw;
  } catch (const std::exception &error) {
    return {{}, error.what()};
  }
}

double CurveSimulator::start_density(const RunInput &input) const
{
  const std::size_t count =
      model_ == Model::die ? input.mesh.mesh.number_of_points() : 1;
  const coupling::Material material = make_material(input.material, count);
  if (model_ == Model::die)
    return fem::DieModel(input.die, input.mesh.mesh, *material.points)
        .last_step()
        .mean_relative_density;
  const std::vector<fem::Deformation> rest{
      {dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())}};
  std::vector<fem::Response> response(1);
  material.points->evaluate(rest, fem::Want::stress, response);
  if (response[0].status == fem::Status::failed)
    throw std::runtime_error("the material has no state to start from");
  return response[0].relative_density;
}

SimulatedCurve CurveSimulator::probe(const RunInput &input) const
{
  const coupling::Material material = make_material(input.material, 1);
  SimulatedCurve simulated;
  simulated.curve.has_lateral = true;
  std::vector<fem::PathStage> stages;
  for (const ProbeStage &stage : input.path.stages)
    stages.push_back(stage.stage);
  double peak = 0;
  const auto begin = [&](unsigned stage) {
    if (input.path.stages[stage].peak_share > 0)
      stages[stage].until_stress = -input.path.stages[stage].peak_share * peak;
    turn_cells(material, input, stage > 0 ? peak : 0);
  };
  const auto observe = [&](const fem::PathRecord &record) {
    stop_if_told();
    const CompactionPoint point = point_of(record.response);
    peak = std::max(peak, point.axial);
    (record.stage == 0 ? simulated.curve.loading : simulated.curve.unloading)
        .push_back(point);
  };
  if (fem::drive_path(
          *material.points, stages, begin, observe, input.stress_tolerance) !=
      fem::PathEnd::finished)
    simulated.problem =
        material.cells && !material.cells->report().problem.empty()
            ? material.cells->report().problem
            : "a step did not converge";
  return simulated;
}

SimulatedCurve CurveSimulator::press(const RunInput &input) const
{
  const coupling::Material material =
      make_material(input.material, input.mesh.mesh.number_of_points());
  SimulatedCurve simulated;
  simulated.curve.has_lateral = true;
  const auto begin = [&](unsigned stage, double peak_pressure) {
    const fem::StageKind kind = input.die.stages[stage].kind;
    const bool turns =
        kind == fem::StageKind::unload || kind == fem::StageKind::eject;
    turn_cells(material, input, turns ? peak_pressure : 0);
  };
  fem::DieModel model(input.die, input.mesh.mesh, *material.points, begin);
  simulated.curve.loading.push_back(point_of(model.last_step()));
  for (fem::Advance answer;
       (answer = model.advance()) != fem::Advance::finished;) {
    stop_if_told();
    if (answer == fem::Advance::failed) {
      simulated.problem = model.failure().reason;
      break;
    }
    const fem::StepRecord &record = model.last_step();
    switch (input.die.stages[record.stage].kind) {
    case fem::StageKind::press:
      simulated.curve.loading.push_back(point_of(record));
      break;
    case fem::StageKind::unload:
      simulated.curve.unloading.push_back(point_of(record));
      break;
    default: // what follows was not measured
      break;
    }
  }
  return simulated;
}
} // namespace tamp::apps
