// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_bias_sampling_h
#define coupling_bias_sampling_h

#include <coupling/shared_cells.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tamp::coupling
{
/// An increment from the committed state of a point, and what its cell answered
/// to it.
struct CellIncrement {
  std::size_t point = 0;
  fem::Deformation deformation;
  dealii::SymmetricTensor<2, 3> stress; ///< [Pa]
};

/// The same increment, driven more finely.
struct FinerAnswer {
  bool settled = false; ///< if not, there is no stress to compare
  dealii::SymmetricTensor<2, 3> stress; ///< [Pa]
  double evaluations = 0;               ///< of forces
};

/// Driving that costs more and is more exact: grains are balanced ten times
/// better, in three times as many parts; in dynamics at a third of the rate.
/// @param strain  largest principal strain of the increment [-]
dem::Driving finer_driving(const dem::Driving &driving, double strain);

/// Which points are looked at for the `number`-th time, from 0: a quarter of
/// them, at least one and at most four. Each has its turn before one has its
/// second.
std::vector<std::size_t> sampled_points(std::size_t number, std::size_t points);

/// Computes increments again from the committed states, which stay as they are,
/// cold and with finer_driving(): what the answers of the cells are off by is
/// seen in the difference. Collective; the same on any number of ranks and
/// threads.
/// @param increments  of different points, the same on all ranks
/// @param driving     of the cells, with the force floor of the moment
std::vector<FinerAnswer>
answer_finely(SharedCells &cells,
              std::span<const CellIncrement> increments,
              const dem::Driving &driving,
              unsigned threads);
} // namespace tamp::coupling

#endif
