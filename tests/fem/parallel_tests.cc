// SPDX-License-Identifier: BSD-3-Clause
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <iostream>

namespace
{
/// Speaks of failures only: every other rank says the same as the first.
class FailuresOfARank : public testing::EmptyTestEventListener
{
public:
  explicit FailuresOfARank(int rank) : rank_(rank) {}

  void OnTestPartResult(const testing::TestPartResult &result) override
  {
    if (result.failed())
      std::cerr << "rank " << rank_ << ": " << result.file_name() << ':'
                << result.line_number() << ": " << result.summary()
                << std::endl;
  }

private:
  int rank_;
};
} // namespace

/// Every rank runs all tests; the run fails if a rank does.
int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  auto &listeners = testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) {
    delete listeners.Release(listeners.default_result_printer());
    delete listeners.Release(listeners.default_xml_generator());
    listeners.Append(new FailuresOfARank(rank));
  }
  int outcome = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &outcome, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return outcome;
}
