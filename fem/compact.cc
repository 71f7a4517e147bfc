// SPDX-License-Identifier: BSD-3-Clause
#include <fem/compact.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
dealii::Tensor<2, 3> unit_tensor()
{
  dealii::Tensor<2, 3> unit;
  unit[0][0] = unit[1][1] = unit[2][2] = 1;
  return unit;
}

bool is_finite(const Response &response, Want want)
{
  return std::isfinite(response.stress.norm()) &&
         std::isfinite(response.relative_density) &&
         (want == Want::stress || std::isfinite(response.tangent.norm()));
}
} // namespace

Compact::Compact(const Mesh &mesh,
                 MaterialPoints &points,
                 const Ranks &ranks,
                 bool f_bar)
    : mesh_(mesh), points_(points), ranks_(ranks), f_bar_(f_bar),
      element_(mesh.is_axisymmetric()),
      cells_(ranks.share(mesh.number_of_cells())), assembler_(mesh, cells_)
{
  if (!ranks.all(points.size() == point_share().size()))
    throw std::invalid_argument(
        "the mesh has " + std::to_string(mesh.number_of_points()) +
        " material points, " + std::to_string(point_share().size()) +
        " of them on this rank, but " + std::to_string(points.size()) +
        " were given");
  state_.positions = mesh.nodes;
  state_.deformation_gradients.assign(points.size(), unit_tensor());
  update_geometry(state_.positions, committed_, committed_centres_);
  trial_.responses.resize(points.size());
  trial_.deformations.resize(points.size());
  const std::vector<double> nothing(mesh.number_of_dofs(), 0.);
  Fault fault = deform(nothing);
  if (fault.reason.empty())
    fault = evaluate(Want::stress);
  if (!fault.reason.empty())
    throw std::runtime_error("material point " + std::to_string(fault.point) +
                             " has no state to start from: " + fault.reason);
  state_.responses = trial_.responses;
}

Share Compact::point_share() const
{
  return {cells_.begin * mesh_.points_per_cell(),
          cells_.end * mesh_.points_per_cell()};
}

void Compact::update_geometry(const NodePositions &positions,
                              std::vector<PointGeometry> &points,
                              std::vector<PointGeometry> &centres) const
{
  const unsigned n = mesh_.points_per_cell();
  points.resize(point_share().size());
  if (f_bar_)
    centres.resize(cells_.size());
  for (std::size_t cell = cells_.begin; cell < cells_.end; ++cell) {
    const unsigned *nodes = mesh_.nodes_of_cell(cell);
    const std::size_t local = cell - cells_.begin;
    for (unsigned q = 0; q < n; ++q)
      points[local * n + q] =
          point_geometry(mesh_, element_.points[q], nodes, positions);
    if (f_bar_)
      centres[local] = point_geometry(mesh_, element_.centre, nodes, positions);
  }
}

dealii::Tensor<2, 3>
Compact::relative_F(std::size_t local_point,
                    std::span<const double> increment) const
{
  const std::size_t local_cell = local_point / mesh_.points_per_cell();
  const unsigned *nodes = mesh_.nodes_of_cell(cells_.begin + local_cell);
  const auto F =
      unit_tensor() +
      displacement_gradient(mesh_, committed_[local_point], nodes, increment);
  if (!f_bar_)
    return F;
  const auto centre =
      unit_tensor() +
      displacement_gradient(
          mesh_, committed_centres_[local_cell], nodes, increment);
  return std::cbrt(dealii::determinant(centre) / dealii::determinant(F)) * F;
}

Fault Compact::agree(Kind kind, std::size_t point) const
{
  // One number says both, so that all ranks agree on the same point.
  const auto count = static_cast<double>(mesh_.number_of_points());
  const double code =
      ranks_.largest(kind == none ? 0.
                                  : static_cast<unsigned>(kind) * count +
                                        static_cast<double>(point));
  const char *reasons[] = {"",
                           "an element turns inside out",
                           "a material point failed",
                           "a material point's answer is not finite"};
  const auto found = static_cast<unsigned>(code / count);
  return {reasons[found], static_cast<std::size_t>(code - found * count)};
}

