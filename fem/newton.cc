// SPDX-License-Identifier: BSD-3-Clause
#include <fem/newton.h>
#include <fem/petsc_check.h>

#include <petscsnes.h>

#include <algorithm>
#include <exception>

namespace tamp::fem
{
namespace
{
std::vector<double> copy_of(Vec vector)
{
  PetscInt size = 0;
  const PetscScalar *entries = nullptr;
  petsc_check(VecGetSize(vector, &size), "reading a vector");
  petsc_check(VecGetArrayRead(vector, &entries), "reading a vector");
  std::vector<double> result(entries, entries + size);
  petsc_check(VecRestoreArrayRead(vector, &entries), "reading a vector");
  return result;
}

void fill(Vec vector, const std::vector<double> &values)
{
  PetscScalar *entries = nullptr;
  petsc_check(VecGetArray(vector, &entries), "filling a vector");
  std::copy(values.begin(), values.end(), entries);
  petsc_check(VecRestoreArray(vector, &entries), "filling a vector");
}

/// SNES with its problem. PETSc is written in C: what a callback throws is kept
/// and thrown again when SNES has returned.
class Newton
{
public:
  Newton(const NewtonProblem &problem, std::vector<double> &x, unsigned most)
      : problem_(problem), x_(x)
  {
    const auto size = static_cast<PetscInt>(x.size());
    petsc_check(VecCreateSeq(PETSC_COMM_SELF, size, &solution_),
                "creating a vector");
    petsc_check(VecDuplicate(solution_, &residual_), "creating a vector");
    petsc_check(
        MatCreateShell(PETSC_COMM_SELF, size, size, size, size, this, &matrix_),
        "creating the matrix");
    // SNES multiplies only to ask whether it failed in a local minimum.
    petsc_check(MatShellSetOperation(
                    matrix_, MATOP_MULT, reinterpret_cast<void (*)()>(copy)),
                "creating the matrix");
    petsc_check(SNESCreate(PETSC_COMM_SELF, &snes_), "creating SNES");
    petsc_check(SNESSetType(snes_, SNESNEWTONLS), "choosing Newton's method");
    petsc_check(SNESSetFunction(snes_, residual_, form_residual, this),
                "set-up");
    petsc_check(SNESSetJacobian(snes_, matrix_, matrix_, keep_jacobian, this),
                "set-up");
    petsc_check(SNESSetConvergenceTest(snes_, test, this, nullptr), "set-up");
    petsc_check(
        SNESSetTolerances(snes_, 0, 0, 0, static_cast<PetscInt>(most), 1000000),
        "set-up");
    SNESLineSearch search = nullptr;
    petsc_check(SNESGetLineSearch(snes_, &search), "set-up");
    petsc_check(SNESLineSearchSetType(search, SNESLINESEARCHBASIC), "set-up");
    petsc_check(SNESLineSearchSetPreCheck(search, limit, this), "set-up");
    set_up_linear_solver();
  }

  ~Newton()
  {
    // Nothing can be done about an error here.
    (void)SNESDestroy(&snes_);
    (void)MatDestroy(&matrix_);
    (void)VecDestroy(&residual_);
    (void)VecDestroy(&solution_);
  }
  Newton(const Newton &) = delete;
  Newton &operator=(const Newton &) = delete;

