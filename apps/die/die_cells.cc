// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_cells.h>
#include <apps/run/mpi_run.h>
#include <apps/run/run_material.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace tamp::apps
{
namespace
{
constexpr double force_floor_share = 0.1;

// This rank's points: cells are shared out by number, all others go with the
// elements.
fem::Share own_points(const RunSession &session, const fem::Ranks &ranks)
{
  const fem::Mesh &mesh = session.input().mesh.mesh;
  if (session.input().material.kind == coupling::MaterialKind::unit_cell)
    return ranks.share(mesh.number_of_points());
  const fem::Share elements = ranks.share(mesh.number_of_cells());
  return {elements.begin * mesh.points_per_cell(),
          elements.end * mesh.points_per_cell()};
}
} // namespace

DieMaterial make_die_material(RunSession &session, const fem::Ranks &ranks)
{
  const std::size_t all = session.input().mesh.mesh.number_of_points();
  coupling::Material material;
  together(ranks, [&] {
    material = prepare_material(session, own_points(session, ranks), all);
  });
  warn_of_history(session,
                  static_cast<coupling::History>(
                      ranks.largest(static_cast<double>(material.history))));
  if (!material.cells)
    return {std::move(material.points), nullptr, ranks};
  // The factory made them; they are cells.
  std::unique_ptr<coupling::UnitCellPoints> own(
      static_cast<coupling::UnitCellPoints *>(material.points.release()));
  auto cells =
      std::make_unique<coupling::SharedCells>(std::move(own), all, ranks);
  coupling::SharedCells *same = cells.get();
  return {std::move(cells), same, fem::Ranks()};
}

DieCells::DieCells(RunSession &session,
                   const fem::DieModel &model,
                   RecordedPoints &points,
                   coupling::SharedCells *cells)
    : session_(session), model_(model), points_(points), cells_(cells),
      remarks_(session, "point", session.input().mesh.mesh.number_of_points()),
      bias_(session, cells)
{
  if (cells_)
    points_.when_committing(
        [this](const auto &deformations, const auto &answers) {
          bias_.look(
              model_.last_step().step + 1, deformations, answers, force_floor_);
        });
}

void DieCells::begin_stage(fem::StageKind kind, double peak_pressure)
{
  if (!cells_)
    return;
  const double diameter = session_.input().material.packing.sizes.mean_diameter;
  const bool turning =
      kind == fem::StageKind::unload || kind == fem::StageKind::eject;
  force_floor_ =
      turning ? force_floor_share * peak_pressure * diameter * diameter : 0;
  points_.turn(force_floor_);
}

void DieCells::measure(StepEffort &effort)
{
  if (!cells_)
    return;
  const coupling::CellReport report = cells_->report();
  effort.evaluations = report.mean_evaluations();
  bias_.add_cost(static_cast<double>(report.evaluations));
  effort.worst_unbalance = report.worst_unbalance;
  effort.worst_hill_mandel = report.worst_hill_mandel;
  effort.worst_asymmetry = report.worst_asymmetry;
}

void DieCells::judge(const std::string &step)
{
  if (!cells_)
    return;
  std::vector<double> pressures;
  for (const fem::Response &response : model_.responses())
    pressures.push_back(-trace(response.stress) / 3);
  for (const coupling::PointRemarks &found :
       cells_->judge(session_.input().material.driving, pressures))
    remarks_.take(
        found.point, found.remarks, [&] { return place(found.point, step); });
}

std::string DieCells::place(std::size_t point, const std::string &step) const
{
  const auto position = model_.point_positions()[point];
  return fmt::format(
      "point {} at r = {:.4g} mm, z = {:.4g} mm, step {}, volumetric strain "
      "{:.4g}",
      point,
      1e3 * position[0],
      1e3 * position[2],
      step,
      // Nobody wants to read -0.
      0 - std::log(determinant(model_.deformation_gradients()[point])));
}

std::string DieCells::problem() const
{
  return cells_ ? cells_->report().problem : "";
}

void DieCells::end()
{
  if (cells_)
    different_ = cells_->different_cells();
}

void DieCells::give() const
{
  if (different_ > 0)
    session_.result("different_cells[-]", static_cast<double>(different_));
  remarks_.give();
  bias_.give(session_.input().die.solver.force_tolerance);
  if (!cells_ || session_.place().ranks == 1)
    return;
  const fem::RankLoads loads = cells_->loads();
  for (std::size_t rank = 0; rank < loads.idle.size(); ++rank)
    session_.result(fmt::format("idle_share_of_rank_{}[-]", rank),
                    loads.idle[rank]);
  session_.result("cells_moved_between_ranks[-]",
                  static_cast<double>(loads.moved));
}

void DieCells::pack(std::vector<char> &bytes) const
{
  fem::append_state(bytes, force_floor_);
  remarks_.pack(bytes);
  bias_.pack(bytes);
}

void DieCells::go_on(fem::StateBytes &stored)
{
  stored.take(force_floor_);
  if (cells_)
    cells_->set_force_floor(force_floor_);
  remarks_.go_on(stored);
  bias_.go_on(stored);
}
} // namespace tamp::apps
