// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/bias_sampling.h>
#include <coupling/polar.h>
#include <coupling/work_sharing.h>
#include <dem/stretch.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tamp::coupling
{
namespace
{
constexpr double finer_balance = 10, finer_parts = 3;
constexpr std::size_t stress_size = 6, answer_size = stress_size + 2;

double largest_strain(const fem::Deformation &deformation)
{
  const PolarSplit split = polar_split(to_matrix(deformation.relative_F));
  return dem::largest_principal(dem::logarithm(split.stretch));
}

/// The answer of a copy of the cell.
FinerAnswer answer_of_copy(const fem::MaterialPoints &cells,
                           std::size_t local,
                           const CellIncrement &increment,
                           const dem::Driving &driving)
{
  CellPointsOptions options;
  options.driving =
      finer_driving(driving, largest_strain(increment.deformation));
  options.warm = false;
  std::vector<char> bytes;
  cells.pack(local, bytes);
  UnitCellPoints copy({}, options);
  copy.hold({0, 1});
  copy.unpack(0, bytes);
  fem::Response response;
  copy.evaluate(std::span(&increment.deformation, 1),
                fem::Want::stress,
                std::span(&response, 1));
  return {response.status == fem::Status::converged,
          response.stress,
          static_cast<double>(copy.report().evaluations)};
}

void write(const FinerAnswer &answer, double *to)
{
  *to++ = answer.settled ? 1 : 0;
  *to++ = answer.evaluations;
  for (unsigned i = 0; i < stress_size; ++i)
    *to++ = answer.stress.access_raw_entry(i);
}

FinerAnswer read(const double *from)
{
  FinerAnswer answer;
  answer.settled = *from++ > 0;
  answer.evaluations = *from++;
  for (unsigned i = 0; i < stress_size; ++i)
    answer.stress.access_raw_entry(i) = *from++;
  return answer;
}
} // namespace

dem::Driving finer_driving(const dem::Driving &driving, double strain)
{
  dem::Driving finer = driving;
  dem::QuasiStatic &map = finer.quasi_static;
  const double parts =
      std::max(1., std::ceil(strain / map.maximum_strain_increment));
  // Where next to nothing is strained one part is fine enough.
  map.maximum_strain_increment = std::max(1e-9, strain / (finer_parts * parts));
  map.unbalance_tolerance /= finer_balance;
  map.maximum_evaluations *= static_cast<std::size_t>(finer_balance);
  finer.dynamics.strain_rate /= finer_parts;
  return finer;
}

std::vector<std::size_t> sampled_points(std::size_t number, std::size_t points)
{
  const std::size_t count = std::clamp<std::size_t>(points / 4, 1, 4);
  // A stride near the golden section without a common divisor: the points of a
  // sampling are far from each other, and all are met in turn.
  auto stride = static_cast<std::size_t>(0.618 * static_cast<double>(points));
  stride = std::max<std::size_t>(stride, 1);
  while (std::gcd(stride, points) > 1)
    ++stride;
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back((number * count + k) % points * stride % points);
  return result;
}

std::vector<FinerAnswer>
answer_finely(SharedCells &cells,
              std::span<const CellIncrement> increments,
              const dem::Driving &driving,
              unsigned threads)
{
  const fem::Share own = cells.share();
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < increments.size(); ++i)
    if (own.holds(increments[i].point))
      here.push_back(i);
  std::vector<double> table(answer_size * increments.size(), 0.);
  share_work(here, threads, [&](std::size_t i) {
    const std::size_t local = increments[i].point - own.begin;
    write(answer_of_copy(cells.own(), local, increments[i], driving),
          &table[answer_size * i]);
  });
  cells.ranks().sum(table); // of one number and zeros: exact
  std::vector<FinerAnswer> answers;
  for (std::size_t i = 0; i < increments.size(); ++i)
    answers.push_back(read(&table[answer_size * i]));
  return answers;
}
} // namespace tamp::coupling
