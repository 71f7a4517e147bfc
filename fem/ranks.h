// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_ranks_h
#define fem_ranks_h

#include <mpi.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tamp::fem
{
/// A share of numbered things: begin <= i < end.
struct Share {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
  bool holds(std::size_t i) const { return begin <= i && i < end; }
};

/// The processes that work together on one run. Every rank holds all nodal
/// vectors; cells, material points and the rows of matrices are shared out.
class Ranks
{
public:
  /// @param communicator  a program without MPI_Init stands alone.
  explicit Ranks(MPI_Comm communicator = MPI_COMM_SELF);

  unsigned rank() const { return rank_; }
  unsigned size() const { return size_; }
  MPI_Comm communicator() const { return communicator_; }

  /// This rank's share of `count` things: ranges in the order of the ranks.
  Share share(std::size_t count) const;

  /// Replaces values by their sums over the ranks: the same bits everywhere.
  void sum(std::span<double> values) const;
  double largest(double value) const;
  /// Does it hold on every rank?
  bool all(bool good) const;
  /// Copies the values of one rank to all.
  void spread(std::span<double> values, unsigned from = 0) const;
  /// Replaces bytes, as many as there are, by those of one rank on all.
  void spread(std::vector<char> &bytes, unsigned from = 0) const;
  /// Copies the bytes of one rank to another one; both must call, the others
  /// may and keep what they have.
  void move(std::vector<char> &bytes, unsigned from, unsigned to) const;
  /// Completes values of which every rank has a range, rank r that from
  /// begins[r] to begins[r + 1].
  void gather(std::span<double> values,
              std::span<const std::size_t> begins) const;
  /// The bytes of all ranks, in the order of the ranks, on every rank.
  std::vector<char> join(const std::vector<char> &bytes) const;
  /// The text of the first rank that has any, on every rank.
  std::string first_text(const std::string &text) const;
  /// Do all ranks hold the same bits? Tells by a checksum of 64 bits.
  bool alike(std::span<const double> values) const;

private:
  MPI_Comm communicator_;
  unsigned rank_ = 0, size_ = 1;
};
} // namespace tamp::fem

#endif
