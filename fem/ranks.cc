// SPDX-License-Identifier: BSD-3-Clause
#include <fem/ranks.h>

namespace tamp::fem
{
Ranks::Ranks(MPI_Comm communicator) : communicator_(communicator)
{
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
} // namespace tamp::fem
