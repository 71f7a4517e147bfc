// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/shared_cells.h>
#include <tests/coupling/unit_cell_traits.h>

#include <memory>

namespace tamp::fem::contract
{
/// Three cells, shared out over all ranks: with four, some have none.
struct CellsOfAllRanks {
};

template <>
struct ContractTraits<CellsOfAllRanks> : ContractTraits<UnitCells> {
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
};

INSTANTIATE_TYPED_TEST_SUITE_P(Parallel,
                               MaterialPointsContract,
                               CellsOfAllRanks);
} // namespace tamp::fem::contract
