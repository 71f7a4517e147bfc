// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/shared_cells.h>
#include <tests/contract/material_points_contract.h>
#include <tests/coupling/sample_cells.h>

#include <memory>

namespace tamp::fem::contract
{
/// Three cells, shared out over all ranks: with four, some have none.
struct CellsOfAllRanks {
};

template <>
struct ContractTraits<CellsOfAllRanks> : ContractDefaults {
  // As of unit cells on one rank.
  static double identity_tolerance() { return 5e-3; }
  static Tangent tangent() { return Tangent::upper_bound; }
  static double tangent_tolerance() { return 0.1; }
  static double most_stiff() { return 6; }
  static double probe_strain() { return 1e-3; }

  static std::unique_ptr<MaterialPoints> make()
  {
    constexpr std::size_t count = 3;
    const Ranks ranks(MPI_COMM_WORLD);
    const Share own = ranks.share(count);
    coupling::CellPointsOptions options = coupling::test::cold();
    options.first_point = own.begin;
    return std::make_unique<coupling::SharedCells>(
        std::make_unique<coupling::UnitCellPoints>(
            coupling::test::same_cells(own.size()), options),
        count,
        ranks);
  }
  static std::vector<dealii::Tensor<2, 3>> path()
  {
    dealii::Tensor<2, 3> press;
    press[0][0] = press[1][1] = 1;
    press[2][2] = 1 - 5e-3;
    return {press, press, press, press};
  }
  static dealii::Tensor<2, 3> next()
  {
    dealii::Tensor<2, 3> F;
    F[0][0] = 1 - 1e-3;
    F[1][1] = 1;
    F[2][2] = 1 - 4e-3;
    F[0][2] = 2e-3;
    F[2][0] = -1e-3;
    return F;
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Parallel,
                               MaterialPointsContract,
                               CellsOfAllRanks);
} // namespace tamp::fem::contract
