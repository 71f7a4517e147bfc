// SPDX-License-Identifier: BSD-3-Clause
#include <fem/ranks.h>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace tamp::fem
{
Ranks::Ranks(MPI_Comm communicator) : communicator_(communicator)
{
  if (communicator == MPI_COMM_SELF) // known without MPI, on any thread
    return;
  int initialised = 0;
  MPI_Initialized(&initialised);
  if (initialised == 0)
    return;
  int rank = 0, size = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &size);
  rank_ = static_cast<unsigned>(rank);
  size_ = static_cast<unsigned>(size);
}

Share Ranks::share(std::size_t count) const
{
  return {count * rank_ / size_, count * (rank_ + 1) / size_};
}

void Ranks::sum(std::span<double> values) const
{
  if (size_ == 1)
    return;
  // Reducing to one rank, which tells the others, gives all the same bits.
  const int count = static_cast<int>(values.size());
  if (rank_ == 0)
    MPI_Reduce(MPI_IN_PLACE,
               values.data(),
               count,
               MPI_DOUBLE,
               MPI_SUM,
               0,
               communicator_);
  else
    MPI_Reduce(
        values.data(), nullptr, count, MPI_DOUBLE, MPI_SUM, 0, communicator_);
  spread(values);
}

double Ranks::largest(double value) const
{
  if (size_ > 1)
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, communicator_);
  return value;
}

bool Ranks::all(bool good) const
{
  int value = good ? 1 : 0;
  if (size_ > 1)
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MIN, communicator_);
  return value == 1;
}

void Ranks::spread(std::span<double> values, unsigned from) const
{
  if (size_ > 1)
    MPI_Bcast(values.data(),
              static_cast<int>(values.size()),
              MPI_DOUBLE,
              static_cast<int>(from),
              communicator_);
}

namespace
{
/// The most that one message of MPI holds with ease.
constexpr std::size_t largest_message = std::size_t(1) << 30;

/// Calls `send` with the parts of what may be too long for one message.
template <class Send>
void in_parts(std::vector<char> &bytes, const Send &send)
{
  for (std::size_t begin = 0; begin < bytes.size(); begin += largest_message)
    send(bytes.data() + begin,
         static_cast<int>(std::min(largest_message, bytes.size() - begin)));
}
} // namespace

void Ranks::spread(std::vector<char> &bytes, unsigned from) const
{
  if (size_ == 1)
    return;
  const int root = static_cast<int>(from);
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, root, communicator_);
  bytes.resize(size);
  in_parts(bytes, [&](char *part, int count) {
    MPI_Bcast(part, count, MPI_CHAR, root, communicator_);
  });
}

void Ranks::move(std::vector<char> &bytes, unsigned from, unsigned to) const
{
  constexpr int tag = 0;
  if (from == to || (rank_ != from && rank_ != to))
    return;
  std::uint64_t size = bytes.size();
  if (rank_ == from) {
    const int there = static_cast<int>(to);
    MPI_Send(&size, 1, MPI_UINT64_T, there, tag, communicator_);
    in_parts(bytes, [&](char *part, int count) {
      MPI_Send(part, count, MPI_CHAR, there, tag, communicator_);
    });
    return;
  }
  const int there = static_cast<int>(from);
  MPI_Recv(
      &size, 1, MPI_UINT64_T, there, tag, communicator_, MPI_STATUS_IGNORE);
  bytes.resize(size);
  in_parts(bytes, [&](char *part, int count) {
    MPI_Recv(
        part, count, MPI_CHAR, there, tag, communicator_, MPI_STATUS_IGNORE);
  });
}

void Ranks::gather(std::span<double> values,
                   std::span<const std::size_t> begins) const
{
  if (size_ == 1)
    return;
  std::vector<int> counts, places;
  for (unsigned r = 0; r < size_; ++r) {
    counts.push_back(static_cast<int>(begins[r + 1] - begins[r]));
    places.push_back(static_cast<int>(begins[r]));
  }
  MPI_Allgatherv(MPI_IN_PLACE,
                 0,
                 MPI_DATATYPE_NULL,
                 values.data(),
                 counts.data(),
                 places.data(),
                 MPI_DOUBLE,
                 communicator_);
}

std::vector<char> Ranks::join(const std::vector<char> &bytes) const
{
  if (size_ == 1)
    return bytes;
  std::vector<char> all;
  for (unsigned from = 0; from < size_; ++from) {
    std::vector<char> part;
    if (from == rank_)
      part = bytes;
    spread(part, from);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::string Ranks::first_text(const std::string &text) const
{
  const double order = text.empty() ? 0 : size_ - rank_;
  const auto first = static_cast<unsigned>(largest(order));
  if (first == 0)
    return {};
  std::vector<char> bytes(text.begin(), text.end());
  spread(bytes, size_ - first);
  return {bytes.begin(), bytes.end()};
}

bool Ranks::alike(std::span<const double> values) const
{
  if (size_ == 1)
    return true;
  std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a, by words
  for (const double value : values)
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
  // The least of both is that of all only if there is but one.
  std::uint64_t least[] = {hash, ~hash};
  MPI_Allreduce(MPI_IN_PLACE, least, 2, MPI_UINT64_T, MPI_MIN, communicator_);
  return least[0] == ~least[1];
}
} // namespace tamp::fem
