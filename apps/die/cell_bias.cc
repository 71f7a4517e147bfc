// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/cell_bias.h>
#include <dem/six.h>

#include <algorithm>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
using Stress = dealii::SymmetricTensor<2, 3>;

/// Seeking balance more exactly than this share of what cells are off by is
/// wasted.
constexpr double useful_tolerance = 0.3;
/// Of fewer samples a mean says little.
constexpr std::uint64_t enough_samples = 4;

Stress stress_of(const PointAnswer &answer)
{
  Stress stress;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = dem::six_places[k];
    stress[i][j] = answer.stress[k];
  }
  return stress;
}

double mean_size(std::span<const PointAnswer> answers)
{
  double sum = 0;
  for (const PointAnswer &answer : answers)
    sum += stress_of(answer).norm();
  return sum / static_cast<double>(answers.size());
}
} // namespace

CellBias::CellBias(RunSession &session, coupling::SharedCells *cells)
    : session_(session), cells_(cells)
{
}

void CellBias::look(unsigned step,
                    std::span<const fem::Deformation> deformations,
                    std::span<const PointAnswer> answers,
                    double force_floor)
{
  const unsigned interval = session_.input().output.bias_interval;
  if (!cells_ || interval == 0 || step % interval != 0)
    return;
  std::vector<coupling::CellIncrement> increments;
  for (const std::size_t point :
       coupling::sampled_points(step / interval - 1, answers.size()))
    increments.push_back(
        {point, deformations[point], stress_of(answers[point])});
  dem::Driving driving = session_.input().material.driving;
  driving.quasi_static.force_floor = force_floor;
  const auto finer =
      coupling::answer_finely(*cells_, increments, driving, session_.threads());
  const double usual = mean_size(answers); // a point may bear next to nothing
  std::string line;
  for (std::size_t k = 0; k < finer.size(); ++k) {
    const Stress &stress = increments[k].stress;
    tally_.evaluations += finer[k].evaluations;
    tally_.unsettled += !finer[k].settled;
    const double size = std::max(stress.norm(), usual);
    if (!finer[k].settled || !(size > 0))
      continue;
    const double bias = (stress - finer[k].stress).norm() / size;
    ++tally_.samples;
    tally_.bias += bias;
    line +=
        fmt::format(", {:.2g} % at point {}", 100 * bias, increments[k].point);
    tally_.worst = std::max(tally_.worst, bias);
  }
  session_.log().detail(
      fmt::format("step {}: stress of cells against cells driven more finely{}",
                  step,
                  line));
}

void CellBias::give(double force_tolerance) const
{
  if (tally_.samples + tally_.unsettled == 0)
    return;
  const double mean =
      tally_.bias / std::max(1., static_cast<double>(tally_.samples));
  session_.result("cell_bias_samples[-]", static_cast<double>(tally_.samples));
  session_.result("mean_cell_bias[-]", mean);
  session_.result("worst_cell_bias[-]", tally_.worst);
  session_.result("cell_bias_unsettled[-]",
                  static_cast<double>(tally_.unsettled));
  session_.result("cell_bias_cost[-]",
                  tally_.evaluations / tally_.run_evaluations);
  if (tally_.samples >= enough_samples &&
      force_tolerance < useful_tolerance * mean)
    session_.warn(fmt::format(
        "Solver/Force tolerance = {:.2g} asks for more than cells know: driven "
        "more finely they change their stress by {:.2g} on average; {:.2g} "
        "costs less and is as good, or lower Cell/Unbalance tolerance or "
        "Solver/Maximum step",
        force_tolerance,
        mean,
        useful_tolerance * mean));
}

void CellBias::pack(std::vector<char> &bytes) const
{
  fem::append_state(bytes, tally_);
}

void CellBias::go_on(fem::StateBytes &stored)
{
  stored.take(tally_);
}
} // namespace tamp::apps
