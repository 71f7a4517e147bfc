// SPDX-License-Identifier: BSD-3-Clause
#include <dem/condensed_tangent.h>
#include <dem/measures.h>
#include <dem/six.h>

#include <vector>

namespace tamp::dem
{
SolvedTangent condensed_stiffness(const UnitCell &cell,
                                  const NetworkChoice &choice)
{
  std::vector<Matrix3> strains;
  for (int column = 0; column < 6; ++column)
    strains.push_back(unit_strain(column));
  const std::vector<NetworkResponse> responses =
      ContactNetwork(cell, choice).respond(strains);
  SolvedTangent result;
  result.converged = !responses.empty();
  for (int column = 0; column < 6 && result.converged; ++column)
    result.tangent.col(column) = to_six(responses[column].stress_change);
  return result;
}

SolvedTangent condensed_tangent(const UnitCell &cell, NetworkChoice choice)
{
  choice.turning = true;
  SolvedTangent result = condensed_stiffness(cell, choice);
  result.tangent += stress_transport(love_weber_stress(cell));
  return result;
}
} // namespace tamp::dem
