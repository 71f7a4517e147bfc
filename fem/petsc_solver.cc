// SPDX-License-Identifier: BSD-3-Clause
#include <fem/linear_backends.h>
#include <fem/petsc_check.h>

#include <petscksp.h>

#include <algorithm>
#include <string>

namespace tamp::fem
{
namespace
{
/// The matrix and the vectors, distributed; a solver to be chosen.
class PetscSolver : public LinearSolver::Backend
{
public:
  explicit PetscSolver(const LinearSystem &system) : system_(system)
  {
    petsc_check(MatCreate(system.ranks.communicator(), &A_),
                "creating the matrix");
    create_matrix();
    petsc_check(MatCreateVecs(A_, &x_, &b_), "creating vectors");
  }

  ~PetscSolver() override
  {
    // Nothing can be done about an error here.
    (void)KSPDestroy(&ksp_);
    (void)VecDestroy(&x_);
    (void)VecDestroy(&b_);
    (void)MatDestroy(&A_);
  }

  PetscSolver(const PetscSolver &) = delete;
  PetscSolver &operator=(const PetscSolver &) = delete;

  bool solve(std::span<const double> right_side,
             std::span<double> solution) override
  {
    PetscScalar *entries = nullptr;
    petsc_check(VecGetArrayWrite(b_, &entries), "filling the right side");
    std::copy(right_side.begin(), right_side.end(), entries);
    petsc_check(VecRestoreArrayWrite(b_, &entries), "filling the right side");
    petsc_check(KSPSolve(ksp_, b_, x_), "solving");
    const PetscScalar *found = nullptr;
    petsc_check(VecGetArrayRead(x_, &found), "reading the solution");
    std::copy(found, found + solution.size(), solution.begin());
    petsc_check(VecRestoreArrayRead(x_, &found), "reading the solution");
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    petsc_check(KSPGetConvergedReason(ksp_, &reason), "solving");
    return reason >= 0;
  }

protected:
  /// Entries of several ranks add up.
  void fill(std::span<const double> values)
  {
    petsc_check(MatSetValuesCOO(A_, values.data(), INSERT_VALUES),
                "filling the matrix");
  }

  /// A solver that knows nothing of earlier matrices.
  void renew_solver()
  {
    petsc_check(KSPDestroy(&ksp_), "setting up the solver");
    petsc_check(KSPCreate(system_.ranks.communicator(), &ksp_),
                "setting up the solver");
    petsc_check(KSPSetOperators(ksp_, A_, A_), "setting the matrix");
  }

  const LinearSystem &system_;
  Mat A_ = nullptr;
  Vec b_ = nullptr, x_ = nullptr;
  KSP ksp_ = nullptr;

private:
  void create_matrix()
  {
    const SparseRows &pattern = system_.pattern;
    const auto local = static_cast<PetscInt>(system_.rows.size());
    petsc_check(MatSetSizes(A_, local, local, pattern.size(), pattern.size()),
                "creating the matrix");
    petsc_check(MatSetBlockSize(A_, static_cast<PetscInt>(system_.block)),
                "creating the matrix");
    petsc_check(MatSetType(A_, MATAIJ), "creating the matrix");
    std::vector<PetscInt> rows, columns = pattern.column; // PETSc sorts them
    rows.reserve(columns.size());
    for (int row = 0; row < pattern.size(); ++row)
      rows.insert(rows.end(), pattern.begin[row + 1] - pattern.begin[row], row);
    petsc_check(MatSetPreallocationCOO(A_,
                                       static_cast<PetscCount>(rows.size()),
                                       rows.data(),
                                       columns.data()),
                "creating the matrix");
  }
};

class PetscDirect : public PetscSolver
{
public:
  explicit PetscDirect(const LinearSystem &system) : PetscSolver(system)
  {
    set_up_solver();
  }

  bool factorise(std::span<const double> values, bool /*symmetric*/) override
  {
    fill(values);
    petsc_check(KSPSetOperators(ksp_, A_, A_), "setting the matrix");
    petsc_check(KSPSetUp(ksp_), "factorising");
    PetscInt outcome = 0; // of MUMPS; negative: an error
    petsc_check(MatMumpsGetInfog(factors_, 1, &outcome), "factorising");
    if (outcome < 0) // which MUMPS keeps; a new instance does not
      set_up_solver();
    return outcome >= 0;
  }

  unsigned iterations() const override { return 1; }

private:
  void set_up_solver()
  {
    renew_solver();
    PC pc = nullptr;
    petsc_check(KSPSetType(ksp_, KSPPREONLY), "choosing the solver");
    petsc_check(KSPGetPC(ksp_, &pc), "choosing the solver");
    petsc_check(PCSetType(pc, PCLU), "choosing LU");
    petsc_check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS), "choosing MUMPS");
    petsc_check(PCFactorSetUpMatSolverType(pc), "setting up MUMPS");
    petsc_check(PCFactorGetMatrix(pc, &factors_), "setting up MUMPS");
    // The analysis must see the pattern only: no permutation by values (6).
    // Room for pivoting (14). MUMPS chooses the ordering by the pattern.
    petsc_check(MatMumpsSetIcntl(factors_, 6, 0), "setting up MUMPS");
    petsc_check(MatMumpsSetIcntl(factors_, 14, 100), "setting up MUMPS");
  }

