// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die_output.h>
#include <apps/units.h>
#include <coupling/grain_output.h>
#include <dem/measures.h>

#include <fmt/format.h>
#include <numeric>

namespace tamp::apps
{
namespace
{
std::vector<fem::PointField> cell_fields(const coupling::UnitCellPoints &cells)
{
  std::vector<fem::PointField> fields{{"coordination_number", {}},
                                      {"mechanical_coordination_number", {}},
                                      {"plastic_contact_share", {}},
                                      {"sliding_contact_share", {}}};
  for (std::size_t point = 0; point < cells.size(); ++point) {
    const dem::CellMeasures measures = dem::measure(cells.cell(point));
    const double contacts =
        static_cast<double>(std::max<std::size_t>(1, measures.contacts));
    fields[0].values.push_back(measures.coordination_number);
    fields[1].values.push_back(measures.mechanical_coordination_number);
    fields[2].values.push_back(static_cast<double>(measures.plastic_contacts) /
                               contacts);
    fields[3].values.push_back(static_cast<double>(measures.sliding_contacts) /
                               contacts);
  }
  return fields;
}
} // namespace

DieOutput::DieOutput(const RunSession &session,
                     const fem::DieModel &model,
                     const coupling::UnitCellPoints *cells)
    : session_(session), model_(model), cells_(cells),
      fields_(session.folder(), "fields.pvd"),
      grains_(session.folder(), "grains.pvd")
{
  const OutputSettings &output = session.input().output;
  if (!cells || output.grain_output == GrainOutput::none)
    return;
  if (output.grain_output == GrainOutput::chosen_points) {
    for (const std::size_t point : output.grain_points)
      if (point >= cells->size())
        throw InputError(fmt::format("Output/Grain points: there is no point "
                                     "{}; expected numbers from 0 to {}",
                                     point,
                                     cells->size() - 1));
    grain_points_ = output.grain_points;
  } else {
    grain_points_.resize(cells->size());
    std::iota(grain_points_.begin(), grain_points_.end(), std::size_t(0));
  }
}

void DieOutput::write(unsigned step, bool must)
{
  const OutputSettings &output = session_.input().output;
  if ((must || step % output.field_interval == 0) && last_fields_ != step)
    write_fields(step);
  if ((must || step % output.grain_interval == 0) && last_grains_ != step)
    write_grains(step);
}

void DieOutput::write_fields(unsigned step)
{
  const std::string name = fmt::format("step_{:04d}", step);
  model_.write_fields(session_.folder().subfolder("fields"),
                      name,
                      cells_ ? cell_fields(*cells_)
                             : std::vector<fem::PointField>());
  fields_.add(step, 0, "fields/" + name + ".vtu");
  last_fields_ = step;
}

void DieOutput::write_grains(unsigned step)
{
  last_grains_ = step;
  if (grain_points_.empty())
    return;
  session_.folder().subfolder("grains");
  for (const std::size_t point : grain_points_) {
    const std::string file =
        fmt::format("grains/point_{:04d}_step_{:04d}.vtp", point, step);
    coupling::write_grains(cells_->cell(point),
                           cells_->rotation(point),
                           session_.folder().path() / file);
    grains_.add(step, point, file);
  }
}
} // namespace tamp::apps
