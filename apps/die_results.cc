// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die_results.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
double ratio(double part, double whole)
{
  return std::abs(whole) > 0 ? part / whole : 0;
}

// upper - lower - wall friction, over the largest force of a tool, which counts
// as at least a small share of the peak: nothing presses a compact that is out.
double imbalance(const fem::StepRecord &record, double peak)
{
  constexpr double smallest = 1e-4;
  return ratio(std::abs(record.upper_force - record.lower_force -
                        record.wall_friction_force),
               std::max({std::abs(record.upper_force),
                         std::abs(record.lower_force),
                         std::abs(record.wall_normal_force),
                         smallest * peak}));
}
} // namespace

std::vector<std::string> die_header()
{
  return {"step",
          "stage",
          "upper_displacement[m]",
          "lower_displacement[m]",
          "upper_force[N]",
          "lower_force[N]",
          "wall_friction_force[N]",
          "wall_normal_force[N]",
          "upper_pressure[Pa]",
          "lower_pressure[Pa]",
          "wall_pressure[Pa]",
          "mean_relative_density[-]",
          "minimum_relative_density[-]",
          "maximum_relative_density[-]",
          "iterations[-]",
          "cell_updates[-]",
          "force_evaluations[-]",
          "force_residual[-]",
          "worst_unbalance[-]",
          "worst_hill_mandel[-]",
          "wall_time[s]"};
}

std::vector<double> die_values(const fem::StepRecord &record,
                               const StepEffort &effort)
{
  return {static_cast<double>(record.step),
          static_cast<double>(record.stage + 1),
          record.upper_displacement,
          record.lower_displacement,
          record.upper_force,
          record.lower_force,
          record.wall_friction_force,
          record.wall_normal_force,
          ratio(record.upper_force, record.punch_area),
          ratio(record.lower_force, record.punch_area),
          ratio(record.wall_normal_force, record.wall_area),
          record.mean_relative_density,
          record.minimum_relative_density,
          record.maximum_relative_density,
          static_cast<double>(record.iterations),
          static_cast<double>(record.material_updates),
          effort.evaluations,
          record.force_residual,
          effort.worst_unbalance,
          effort.worst_hill_mandel,
          effort.wall_time};
}

void DieResults::take(const fem::StepRecord &record,
                      fem::StageKind kind,
                      const StepEffort &effort)
{
  if (!started_)
    start_ = peak_ = record;
  started_ = true;
  last_ = record;
  if (record.step == 0)
    return;
  ++steps_;
  updates_ += record.material_updates;
  cuts_ += record.cuts;
  doubtful_points_ += record.doubtful_points;
  doubtful_steps_ += record.doubtful_points > 0;
  evaluations_ += effort.evaluations;
  worst_balance_ =
      std::max(worst_balance_, imbalance(record, peak_.upper_force));
  worst_unbalance_ = std::max(worst_unbalance_, effort.worst_unbalance);
  worst_hill_mandel_ = std::max(worst_hill_mandel_, effort.worst_hill_mandel);
  if (record.upper_force > peak_.upper_force)
    peak_ = record;
  if (kind == fem::StageKind::unload) {
    unloaded_ = true;
    residual_wall_pressure_ = ratio(record.wall_normal_force, record.wall_area);
    unloaded_height_change_ =
        peak_.upper_displacement - record.upper_displacement;
  }
  if (kind == fem::StageKind::eject) {
    ejecting_ = true;
    ejection_force_ = std::max(ejection_force_, record.lower_force);
  }
}

void DieResults::give(RunSession &session) const
{
  const auto pressure = [](double force, const fem::StepRecord &record) {
    return ratio(force, record.punch_area);
  };
  session.result("steps[-]", steps_);
  session.result("cut_attempts[-]", cuts_);
  session.result("start_relative_density[-]", start_.mean_relative_density);
  session.result("start_pressure[Pa]", pressure(start_.upper_force, start_));
  session.result("peak_upper_force[N]", peak_.upper_force);
  session.result("peak_upper_pressure[Pa]", pressure(peak_.upper_force, peak_));
  session.result("peak_lower_pressure[Pa]", pressure(peak_.lower_force, peak_));
  session.result("peak_wall_pressure[Pa]",
                 ratio(peak_.wall_normal_force, peak_.wall_area));
  session.result("transmission_at_peak[-]",
                 ratio(peak_.lower_force, peak_.upper_force));
  session.result("mean_relative_density_at_peak[-]",
                 peak_.mean_relative_density);
  session.result("minimum_relative_density_at_peak[-]",
                 peak_.minimum_relative_density);
  session.result("maximum_relative_density_at_peak[-]",
                 peak_.maximum_relative_density);
  if (unloaded_) {
    session.result("residual_wall_pressure_after_unloading[Pa]",
                   residual_wall_pressure_);
    session.result("axial_spring_back[m]", unloaded_height_change_);
  }
  if (ejecting_)
    session.result("peak_ejection_force[N]", ejection_force_);
  session.result("final_mean_relative_density[-]", last_.mean_relative_density);
  session.result("cell_updates_per_step[-]", ratio(updates_, steps_));
  session.result("worst_force_imbalance[-]", worst_balance_);
  session.result("doubtful_points[-]", static_cast<double>(doubtful_points_));
  if (doubtful_points_ > 0)
    session.warn(fmt::format(
        "{} answers of material points, in {} steps, were doubtful: grains did "
        "not settle within Cell/Maximum evaluations, or a law was asked beyond "
        "its tables",
        doubtful_points_,
        doubtful_steps_));
  if (evaluations_ > 0) {
    session.result("force_evaluations_per_cell[-]", evaluations_);
    session.result("worst_unbalance[-]", worst_unbalance_);
    session.result("worst_hill_mandel[-]", worst_hill_mandel_);
  }
}

} // namespace tamp::apps
