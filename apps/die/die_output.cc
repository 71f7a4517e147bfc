// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_output.h>
#include <apps/output/cell_columns.h>
#include <apps/output/probe_columns.h>
#include <coupling/grain_output.h>

#include <fmt/format.h>
#include <numeric>

namespace tamp::apps
{
namespace
{
std::vector<std::string> point_header()
{
  std::vector<std::string> names{"step", "stage"};
  append_nine_names("relative_F_", names);
  for (const std::string &six : six_names)
    names.push_back("stress_" + six + "[Pa]");
  names.emplace_back("relative_density[-]");
  return names;
}
} // namespace

DieOutput::DieOutput(const RunSession &session,
                     const fem::DieModel &model,
                     const RecordedPoints &points,
                     const coupling::SharedCells *cells)
    : session_(session), model_(model), points_(points), cells_(cells),
      fields_(session.folder(), "fields.pvd"),
      grains_(session.folder(), "grains.pvd")
{
  choose_points();
}

std::filesystem::path DieOutput::lines_of(std::size_t point) const
{
  return session_.folder().subfolder("grains") /
         fmt::format("point_{:04d}.csv", point);
}

void DieOutput::begin()
{
  if (!session_.place().first())
    return;
  for (const std::size_t point : grain_points_)
    point_lines_.push_back(std::make_unique<CurveWriter>(
        lines_of(point),
        point_header(),
        std::vector<std::string>{
            "compression is positive; axes x = r, y = hoop, z = axis",
            "replay, to the bit: tamp inspect; in a probe of its own, with "
            "cold cells: the same grains, Packing/Sample = this point's "
            "number and Path/Stages = csv THIS FILE"}));
}

void DieOutput::pack(std::vector<char> &bytes) const
{
  std::vector<std::uint64_t> sizes;
  for (const auto &lines : point_lines_) {
    lines->sync();
    sizes.push_back(lines->size());
  }
  fem::append_state(bytes, sizes);
  fem::append_state(bytes, fields_.entries());
  fem::append_state(bytes, grains_.entries());
  fem::append_state(bytes, last_fields_);
  fem::append_state(bytes, last_grains_);
}

void DieOutput::go_on(fem::StateBytes &stored)
{
  std::vector<std::uint64_t> sizes;
  std::string fields, grains;
  stored.take(sizes);
  stored.take(fields);
  stored.take(grains);
  stored.take(last_fields_);
  stored.take(last_grains_);
  if (!session_.place().first())
    return;
  for (std::size_t k = 0; k < grain_points_.size(); ++k)
    point_lines_.push_back(std::make_unique<CurveWriter>(
        lines_of(grain_points_[k]), point_header().size(), sizes.at(k)));
  fields_.go_on(fields);
  grains_.go_on(grains);
  fields_.remove_others("fields");
  grains_.remove_others("grains");
}

void DieOutput::choose_points()
{
  const OutputSettings &output = session_.input().output;
  if (!cells_ || output.grain_output == GrainOutput::none)
    return;
  if (output.grain_output == GrainOutput::chosen_points) {
    grain_points_ = output.grain_points;
  } else {
    grain_points_.resize(cells_->size());
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

void DieOutput::write_point_lines()
{
  if (points_.last_deformations().empty())
    return;
  const fem::StepRecord &record = model_.last_step();
  for (std::size_t k = 0; k < point_lines_.size(); ++k) {
    const std::size_t point = grain_points_[k];
    const auto &F = points_.last_deformations()[point].relative_F;
    const fem::Response &response = model_.responses()[point];
    std::vector<double> values{static_cast<double>(record.step),
                               static_cast<double>(record.stage + 1)};
    append_nine(F, values);
    append_six(-response.stress, values);
    values.push_back(response.relative_density);
    point_lines_[k]->write(values);
  }
}

void DieOutput::write_fields(unsigned step)
{
  const std::string name = fmt::format("step_{:04d}", step);
  const auto fields = fem::variable_fields(points_);
  // With cells each rank has a model of its own, all alike.
  if (!cells_ || session_.place().first())
    model_.write_fields(session_.folder().subfolder("fields"), name, fields);
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
    const coupling::TurnedCell turned = cells_->cell(point);
    if (session_.place().first())
      coupling::write_grains(
          turned.cell, turned.rotation, session_.folder().path() / file);
    grains_.add(step, point, file);
  }
}
} // namespace tamp::apps