Fault Compact::deform(std::span<const double> increment)
{
  trial_.positions = moved(mesh_, state_.positions, increment);
  update_geometry(trial_.positions, trial_.geometry, trial_.centres);
  Kind kind = none;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < trial_.geometry.size(); ++i) {
    if (!(trial_.geometry[i].volume > 0) && kind == none) {
      kind = inverted;
      worst = point_share().begin + i;
    }
    trial_.deformations[i].relative_F = relative_F(i, increment);
  }
  return agree(kind, worst);
}

Fault Compact::evaluate(Want want)
{
  points_.evaluate(trial_.deformations, want, trial_.responses);
  Kind kind = none;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < trial_.responses.size() && kind == none; ++i) {
    worst = point_share().begin + i;
    if (trial_.responses[i].status == Status::failed)
      kind = failed;
    else if (!is_finite(trial_.responses[i], want))
      kind = not_finite;
  }
  return agree(kind, worst);
}

std::vector<double> Compact::whole(std::span<const double> of_this_rank) const
{
  std::vector<double> result(mesh_.number_of_points(), 0.);
  std::copy(of_this_rank.begin(),
            of_this_rank.end(),
            result.begin() + static_cast<std::ptrdiff_t>(point_share().begin));
  ranks_.sum(result); // of one number and zeros: exact
  return result;
}

std::size_t Compact::doubtful_points() const
{
  double count = static_cast<double>(std::count_if(
      trial_.responses.begin(), trial_.responses.end(), [](const auto &r) {
        return r.status == Status::doubtful;
      }));
  ranks_.sum({&count, 1});
  return static_cast<std::size_t>(count);
}

double Compact::largest_strain(std::span<const double> increment) const
{
  double largest = 0;
  for (std::size_t i = 0; i < committed_.size(); ++i) {
    const auto H = relative_F(i, increment) - unit_tensor();
    for (unsigned j = 0; j < 3; ++j)
      for (unsigned k = 0; k < 3; ++k)
        largest = std::max(largest, std::abs(H[j][k]));
  }
  return ranks_.largest(largest);
}

double Compact::volume_ratio(std::size_t local_point) const
{
  return dealii::determinant(trial_.deformations[local_point].relative_F);
}

CellPoints Compact::cell_points(std::size_t local_cell) const
{
  const unsigned n = mesh_.points_per_cell();
  return {{&trial_.geometry[local_cell * n], n},
          {&trial_.responses[local_cell * n], n},
          f_bar_ ? &trial_.centres[local_cell] : nullptr};
}

std::vector<double> Compact::internal_forces() const
{
  std::vector<double> force(mesh_.number_of_dofs(), 0.);
  for (std::size_t local = 0; local < cells_.size(); ++local)
    assembler_.add_forces(cells_.begin + local, cell_points(local), force);
  ranks_.sum(force);
  return force;
}

void Compact::assemble_stiffness(SparseRows &stiffness) const
{
  std::fill(stiffness.value.begin(), stiffness.value.end(), 0.);
  for (std::size_t local = 0; local < cells_.size(); ++local)
    assembler_.add_stiffness(
        cells_.begin + local, cell_points(local), stiffness);
}

double Compact::trial_work() const
{
  // Midpoint rule: its strain is blind to rotations.
  double work = 0;
  for (std::size_t i = 0; i < trial_.deformations.size(); ++i) {
    const auto &F = trial_.deformations[i].relative_F;
    const auto strain = dealii::symmetrize(2. * (F - unit_tensor()) *
                                           dealii::invert(F + unit_tensor()));
    work +=
        0.25 * (committed_[i].volume + trial_.geometry[i].volume) *
        ((state_.responses[i].stress + trial_.responses[i].stress) * strain);
  }
  ranks_.sum({&work, 1});
  return work;
}

void Compact::accept()
{
  points_.commit();
  state_.positions = trial_.positions;
  state_.responses = trial_.responses;
  for (std::size_t i = 0; i < trial_.deformations.size(); ++i)
    state_.deformation_gradients[i] =
        trial_.deformations[i].relative_F * state_.deformation_gradients[i];
  committed_ = trial_.geometry;
  committed_centres_ = trial_.centres;
}
} // namespace tamp::fem
