// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_shared_points_h
#define fem_shared_points_h

#include <fem/balanced_shares.h>
#include <fem/movable_points.h>

#include <memory>
#include <vector>

namespace tamp::fem
{
/// How well the ranks were used so far.
struct RankLoads {
  /// Of each rank's time in evaluations, the share in which it waited for
  /// others, measured by cost [-].
  std::vector<double> idle;
  std::size_t moved = 0; ///< points that went to another rank
};

/// All points of a run, of which each rank computes a range: for materials
/// that are dear next to the finite elements. Every rank is told all
/// deformations and gets all answers, so that what it does with them, on its
/// own, is the same to the bit on every rank and on any number of them. Where
/// ranks wait for others, ranges change in commit(): costs are those of the
/// step. All functions are collective and answer the same on every rank.
class SharedPoints : public MaterialPoints
{
public:
  /// @param own    of this rank; begins() of equal shares of all.
  /// @param count  of all points.
  SharedPoints(std::unique_ptr<MovablePoints> own,
               std::size_t count,
               const Ranks &ranks);

  std::size_t size() const final { return costs_.size(); }
  void begin_attempt() final { own_->begin_attempt(); }
  /// Throws std::runtime_error if the ranks were told different deformations,
  /// as may be if their processors round differently.
  void evaluate(std::span<const Deformation> deformations,
                Want want,
                std::span<Response> responses) final;
  void commit() final;
  /// Every rank gets the bytes.
  void pack(std::size_t point, std::vector<char> &bytes) const final;
  void unpack(std::size_t point, std::span<const char> bytes) final;
  double cost(std::size_t point) const final { return costs_.at(point); }
  std::vector<Variable> variables() const final { return own_->variables(); }
  void variables_of(std::size_t point, std::span<double> values) const final;

  /// Which points this rank computes, and these alone: to store their states.
  Share share() const { return own_->share(); }
  MaterialPoints &own() { return *own_; }
  const Ranks &ranks() const { return ranks_; }
  RankLoads loads() const;

private:
  unsigned rank_of(std::size_t point) const;
  void gather(Want want, std::span<Response> responses);
  void rebalance();
  void move_to(const Begins &begins);

  std::unique_ptr<MovablePoints> own_;
  Ranks ranks_;
  Begins begins_;
  std::vector<double> costs_;      ///< of the last evaluation
  std::vector<double> step_costs_; ///< of all evaluations since the last commit
  std::vector<double> busy_;       ///< cost of each rank so far
  double span_ = 0; ///< of the slowest in each evaluation, so far
  std::size_t moved_ = 0;
};
} // namespace tamp::fem

#endif
