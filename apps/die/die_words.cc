// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_words.h>
#include <apps/input/schedule.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
double expected_steps(const fem::Stage &stage, const fem::StepLimits &limits)
{
  double guess = 30;
  if (stage.kind == fem::StageKind::press)
    guess = 0.35 / limits.maximum;
  if (stage.kind == fem::StageKind::hold)
    guess = stage.steps;
  return std::max(guess, 1.);
}

// What may be done about a step of a stage.
std::string remedy(fem::StageKind kind, bool cells, bool opened)
{
  if (!cells)
    return "Smaller steps (Solver/Maximum step) may help";
  if (kind == fem::StageKind::press || kind == fem::StageKind::hold)
    return "Smaller steps (Solver/Maximum step), a higher Packing/Pressure or "
           "more grains may help";
  return std::string(opened ? "Nothing holds its grains together any more, and "
                              "any opening would be an equilibrium"
                            : "If grains lose hold of each other, nothing does "
                              "converge") +
         ". Keep the compact under more pressure, as in 'unload to 10 % of "
         "peak; eject to rim holding 10 % of peak', or let its grains adhere "
         "more (Contact/Work of adhesion)";
}

} // namespace

std::vector<std::string> stage_remarks(const fem::DieSettings &settings)
{
  std::vector<std::string> lines{"compression is positive"};
  for (std::size_t i = 0; i < settings.stages.size(); ++i)
    lines.push_back(
        fmt::format("stage {}: {}", i + 1, name_of(settings.stages[i].kind)));
  return lines;
}

double share_done(const fem::DieSettings &settings,
                  const fem::StepRecord &record)
{
  double done = 0, all = 0;
  for (std::size_t i = 0; i < settings.stages.size(); ++i) {
    const double steps = expected_steps(settings.stages[i], settings.steps);
    all += steps;
    if (i < record.stage)
      done += steps;
    if (i == record.stage)
      done += steps * std::clamp(record.stage_progress, 0., 1.);
  }
  return done / all;
}

std::string step_line(const fem::StepRecord &record,
                      fem::StageKind kind,
                      const StepEffort *effort)
{
  const auto mega = [](double force, double area) {
    return area > 0 ? force / area / 1e6 + 0. : 0;
  };
  std::string text = fmt::format(
      "step {:4d}  {:<6} density {:.4f}  upper {:.4g}  lower {:.4g}  wall "
      "{:.4g} MPa  iterations {}  updates {}  residual {:.1e}",
      record.step,
      name_of(kind),
      record.mean_relative_density,
      mega(record.upper_force, record.punch_area),
      mega(record.lower_force, record.punch_area),
      mega(record.wall_normal_force, record.wall_area),
      record.iterations,
      record.material_updates,
      record.force_residual);
  if (effort)
    text += fmt::format("  evaluations {:.0f}  unbalance {:.1e}",
                        effort->evaluations,
                        effort->worst_unbalance);
  if (record.cuts > 0)
    text += fmt::format("  cuts {}", record.cuts);
  if (record.stagnated)
    text += "  out of balance";
  if (record.doubtful_points > 0)
    text += fmt::format("  doubtful points {}", record.doubtful_points);
  return text;
}

std::string failure_words(const fem::Failure &failure,
                          unsigned step,
                          fem::StageKind kind,
                          bool cells)
{
  if (failure.kind == fem::FailureKind::impossible)
    return failure.reason;
  const auto &stress = failure.stress;
  return fmt::format(
      "the step after step {} ({}) did not converge: {}. Worst is point {} "
      "at r = {:.4g} mm, z = {:.4g} mm with stress rr {:.4g}, tt {:.4g}, zz "
      "{:.4g}, rz {:.4g} MPa (compression positive). {}",
      step,
      name_of(kind),
      failure.reason,
      failure.point,
      1e3 * failure.position[0],
      1e3 * failure.position[2],
      (0 - stress[0][0]) / 1e6,
      (0 - stress[1][1]) / 1e6,
      (0 - stress[2][2]) / 1e6,
      (0 - stress[0][2]) / 1e6,
      remedy(kind, cells, failure.kind == fem::FailureKind::opened));
}
} // namespace tamp::apps
