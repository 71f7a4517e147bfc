// SPDX-License-Identifier: BSD-3-Clause
#include <fem/shared_points.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace tamp::fem
{
namespace
{
/// Ranges change where the step was worse than this, and where they then are
/// better than half as bad: costs differ from step to step.
constexpr double idle_bound = 0.05, worthwhile = 0.5;

constexpr std::size_t stress_size = 6, tangent_size = 36;
/// Numbers of a point that ranks tell each other.
std::size_t width(Want want)
{
  return 3 + stress_size + (want == Want::stress ? 0 : tangent_size);
}

void write(const Response &response, double cost, Want want, double *to)
{
  *to++ = response.relative_density;
  *to++ = static_cast<double>(response.status);
  *to++ = cost;
  for (unsigned i = 0; i < stress_size; ++i)
    *to++ = response.stress.access_raw_entry(i);
  if (want == Want::stress)
    return;
  for (unsigned i = 0; i < tangent_size; ++i)
    *to++ = response.tangent.access_raw_entry(i);
}

void read(const double *from, Want want, Response &response, double &cost)
{
  response.relative_density = *from++;
  response.status = static_cast<Status>(static_cast<int>(*from++));
  cost = *from++;
  for (unsigned i = 0; i < stress_size; ++i)
    response.stress.access_raw_entry(i) = *from++;
  if (want == Want::stress)
    return;
  for (unsigned i = 0; i < tangent_size; ++i)
    response.tangent.access_raw_entry(i) = *from++;
}

std::vector<double> numbers(std::span<const Deformation> deformations)
{
  std::vector<double> all;
  all.reserve(9 * deformations.size());
  for (const Deformation &deformation : deformations)
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        all.push_back(deformation.relative_F[i][j]);
  return all;
}

unsigned holder_of(std::size_t point, const Begins &begins)
{
  const auto after = std::upper_bound(begins.begin(), begins.end(), point);
  return static_cast<unsigned>(after - begins.begin()) - 1;
}
} // namespace

SharedPoints::SharedPoints(std::unique_ptr<MovablePoints> own,
                           std::size_t count,
                           const Ranks &ranks)
    : own_(std::move(own)), ranks_(ranks),
      begins_(equal_shares(count, ranks.size())), costs_(count, 0.),
      step_costs_(count, 0.), busy_(ranks.size(), 0.)
{
  const Share share = own_->share();
  if (!ranks.all(share.begin == begins_[ranks.rank()] &&
                 share.end == begins_[ranks.rank() + 1]))
    throw std::invalid_argument("each rank needs an equal share of the " +
                                std::to_string(count) + " points");
}

unsigned SharedPoints::rank_of(std::size_t point) const
{
  return holder_of(point, begins_);
}

void SharedPoints::evaluate(std::span<const Deformation> deformations,
                            Want want,
                            std::span<Response> responses)
{
  if (deformations.size() != size() || responses.size() != size())
    throw std::invalid_argument("one deformation and one response per point");
  if (ranks_.size() > 1 && !ranks_.alike(numbers(deformations)))
    throw std::runtime_error(
        "the ranks compute different deformations of the same points; run on "
        "processors of one kind");
  const Share mine = share();
  own_->evaluate(deformations.subspan(mine.begin, mine.size()),
                 want,
                 responses.subspan(mine.begin, mine.size()));
  gather(want, responses);
  for (std::size_t i = 0; i < size(); ++i)
    step_costs_[i] += costs_[i];
  const auto loads = loads_of(costs_, begins_);
  for (unsigned rank = 0; rank < ranks_.size(); ++rank)
    busy_[rank] += loads[rank];
  span_ += *std::max_element(loads.begin(), loads.end());
}

void SharedPoints::gather(Want want, std::span<Response> responses)
{
  const Share mine = share();
  const std::size_t n = width(want);
  std::vector<double> table(n * size());
  for (std::size_t i = mine.begin; i < mine.end; ++i)
    write(responses[i], own_->cost(i - mine.begin), want, &table[n * i]);
  Begins places = begins_;
  for (std::size_t &place : places)
    place *= n;
  ranks_.gather(table, places);
  for (std::size_t i = 0; i < size(); ++i)
    read(&table[n * i], want, responses[i], costs_[i]);
}

void SharedPoints::commit()
{
  own_->commit();
  rebalance();
  step_costs_.assign(size(), 0.);
}

void SharedPoints::rebalance()
{
  const double idle = idle_share(loads_of(step_costs_, begins_));
  if (idle <= idle_bound)
    return;
  const Begins better = balanced_shares(step_costs_, ranks_.size());
  if (idle_share(loads_of(step_costs_, better)) < worthwhile * idle)
    move_to(better);
}

void SharedPoints::move_to(const Begins &begins)
{
  const unsigned here = ranks_.rank();
  std::map<std::size_t, std::vector<char>> arrived;
  for (std::size_t i = 0; i < size(); ++i) {
    const unsigned from = rank_of(i), to = holder_of(i, begins);
    if (from == to)
      continue;
    ++moved_;
    std::vector<char> state;
    if (from == here)
      own_->pack(i - share().begin, state);
    ranks_.move(state, from, to);
    if (to == here)
      arrived.emplace(i, std::move(state));
  }
  own_->hold({begins[here], begins[here + 1]});
  for (const auto &[i, state] : arrived)
    own_->unpack(i - share().begin, state);
  begins_ = begins;
}

void SharedPoints::pack(std::size_t point, std::vector<char> &bytes) const
{
  const unsigned rank = rank_of(point);
  std::vector<char> state;
  if (rank == ranks_.rank())
    own_->pack(point - share().begin, state);
  ranks_.spread(state, rank);
  bytes.insert(bytes.end(), state.begin(), state.end());
}

void SharedPoints::unpack(std::size_t point, std::span<const char> bytes)
{
  std::string problem;
  try {
    if (share().holds(point))
      own_->unpack(point - share().begin, bytes);
  } catch (const std::runtime_error &error) {
    problem = error.what();
  }
  problem = ranks_.first_text(problem);
  if (!problem.empty())
    throw std::runtime_error(problem);
}

void SharedPoints::variables_of(std::size_t point,
                                std::span<double> values) const
{
  if (share().holds(point))
    own_->variables_of(point - share().begin, values);
  ranks_.spread(values, rank_of(point));
}

RankLoads SharedPoints::loads() const
{
  RankLoads loads{std::vector<double>(ranks_.size(), 0.), moved_};
  for (unsigned rank = 0; rank < ranks_.size() && span_ > 0; ++rank)
    loads.idle[rank] = 1 - busy_[rank] / span_;
  return loads;
}
} // namespace tamp::fem
