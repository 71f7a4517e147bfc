// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_petsc_check_h
#define fem_petsc_check_h

#include <stdexcept>
#include <string>

namespace tamp::fem
{
/// PETSc carries on after an error: throws std::runtime_error saying what
/// failed if the code of a call (a PetscErrorCode) is not zero.
inline void petsc_check(int code, const char *what)
{
  if (code != 0)
    throw std::runtime_error(std::string("PETSc: ") + what + " failed (error " +
                             std::to_string(code) + ")");
}
} // namespace tamp::fem

#endif
