// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_results.h>

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

double force_of(fem::Pressing pressing, const fem::StepRecord &record)
{
  return pressing == fem::Pressing::lower ? record.lower_force
                                          : record.upper_force;
}

// upper - lower - wall friction, over the largest force of a tool, which counts
// as at least a small one: nothing presses a compact that is out.
double imbalance(const fem::StepRecord &record, double smallest)
{
  return ratio(std::abs(record.upper_force - record.lower_force -
                        record.wall_friction_force),
               std::max({std::abs(record.upper_force),
                         std::abs(record.lower_force),
                         std::abs(record.wall_normal_force),
                         smallest}));
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
          "die_displacement[m]",
          "compact_height[m]",
          "compact_radius[m]",
          "tool_work[J]",
          "powder_work[J]",
          "tool_friction_work[J]",
          "energy_residual[-]",
          "displacement_change[-]",
          "worst_stress_asymmetry[-]",
          "wall_time[s]"};
}

std::vector<double> die_values(const fem::StepRecord &record,
                               const StepEffort &effort)
{
  std::vector<double> values{static_cast<double>(record.step),
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
                             record.die_displacement,
                             record.compact_height,
                             record.compact_radius,
                             record.work.tools,
                             record.work.powder,
                             record.work.lost,
                             record.work.residual(),
                             record.displacement_change,
                             effort.worst_asymmetry,
                             effort.wall_time};
  for (double &value : values)
    value += 0.; // nobody wants to read -0
  return values;
}

void DieResults::take(const fem::StepRecord &record,
                      const fem::Stage &stage,
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
  stagnated_ += record.stagnated;
  doubtful_points_ += record.doubtful_points;
  doubtful_steps_ += record.doubtful_points > 0;
  evaluations_ += effort.evaluations;
  take_peak(record, stage);
  worst_balance_ = std::max(
      worst_balance_,
      imbalance(record,
                force_floor_ * std::max(peak_.upper_force, peak_.lower_force)));
  worst_energy_ = std::max(worst_energy_, record.work.residual());
  worst_unbalance_ = std::max(worst_unbalance_, effort.worst_unbalance);
  worst_hill_mandel_ = std::max(worst_hill_mandel_, effort.worst_hill_mandel);
  worst_asymmetry_ = std::max(worst_asymmetry_, effort.worst_asymmetry);
  if (stage.kind == fem::StageKind::unload) {
    unloaded_ = true;
    residual_wall_pressure_ = ratio(record.wall_normal_force, record.wall_area);
    unloaded_height_change_ = record.compact_height - peak_.compact_height;
  }
  if (stage.kind == fem::StageKind::eject) {
    ejecting_ = true;
    if (record.stage_progress > 0) // else the upper punch still leaves
      ejection_force_ = std::max(ejection_force_, record.lower_force);
    out_ = stage.target == fem::StageTarget::out && record.stage_progress >= 1;
  }
}

void DieResults::take_peak(const fem::StepRecord &record,
                           const fem::Stage &stage)
{
  if (stage.kind == fem::StageKind::press)
    pressing_ = stage.pressing;
  else if (stage.kind != fem::StageKind::hold)
    return;
  if (force_of(pressing_, record) <= force_of(peak_by_, peak_))
    return;
  peak_ = record;
  peak_by_ = pressing_;
}

void DieResults::give(RunSession &session) const
{
  give_pressing(session);
  give_end(session);
  give_effort(session);
}

void DieResults::give_pressing(RunSession &session) const
{
  const auto pressure = [](double force, const fem::StepRecord &record) {
    return ratio(force, record.punch_area);
  };
  session.heading("Pressing");
  session.result("start_relative_density[-]", start_.mean_relative_density);
  session.result("start_pressure[Pa]", pressure(start_.upper_force, start_));
  session.result("peak_upper_force[N]", peak_.upper_force);
  session.result("peak_lower_force[N]", peak_.lower_force);
  session.result("peak_upper_pressure[Pa]", pressure(peak_.upper_force, peak_));
  session.result("peak_lower_pressure[Pa]", pressure(peak_.lower_force, peak_));
  session.result("peak_wall_pressure[Pa]",
                 ratio(peak_.wall_normal_force, peak_.wall_area));
  session.result("transmission_at_peak[-]",
                 peak_by_ == fem::Pressing::lower
                     ? ratio(peak_.upper_force, peak_.lower_force)
                     : ratio(peak_.lower_force, peak_.upper_force));
  session.result("height_at_peak[m]", peak_.compact_height);
  session.result("mean_relative_density_at_peak[-]",
                 peak_.mean_relative_density);
  session.result("minimum_relative_density_at_peak[-]",
                 peak_.minimum_relative_density);
  session.result("maximum_relative_density_at_peak[-]",
                 peak_.maximum_relative_density);
}

void DieResults::give_end(RunSession &session) const
{
  if (unloaded_) {
    session.heading("Unloading");
    session.result("residual_wall_pressure_after_unloading[Pa]",
                   residual_wall_pressure_);
    session.result("axial_spring_back[m]", unloaded_height_change_);
  }
  if (ejecting_) {
    session.heading("Ejection");
    session.result("peak_ejection_force[N]", ejection_force_);
  }
  if (out_) {
    session.result("axial_spring_back_ejected[-]",
                   ratio(last_.compact_height, peak_.compact_height) - 1);
    session.result("axial_spring_back_ejected[m]",
                   last_.compact_height - peak_.compact_height);
    session.result("radial_spring_back[-]",
                   ratio(last_.compact_radius, peak_.compact_radius) - 1);
    session.result("remaining_tool_force[N]",
                   std::max({std::abs(last_.upper_force),
                             std::abs(last_.lower_force),
                             std::abs(last_.wall_normal_force)}));
  }
  session.heading("Compact at the end");
  session.result("final_mean_relative_density[-]", last_.mean_relative_density);
  session.result("final_height[m]", last_.compact_height);
  session.result("final_radius[m]", last_.compact_radius);
}

void DieResults::give_effort(RunSession &session) const
{
  session.heading("Work since the start");
  session.result("tool_work[J]", last_.work.tools);
  session.result("powder_work[J]", last_.work.powder);
  session.result("tool_friction_work[J]", last_.work.lost);
  session.heading("Effort and accuracy");
  session.result("steps[-]", steps_);
  session.result("cut_attempts[-]", cuts_);
  session.result("cell_updates_per_step[-]", ratio(updates_, steps_));
  session.result("worst_force_imbalance[-]", worst_balance_);
  session.result("steps_out_of_balance[-]", stagnated_);
  if (stagnated_ > 0)
    session.warn(fmt::format(
        "{} of {} steps were accepted out of balance by more than "
        "Solver/Force tolerance, but not more than ten times as much: grains "
        "gave way, and no update got nearer; column force_residual says how "
        "much",
        stagnated_,
        steps_));
  session.result("energy_residual[-]", last_.work.residual());
  session.result("worst_energy_residual[-]", worst_energy_);
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
    session.result("worst_stress_asymmetry[-]", worst_asymmetry_);
  }
}
} // namespace tamp::apps