  Mat factors_ = nullptr; ///< belongs to the solver
};

/// Conjugate gradients or GMRES, with smoothed aggregation.
class PetscMultigrid : public PetscSolver
{
public:
  explicit PetscMultigrid(const LinearSystem &system) : PetscSolver(system)
  {
    tell_rigid_modes();
  }

  bool factorise(std::span<const double> values, bool symmetric) override
  {
    fill(values);
    const PetscBool answer = symmetric ? PETSC_TRUE : PETSC_FALSE;
    petsc_check(MatSetOption(A_, MAT_SYMMETRIC, answer), "filling the matrix");
    renew_solver();
    choose(symmetric ? KSPCG : KSPGMRES);
    PC pc = nullptr;
    petsc_check(KSPGetPC(ksp_, &pc), "choosing the solver");
    petsc_check(PCSetType(pc, PCGAMG), "choosing multigrid");
    // Smoothing the interpolation spoils it where friction meets a stiff
    // contact (several times the iterations), and costs more than it saves
    // elsewhere.
    petsc_check(PCGAMGSetNSmooths(pc, 0), "choosing multigrid");
    petsc_check(KSPSetUp(ksp_), "setting up multigrid");
    PCFailedReason reason = PC_NOERROR;
    petsc_check(PCGetFailedReason(pc, &reason), "setting up multigrid");
    return reason == PC_NOERROR;
  }

  bool solve(std::span<const double> right_side,
             std::span<double> solution) override
  {
    const bool solved = PetscSolver::solve(right_side, solution);
    PetscBool conjugate_gradients = PETSC_FALSE;
    petsc_check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(ksp_),
                                       KSPCG,
                                       &conjugate_gradients),
                "asking for the solver");
    if (solved || conjugate_gradients == PETSC_FALSE)
      return solved;
    choose(KSPGMRES); // the matrix is not positive definite
    return PetscSolver::solve(right_side, solution);
  }

  unsigned iterations() const override
  {
    PetscInt count = 0;
    petsc_check(KSPGetIterationNumber(ksp_, &count), "asking for iterations");
    return static_cast<unsigned>(count);
  }

private:
  void choose(KSPType type)
  {
    constexpr PetscInt restart = 100;
    const LinearSettings &settings = system_.settings;
    petsc_check(KSPSetType(ksp_, type), "choosing the solver");
    petsc_check(KSPGMRESSetRestart(ksp_, restart), "choosing the solver");
    if (std::string(type) == KSPGMRES)
      petsc_check(KSPSetPCSide(ksp_, PC_RIGHT), "choosing the solver");
    petsc_check(KSPSetNormType(ksp_, KSP_NORM_UNPRECONDITIONED),
                "choosing the solver");
    petsc_check(
        KSPSetTolerances(ksp_,
                         settings.tolerance,
                         0.,
                         PETSC_DEFAULT,
                         static_cast<PetscInt>(settings.maximum_iterations)),
        "choosing the solver");
  }

  void tell_rigid_modes()
  {
    const Share &rows = system_.rows;
    std::vector<Vec> modes(system_.rigid_modes.size(), nullptr);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      petsc_check(VecDuplicate(b_, &modes[i]), "creating rigid modes");
      PetscScalar *entries = nullptr;
      petsc_check(VecGetArrayWrite(modes[i], &entries), "creating rigid modes");
      std::copy(system_.rigid_modes[i].begin() + rows.begin,
                system_.rigid_modes[i].begin() + rows.end,
                entries);
      petsc_check(VecRestoreArrayWrite(modes[i], &entries),
                  "creating rigid modes");
    }
    MatNullSpace space = nullptr;
    petsc_check(MatNullSpaceCreate(system_.ranks.communicator(),
                                   PETSC_FALSE,
                                   static_cast<PetscInt>(modes.size()),
                                   modes.data(),
                                   &space),
                "creating rigid modes");
    if (!modes.empty())
      petsc_check(MatSetNearNullSpace(A_, space), "setting rigid modes");
    petsc_check(MatNullSpaceDestroy(&space), "creating rigid modes");
    for (Vec &mode : modes)
      petsc_check(VecDestroy(&mode), "creating rigid modes");
  }
};
} // namespace

std::unique_ptr<LinearSolver::Backend> petsc_direct(const LinearSystem &system)
{
  return std::make_unique<PetscDirect>(system);
}

std::unique_ptr<LinearSolver::Backend>
petsc_multigrid(const LinearSystem &system)
{
  return std::make_unique<PetscMultigrid>(system);
}
} // namespace tamp::fem
