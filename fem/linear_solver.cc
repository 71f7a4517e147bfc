// SPDX-License-Identifier: BSD-3-Clause
#include <fem/linear_solver.h>

#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tamp::fem
{
namespace
{
void check(PetscErrorCode code, const char *what)
{
  if (code != 0)
    throw std::runtime_error(std::string("PETSc: ") + what + " failed (error " +
                             std::to_string(code) + ")");
}

bool finite(std::span<const double> values)
{
  return std::all_of(values.begin(), values.end(), [](double value) {
    return std::isfinite(value);
  });
}
} // namespace

struct LinearSolver::Implementation {
  SparseRows matrix; ///< PETSc works on these arrays
  std::vector<double> rhs, x;
  Mat A = nullptr;
  Mat factors = nullptr; ///< belongs to the solver
  Vec b = nullptr, y = nullptr;
  KSP ksp = nullptr;

  explicit Implementation(const SparseRows &rows)
      : matrix(rows), rhs(rows.size(), 0.), x(rows.size(), 0.)
  {
    const PetscInt n = rows.size();
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF,
                                    n,
                                    n,
                                    matrix.begin.data(),
                                    matrix.column.data(),
                                    matrix.value.data(),
                                    &A),
          "creating the matrix");
    check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, rhs.data(), &b),
          "creating a vector");
    check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, x.data(), &y),
          "creating a vector");
    set_up_solver();
  }

  void set_up_solver()
  {
    PC pc = nullptr;
    check(KSPCreate(PETSC_COMM_SELF, &ksp), "creating the solver");
    check(KSPSetOperators(ksp, A, A), "setting the matrix");
    check(KSPSetType(ksp, KSPPREONLY), "choosing the solver");
    check(KSPGetPC(ksp, &pc), "choosing the solver");
    check(PCSetType(pc, PCLU), "choosing LU");
    check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS), "choosing MUMPS");
    check(PCFactorSetUpMatSolverType(pc), "setting up MUMPS");
    check(PCFactorGetMatrix(pc, &factors), "setting up MUMPS");
    // The analysis must see the pattern only: no permutation by values (6),
    // ordering by approximate minimum degree (7). Room for pivoting (14).
    check(MatMumpsSetIcntl(factors, 6, 0), "setting up MUMPS");
    check(MatMumpsSetIcntl(factors, 7, 0), "setting up MUMPS");
    check(MatMumpsSetIcntl(factors, 14, 100), "setting up MUMPS");
  }

  /// MUMPS keeps an error; a new instance does not.
  void renew_solver()
  {
    check(KSPDestroy(&ksp), "setting up the solver");
    set_up_solver();
  }

  ~Implementation()
  {
    // Nothing can be done about an error here.
    (void)KSPDestroy(&ksp);
    (void)VecDestroy(&y);
    (void)VecDestroy(&b);
    (void)MatDestroy(&A);
  }
};

LinearSolver::LinearSolver(const SparseRows &matrix)
    : implementation_(std::make_unique<Implementation>(matrix))
{
}

LinearSolver::~LinearSolver() = default;

bool LinearSolver::factorise(std::span<const double> values)
{
  if (!finite(values))
    return false;
  Implementation &s = *implementation_;
  // Taking and giving back the array tells PETSc that it has changed.
  PetscScalar *entries = nullptr;
  check(MatSeqAIJGetArray(s.A, &entries), "filling the matrix");
  std::copy(values.begin(), values.end(), entries);
  check(MatSeqAIJRestoreArray(s.A, &entries), "filling the matrix");
  check(KSPSetOperators(s.ksp, s.A, s.A), "setting the matrix");
  check(KSPSetUp(s.ksp), "factorising");
  PetscInt outcome = 0; // of MUMPS; negative: an error
  check(MatMumpsGetInfog(s.factors, 1, &outcome), "factorising");
  if (outcome < 0)
    s.renew_solver();
  return outcome >= 0;
}

bool LinearSolver::solve(std::span<const double> right_side,
                         std::span<double> solution)
{
  Implementation &s = *implementation_;
  PetscScalar *entries = nullptr;
  check(VecGetArray(s.b, &entries), "filling the right side");
  std::copy(right_side.begin(), right_side.end(), entries);
  check(VecRestoreArray(s.b, &entries), "filling the right side");
  check(KSPSolve(s.ksp, s.b, s.y), "solving");
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(s.ksp, &reason), "solving");
  if (reason < 0 || !finite(s.x))
    return false;
  std::copy(s.x.begin(), s.x.end(), solution.begin());
  return true;
}
} // namespace tamp::fem
