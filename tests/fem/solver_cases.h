// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_solver_cases_h
#define tests_fem_solver_cases_h

#include <fem/linear_solver.h>

#include <gtest/gtest.h>
#include <string>

namespace tamp::fem::test
{
inline bool is_direct(const LinearSettings &settings)
{
  return settings.method == LinearMethod::direct;
}

/// Every library with every method.
inline auto all_solvers()
{
  return testing::Values(
      LinearSettings{LinearAlgebra::petsc, LinearMethod::direct},
      LinearSettings{LinearAlgebra::petsc, LinearMethod::iterative},
      LinearSettings{LinearAlgebra::trilinos, LinearMethod::direct},
      LinearSettings{LinearAlgebra::trilinos, LinearMethod::iterative});
}

inline std::string
solver_name(const testing::TestParamInfo<LinearSettings> &info)
{
  const bool petsc = info.param.algebra == LinearAlgebra::petsc;
  return std::string(petsc ? "petsc_" : "trilinos_") +
         (is_direct(info.param) ? "direct" : "iterative");
}
} // namespace tamp::fem::test

#endif
