// SPDX-License-Identifier: BSD-3-Clause
#include <tests/coupling/unit_cell_traits.h>

namespace tamp::fem::contract
{
/// Cells whose grains grow, dense enough that they do.
struct GrowingCells {
};

template <>
struct ContractTraits<GrowingCells> : ContractTraits<UnitCells> {
  // Growth by the last increment, of 5e-3, comes with the next.
  static double identity_tolerance() { return 0.025; }
  static std::unique_ptr<MaterialPoints> make()
  {
    return std::make_unique<coupling::UnitCellPoints>(
        std::vector<dem::UnitCell>(3, coupling::test::growing_cell()),
        coupling::test::cold());
  }
};

/// Cells whose limiting contact pressure follows their density.
struct AdjustedCells {
};

template <>
struct ContractTraits<AdjustedCells> : ContractTraits<UnitCells> {
  static std::unique_ptr<MaterialPoints> make()
  {
    return std::make_unique<coupling::UnitCellPoints>(
        std::vector<dem::UnitCell>(3, coupling::test::adjusted_cell()),
        coupling::test::cold());
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Grains, MaterialPointsContract, UnitCells);
INSTANTIATE_TYPED_TEST_SUITE_P(GrowingGrains,
                               MaterialPointsContract,
                               GrowingCells);
INSTANTIATE_TYPED_TEST_SUITE_P(AdjustedPressure,
                               MaterialPointsContract,
                               AdjustedCells);
} // namespace tamp::fem::contract