  NewtonOutcome solve()
  {
    fill(solution_, x_);
    const PetscErrorCode code = SNESSolve(snes_, nullptr, solution_);
    if (thrown_)
      std::rethrow_exception(thrown_);
    petsc_check(code, "SNESSolve");
    NewtonOutcome outcome;
    PetscInt iterations = 0;
    SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
    petsc_check(SNESGetIterationNumber(snes_, &iterations), "asking SNES");
    petsc_check(SNESGetConvergedReason(snes_, &reason), "asking SNES");
    outcome.iterations = static_cast<unsigned>(iterations);
    outcome.converged = reason > 0;
    if (reason == SNES_DIVERGED_LINEAR_SOLVE)
      outcome.reason = "the linear equations have no solution";
    else if (reason == SNES_DIVERGED_MAX_IT)
      outcome.reason = "no equilibrium";
    else if (reason < 0)
      outcome.reason = SNESConvergedReasons[reason];
    x_ = copy_of(solution_);
    return outcome;
  }

private:
  void set_up_linear_solver()
  {
    KSP ksp = nullptr;
    PC pc = nullptr;
    petsc_check(SNESGetKSP(snes_, &ksp), "set-up");
    petsc_check(KSPSetType(ksp, KSPPREONLY), "set-up");
    petsc_check(KSPGetPC(ksp, &pc), "set-up");
    petsc_check(PCSetType(pc, PCSHELL), "set-up");
    petsc_check(PCShellSetContext(pc, this), "set-up");
    petsc_check(PCShellSetApply(pc, apply), "set-up");
  }

  /// Runs a callback's work; an exception becomes an error code.
  template <class Work>
  PetscErrorCode guarded(const Work &work)
  {
    try {
      work();
      return 0;
    } catch (...) {
      thrown_ = std::current_exception();
      return PETSC_ERR_USER;
    }
  }

  static PetscErrorCode form_residual(SNES snes, Vec x, Vec r, void *context)
  {
    auto &newton = *static_cast<Newton *>(context);
    return newton.guarded([&] {
      std::vector<double> residual(newton.x_.size(), 0.);
      if (newton.problem_.residual(copy_of(x), residual))
        fill(r, residual);
      else
        petsc_check(SNESSetFunctionDomainError(snes), "telling SNES");
    });
  }

  /// The problem makes its derivative when it solves.
  static PetscErrorCode keep_jacobian(SNES, Vec, Mat, Mat, void *) { return 0; }

  static PetscErrorCode copy(Mat, Vec x, Vec y) { return VecCopy(x, y); }

  static PetscErrorCode apply(PC pc, Vec r, Vec y)
  {
    void *context = nullptr;
    if (PCShellGetContext(pc, &context) != 0)
      return PETSC_ERR_USER;
    auto &newton = *static_cast<Newton *>(context);
    return newton.guarded([&] {
      std::vector<double> answer(newton.x_.size(), 0.);
      if (!newton.problem_.solve(copy_of(r), answer))
        petsc_check(PCSetFailedReason(pc, PC_SUBPC_ERROR), "telling SNES");
      fill(y, answer);
    });
  }

  static PetscErrorCode
  limit(SNESLineSearch, Vec x, Vec y, PetscBool *changed, void *context)
  {
    auto &newton = *static_cast<Newton *>(context);
    return newton.guarded([&] {
      // PETSc's step is x - y.
      std::vector<double> step = copy_of(y);
      for (double &value : step)
        value = -value;
      newton.problem_.limit(copy_of(x), step);
      newton.step_ = step;
      for (double &value : step)
        value = -value;
      fill(y, step);
      *changed = PETSC_TRUE;
    });
  }

  static PetscErrorCode test(SNES snes,
                             PetscInt,
                             PetscReal,
                             PetscReal,
                             PetscReal,
                             SNESConvergedReason *reason,
                             void *context)
  {
    auto &newton = *static_cast<Newton *>(context);
    return newton.guarded([&] {
      Vec x = nullptr;
      petsc_check(SNESGetSolution(snes, &x), "asking SNES");
      *reason = newton.problem_.converged(copy_of(x), newton.step_)
                    ? SNES_CONVERGED_FNORM_ABS
                    : SNES_CONVERGED_ITERATING;
    });
  }

  const NewtonProblem &problem_;
  std::vector<double> &x_;
  std::vector<double> step_;
  std::exception_ptr thrown_;
  Vec solution_ = nullptr, residual_ = nullptr;
  Mat matrix_ = nullptr;
  SNES snes_ = nullptr;
};
} // namespace

NewtonOutcome solve_newton(const NewtonProblem &problem,
                           std::vector<double> &x,
                           unsigned maximum_iterations)
{
  return Newton(problem, x, maximum_iterations).solve();
}
} // namespace tamp::fem
