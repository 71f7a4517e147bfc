// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_coupling_unit_cell_traits_h
#define tests_coupling_unit_cell_traits_h

#include <tests/contract/material_points_contract.h>
#include <tests/coupling/sample_cells.h>

#include <memory>
#include <vector>

namespace tamp::fem::contract
{
/// What the contract of material points asks of three cells.
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
} // namespace tamp::fem::contract

#endif
