// SPDX-License-Identifier: BSD-3-Clause
#include <fem/linear_backends.h>

#include <Amesos_Mumps.h>
#include <AztecOO.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Export.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <ml_MultiLevelPreconditioner.h>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tamp::fem
{
namespace
{
void check(int code, const char *what)
{
  if (code < 0)
    throw std::runtime_error(std::string("Trilinos: ") + what +
                             " failed (error " + std::to_string(code) + ")");
}

std::vector<int> all_numbers(int count)
{
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The rows in which the rank has entries.
std::vector<int> touched_rows(const SparseRows &pattern)
{
  std::vector<int> rows;
  for (int row = 0; row < pattern.size(); ++row)
    if (pattern.begin[row] < pattern.begin[row + 1])
      rows.push_back(row);
  return rows;
}

/// The matrix and the vectors, distributed; a solver to be chosen.
class TrilinosSolver : public LinearSolver::Backend
{
public:
  explicit TrilinosSolver(const LinearSystem &system)
      : system_(system), communicator_(system.ranks.communicator()),
        rows_(system.pattern.size(),
              static_cast<int>(system.rows.size()),
              0,
              communicator_),
        touched_(touched_rows(system.pattern)),
        touched_map_(-1,
                     static_cast<int>(touched_.size()),
                     touched_.data(),
                     0,
                     communicator_),
        exporter_(touched_map_, rows_), A_(Copy, rows_, 0), b_(rows_), x_(rows_)
  {
    create_matrix();
    problem_.SetOperator(&A_);
    problem_.SetRHS(&b_);
    problem_.SetLHS(&x_);
  }

protected:
  /// Entries of several ranks add up.
  void fill(std::span<const double> values)
  {
    int *begin = nullptr, *column = nullptr;
    double *entries = nullptr;
    check(own_->ExtractCrsDataPointers(begin, column, entries),
          "filling the matrix");
    std::copy(values.begin(), values.end(), entries);
    check(A_.PutScalar(0.), "filling the matrix");
    check(A_.Export(*own_, exporter_, Add), "filling the matrix");
  }

  void set_right_side(std::span<const double> right_side)
  {
    std::copy(right_side.begin(), right_side.end(), b_.Values());
    check(x_.PutScalar(0.), "filling the solution");
  }

  void read(std::span<double> solution) const
  {
    std::copy(x_.Values(), x_.Values() + solution.size(), solution.begin());
  }

  const LinearSystem &system_;
  Epetra_MpiComm communicator_;
  Epetra_Map rows_;
  std::vector<int> touched_;
  Epetra_Map touched_map_; ///< a row may be on several ranks
  Epetra_Export exporter_;
  std::unique_ptr<Epetra_CrsMatrix> own_; ///< this rank's entries, not summed
  Epetra_CrsMatrix A_;
  Epetra_Vector b_, x_;
  Epetra_LinearProblem problem_;

private:
  void create_matrix()
  {
    const SparseRows &pattern = system_.pattern;
    // With all columns in order, entries stand as in the pattern.
    const std::vector<int> columns = all_numbers(pattern.size());
    const Epetra_Map column_map(
        -1, pattern.size(), columns.data(), 0, communicator_);
    std::vector<int> lengths;
    for (const int row : touched_)
      lengths.push_back(pattern.begin[row + 1] - pattern.begin[row]);
    own_ = std::make_unique<Epetra_CrsMatrix>(
        Copy, touched_map_, column_map, lengths.data(), true);
    const std::vector<double> zeros(pattern.size(), 0.);
    for (std::size_t i = 0; i < touched_.size(); ++i)
      check(own_->InsertGlobalValues(touched_[i],
                                     lengths[i],
                                     zeros.data(),
                                     pattern.column.data() +
                                         pattern.begin[touched_[i]]),
            "creating the matrix");
    check(own_->FillComplete(rows_, rows_), "creating the matrix");
    check(own_->OptimizeStorage(), "creating the matrix");
    check(A_.Export(*own_, exporter_, Add), "creating the matrix");
    check(A_.FillComplete(), "creating the matrix");
    check(A_.OptimizeStorage(), "creating the matrix");
  }
};

class TrilinosDirect : public TrilinosSolver
{
public:
  using TrilinosSolver::TrilinosSolver;

  bool factorise(std::span<const double> values, bool /*symmetric*/) override
  {
    fill(values);
    if (!solver_)
      set_up_solver();
    const bool good = system_.ranks.all(solver_->NumericFactorization() == 0);
    if (!good) // which MUMPS keeps; a new instance does not
      solver_.reset();
    return good;
  }

  bool solve(std::span<const double> right_side,
             std::span<double> solution) override
  {
    set_right_side(right_side);
    const bool good = solver_->Solve() == 0;
    read(solution);
    return good;
  }

  unsigned iterations() const override { return 1; }

private:
  void set_up_solver()
  {
    solver_ = std::make_unique<Amesos_Mumps>(problem_);
    Teuchos::ParameterList parameters;
    parameters.set("MaxProcs", -3); // all
    parameters.set("OutputLevel", 0);
    check(solver_->SetParameters(parameters), "setting up MUMPS");
    // The analysis must see the pattern only: no permutation by values (6).
    // Room for pivoting (14). MUMPS chooses the ordering by the pattern.
    solver_->SetICNTL(6, 0);
    solver_->SetICNTL(14, 100);
    check(solver_->SymbolicFactorization(), "analysing the matrix");
  }

  std::unique_ptr<Amesos_Mumps> solver_;
};

/// Conjugate gradients or GMRES, with smoothed aggregation.
class TrilinosMultigrid : public TrilinosSolver
{
public:
  explicit TrilinosMultigrid(const LinearSystem &system)
      : TrilinosSolver(system)
  {
    const Share &rows = system.rows;
    for (const std::vector<double> &mode : system.rigid_modes)
      modes_.insert(
          modes_.end(), mode.begin() + rows.begin, mode.begin() + rows.end);
    ML_Epetra::SetDefaults("SA", parameters_);
    parameters_.set("ML output", 0);
    parameters_.set("PDE equations", static_cast<int>(system.block));
    if (system.rigid_modes.empty())
      return;
    parameters_.set("null space: type", "pre-computed");
    parameters_.set("null space: dimension",
                    static_cast<int>(system.rigid_modes.size()));
    parameters_.set("null space: vectors", modes_.data());
    parameters_.set("null space: add default vectors", false);
  }

  bool factorise(std::span<const double> values, bool symmetric) override
  {
    fill(values);
    symmetric_ = symmetric;
    preconditioner_.reset();
    ML_set_random_seed(1); // else it goes on where the last matrix ended
    preconditioner_ = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
        A_, parameters_, false);
    return preconditioner_->ComputePreconditioner() == 0;
  }

  bool solve(std::span<const double> right_side,
             std::span<double> solution) override
  {
    // Conjugate gradients fail if the matrix is not positive definite.
    const bool good = (symmetric_ && iterate(AZ_cg, right_side)) ||
                      iterate(AZ_gmres, right_side);
    read(solution);
    return good;
  }

  unsigned iterations() const override { return iterations_; }

private:
  bool iterate(int method, std::span<const double> right_side)
  {
    constexpr int restart = 100;
    set_right_side(right_side);
    iterations_ = 0;
    double size = 0;
    check(b_.Norm2(&size), "iterating");
    if (size == 0)
      return true;
    AztecOO solver(problem_);
    check(solver.SetPrecOperator(preconditioner_.get()), "iterating");
    solver.SetAztecOption(AZ_solver, method);
    solver.SetAztecOption(AZ_kspace, restart);
    solver.SetAztecOption(AZ_conv, AZ_rhs);
    solver.SetAztecOption(AZ_output, AZ_none);
    solver.Iterate(static_cast<int>(system_.settings.maximum_iterations),
                   system_.settings.tolerance);
    iterations_ = static_cast<unsigned>(solver.NumIters());
    return solver.GetAztecStatus()[AZ_why] == AZ_normal;
  }

  Teuchos::ParameterList parameters_;
  std::vector<double> modes_; ///< one after another, this rank's rows
  std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> preconditioner_;
  bool symmetric_ = false;
  unsigned iterations_ = 0;
};
} // namespace

std::unique_ptr<LinearSolver::Backend>
trilinos_direct(const LinearSystem &system)
{
  return std::make_unique<TrilinosDirect>(system);
}

std::unique_ptr<LinearSolver::Backend>
trilinos_multigrid(const LinearSystem &system)
{
  return std::make_unique<TrilinosMultigrid>(system);
}
} // namespace tamp::fem
