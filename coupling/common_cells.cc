// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/common_cells.h>
#include <dem/unit_cell_bytes.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <exception>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace tamp::coupling
{
namespace
{
using Bits = std::array<std::uint64_t, 9>;

Bits bits_of(const dem::Stretch &stretch)
{
  Bits bits;
  std::transform(
      stretch.data(),
      stretch.data() + stretch.size(),
      bits.begin(),
      [](double value) { return std::bit_cast<std::uint64_t>(value); });
  return bits;
}

bool equal_bytes(const dem::UnitCell &a, const dem::UnitCell &b)
{
  if (!(a == b))
    return false;
  std::vector<char> one, other;
  dem::to_bytes(a, one);
  dem::to_bytes(b, other);
  return one == other;
}

/// Puts what may be equal next to each other.
bool before(const dem::UnitCell &a, const dem::UnitCell &b)
{
  const auto key = [](const dem::UnitCell &cell) {
    std::array<double, 12> numbers{};
    std::copy_n(cell.box.h.data(), 9, numbers.begin());
    if (cell.size() > 0)
      std::copy_n(cell.place[0].data(), 3, numbers.begin() + 9);
    return numbers;
  };
  return key(a) < key(b);
}
} // namespace

void CommonCell::press(const dem::Stretch &stretch,
                       const dem::Driving &driving,
                       bool warm,
                       bool with_tangent)
{
  problem.clear();
  answer = {};
  voigt.reset();
  try {
    if (!stretch.allFinite())
      throw std::domain_error("deformation gradient turned inside out");
    trial = committed;
    answer = dem::deform(trial, stretch, driving, warm ? &guess : nullptr);
    cost = static_cast<double>(answer.evaluations) *
           static_cast<double>(trial.size());
    has_trial = true;
    if (answer.outcome == dem::Outcome::diverged)
      problem = "the grains of the cell flew apart or were crushed";
    else if (with_tangent)
      voigt = dem::voigt_tangent(trial);
  } catch (const std::exception &error) { // no such state of the cell
    problem = error.what();
    guess.clear();
    has_trial = false;
  }
}

void CommonCell::commit()
{
  if (has_trial)
    std::swap(committed, trial);
  guess.clear();
  voigt.reset();
  has_trial = false;
}

CommonCells::CommonCells(std::vector<dem::UnitCell> cells,
                         std::vector<std::size_t> cell_of)
    : cells_(cells.size()), cell_of_(std::move(cell_of))
{
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells_[i].committed = std::move(cells[i]);
  number_anew();
}

void CommonCells::part(std::span<const dem::Stretch> stretches)
{
  std::vector<bool> kept(cells_.size(), false);
  std::map<std::pair<std::size_t, Bits>, std::size_t> asked;
  for (std::size_t i = 0; i < points(); ++i) {
    const std::size_t cell = cell_of_[i];
    const auto [place, is_new] =
        asked.try_emplace({cell, bits_of(stretches[i])}, cell);
    if (!kept[cell])
      cells_[cell].first_point = i;
    if (is_new && kept[cell]) {
      place->second = cells_.size();
      CommonCell copy;
      copy.committed = cells_[cell].committed;
      copy.guess = cells_[cell].guess;
      copy.cost = cells_[cell].cost;
      copy.first_point = i;
      copy.parent = cells_[cell].parent.value_or(cell);
      cells_.push_back(std::move(copy));
    }
    kept[cell] = true;
    cell_of_[i] = place->second;
  }
}

void CommonCells::rejoin()
{
  bool parted = false;
  for (std::size_t &cell : cell_of_)
    if (cells_[cell].parent) {
      cell = *cells_[cell].parent;
      cells_[cell].has_trial = false;
      parted = true;
    }
  for (CommonCell &cell : cells_)
    cell.guess.clear();
  if (parted)
    number_anew();
}

void CommonCells::commit()
{
  for (CommonCell &cell : cells_) {
    cell.commit();
    cell.parent.reset();
  }
}

void CommonCells::put(std::size_t point, dem::UnitCell cell)
{
  CommonCell fresh;
  fresh.committed = std::move(cell);
  fresh.first_point = point;
  cell_of_.at(point) = cells_.size();
  cells_.push_back(std::move(fresh));
}

void CommonCells::join_equal()
{
  rejoin();
  number_anew();
  std::vector<std::size_t> order(cells_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return before(cells_[a].committed, cells_[b].committed);
  });
  std::vector<std::size_t> same(cells_.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t here = order[k], last = order[k > 0 ? k - 1 : 0];
    const bool joins =
        k > 0 && equal_bytes(cells_[here].committed, cells_[last].committed);
    same[here] = joins ? same[last] : here;
  }
  for (std::size_t &cell : cell_of_)
    cell = same[cell];
  number_anew();
}

void CommonCells::hold(std::ptrdiff_t from, std::size_t count)
{
  rejoin();
  std::vector<std::size_t> cell_of(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::ptrdiff_t old = from + static_cast<std::ptrdiff_t>(i);
    const bool is_known =
        old >= 0 && old < static_cast<std::ptrdiff_t>(points());
    cell_of[i] =
        is_known ? cell_of_[static_cast<std::size_t>(old)] : cells_.size();
    if (!is_known)
      cells_.emplace_back();
  }
  cell_of_ = std::move(cell_of);
  number_anew();
}

/// Cells in the order of their first points; those of no point are dropped.
void CommonCells::number_anew()
{
  std::vector<CommonCell> cells;
  std::vector<std::optional<std::size_t>> number(cells_.size());
  for (std::size_t i = 0; i < points(); ++i) {
    std::optional<std::size_t> &now = number[cell_of_[i]];
    if (!now) {
      now = cells.size();
      cells.push_back(std::move(cells_[cell_of_[i]]));
      cells.back().first_point = i;
    }
    cell_of_[i] = *now;
  }
  cells_ = std::move(cells);
}
} // namespace tamp::coupling
