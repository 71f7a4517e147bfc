// SPDX-License-Identifier: BSD-3-Clause
#include <tests/contract/material_points_contract.h>
#include <tests/coupling/sample_cells.h>

namespace tamp::fem::contract
{
struct UnitCells {
};

template <>
struct ContractTraits<UnitCells> : ContractDefaults {
  // Unsettled grains stay within the tolerance of the unbalance when nothing
  // moves.
  static double identity_tolerance() { return 5e-3; }
  static Tangent tangent() { return Tangent::upper_bound; }
  static double tangent_tolerance() { return 0.1; }
  // Affine motion without rotation is at most a few times too stiff.
  static double most_stiff() { return 6; }
  static double probe_strain() { return 1e-3; }

  static std::unique_ptr<MaterialPoints> make()
  {
    return std::make_unique<coupling::UnitCellPoints>(
        coupling::test::same_cells(3), coupling::test::cold());
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

INSTANTIATE_TYPED_TEST_SUITE_P(Grains, MaterialPointsContract, UnitCells);
INSTANTIATE_TYPED_TEST_SUITE_P(GrowingGrains,
                               MaterialPointsContract,
                               GrowingCells);
} // namespace tamp::fem::contract
