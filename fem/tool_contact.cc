// SPDX-License-Identifier: BSD-3-Clause
#include <fem/assembler.h>
#include <fem/tool_contact.h>

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
struct ToolContact::System {
  std::vector<int> unknown; ///< of each degree of freedom; -1: prescribed
  SparseRows matrix;
  std::unique_ptr<LinearSolver> solver;
  /// Contacts the factors were made for; empty: no factors.
  std::vector<WallContact> factored;

  System(const DieMesh::Data &mesh, bool upper_is_loaded);
};

namespace
{
std::vector<int> number_unknowns(const DieMesh::Data &mesh,
                                 bool upper_is_loaded)
{
  std::vector<int> unknown(mesh.number_of_dofs(), 0);
  for (const unsigned node : mesh.axis)
    unknown[2 * node] = -1;
  for (const unsigned node : mesh.wall)
    unknown[2 * node] = -1;
  for (const unsigned node : mesh.punch_bottom)
    unknown[2 * node + 1] = -1;
  for (const unsigned node : mesh.punch_top)
    unknown[2 * node + 1] = -1;
  int count = 0;
  for (int &number : unknown)
    if (number >= 0)
      number = count++;
  if (upper_is_loaded)
    for (const unsigned node : mesh.punch_top)
      unknown[2 * node + 1] = count;
  return unknown;
}
} // namespace

ToolContact::System::System(const DieMesh::Data &mesh, bool upper_is_loaded)
    : unknown(number_unknowns(mesh, upper_is_loaded))
{
  const int count = *std::max_element(unknown.begin(), unknown.end()) + 1;
  std::vector<std::set<int>> columns(count);
  const SparseRows full = stiffness_pattern(mesh);
  for (int row = 0; row < full.size(); ++row)
    for (int k = full.begin[row]; k < full.begin[row + 1]; ++k)
      if (unknown[row] >= 0 && unknown[full.column[k]] >= 0)
        columns[unknown[row]].insert(unknown[full.column[k]]);
  // A wall node that slips adds the row of its normal force to its vertical
  // one: the same nodes, but the wall's own r is no unknown, so it is in.
  matrix = SparseRows(columns);
  if (count > 0)
    solver = std::make_unique<LinearSolver>(matrix);
}

ToolContact::ToolContact(const DieMesh::Data &mesh, double friction_coefficient)
    : mesh_(mesh), friction_coefficient_(friction_coefficient)
{
}

ToolContact::~ToolContact() = default;

ToolContact::System &ToolContact::system() const
{
  return motion_.upper_is_loaded ? *loaded_ : *moved_;
}

void ToolContact::forget_factors()
{
  for (const auto *system : {&moved_, &loaded_})
    if (*system)
      (*system)->factored.clear();
}

void ToolContact::begin(const SparseRows &stiffness,
                        const PunchMotion &motion,
                        std::span<const double> committed_friction)
{
  motion_ = motion;
  committed_friction_.assign(committed_friction.begin(),
                             committed_friction.end());
  auto &system = motion.upper_is_loaded ? loaded_ : moved_;
  if (!system)
    system = std::make_unique<System>(mesh_, motion.upper_is_loaded);
  forget_factors();
  double largest = 0;
  stick_stiffness_.clear();
  for (const unsigned node : mesh_.wall) {
    const int dof = 2 * static_cast<int>(node) + 1;
    stick_stiffness_.push_back(3 * std::abs(stiffness.at(dof, dof)));
    largest = std::max(largest, stick_stiffness_.back());
  }
  for (double &value : stick_stiffness_)
    value = std::max(value, 1e-3 * largest);
}

void ToolContact::prescribe(const PunchMotion &motion,
                            Displacement &increment) const
{
  for (const unsigned node : mesh_.axis)
    increment[2 * node] = 0;
  for (const unsigned node : mesh_.wall)
    increment[2 * node] = 0;
  for (const unsigned node : mesh_.punch_bottom)
    increment[2 * node + 1] = motion.lower;
  for (const unsigned node : mesh_.punch_top)
    increment[2 * node + 1] = motion.upper;
}

ToolForces ToolContact::forces(std::span<const double> internal,
                               std::span<const double> increment) const
{
  ToolForces result;
  double squares = 0;
  for (std::size_t i = 0; i < mesh_.wall.size(); ++i) {
    const unsigned node = mesh_.wall[i];
    const double normal = -internal[2 * node];
    result.wall.push_back(wall_friction(committed_friction_[i],
                                        increment[2 * node + 1],
                                        stick_stiffness_[i],
                                        friction_coefficient_ * normal));
    result.wall_friction += result.wall.back().friction;
    result.wall_normal += normal;
    squares += normal * normal;
  }
  for (const unsigned node : mesh_.punch_top) {
    result.upper -= internal[2 * node + 1];
    squares += internal[2 * node + 1] * internal[2 * node + 1];
  }
  for (const unsigned node : mesh_.punch_bottom) {
    result.lower += internal[2 * node + 1];
    squares += internal[2 * node + 1] * internal[2 * node + 1];
  }
  // The wall's friction on a corner node is no force of the punch.
  result.upper += result.wall.back().friction;
  result.lower -= result.wall.front().friction;
  result.reactions = std::sqrt(squares);
  return result;
}

std::vector<double> ToolContact::imbalance(std::span<const double> internal,
                                           const ToolForces &forces) const
{
  const System &unknowns = system();
  std::vector<double> result(internal.begin(), internal.end());
  for (std::size_t i = 0; i < mesh_.wall.size(); ++i)
    result[2 * mesh_.wall[i] + 1] -= forces.wall[i].friction;
  for (const unsigned node : mesh_.punch_top)
    result[2 * node + 1] = 0;
  for (std::size_t dof = 0; dof < result.size(); ++dof)
    if (unknowns.unknown[dof] < 0)
      result[dof] = 0;
  if (motion_.upper_is_loaded)
    result[2 * mesh_.punch_top.front() + 1] =
        motion_.upper_force - forces.upper;
  return result;
}

void ToolContact::fill(const SparseRows &stiffness,
                       const std::vector<WallForce> &wall,
                       System &unknowns) const
{
  SparseRows &matrix = unknowns.matrix;
  std::fill(matrix.value.begin(), matrix.value.end(), 0.);
  const auto add_row = [&](int to, int from, double factor) {
    for (int k = stiffness.begin[from]; k < stiffness.begin[from + 1]; ++k) {
      const int column = unknowns.unknown[stiffness.column[k]];
      if (column >= 0)
        matrix.at(to, column) += factor * stiffness.value[k];
    }
  };
  for (int dof = 0; dof < stiffness.size(); ++dof)
    if (unknowns.unknown[dof] >= 0)
      add_row(unknowns.unknown[dof], dof, 1);
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const int normal = 2 * static_cast<int>(mesh_.wall[i]);
    const int row = unknowns.unknown[normal + 1];
    if (row < 0)
      continue;
    if (wall[i].contact == WallContact::stick)
      matrix.at(row, row) += stick_stiffness_[i];
    else if (wall[i].contact == WallContact::slips_down)
      add_row(row, normal, friction_coefficient_);
    else if (wall[i].contact == WallContact::slips_up)
      add_row(row, normal, -friction_coefficient_);
  }
}

bool ToolContact::prepare(const SparseRows &stiffness,
                          const std::vector<WallForce> &wall,
                          System &unknowns)
{
  std::vector<WallContact> contacts;
  for (const WallForce &force : wall)
    contacts.push_back(force.contact);
  if (contacts == unknowns.factored)
    return true;
  unknowns.factored.clear();
  fill(stiffness, wall, unknowns);
  if (!unknowns.solver->factorise(unknowns.matrix.value))
    return false;
  unknowns.factored = contacts;
  return true;
}

std::vector<double> ToolContact::balance(const SparseRows &stiffness,
                                         std::span<const double> internal,
                                         std::span<const double> increment,
                                         double smallest_reference)
{
  constexpr unsigned most = 40, undamped = 15;
  constexpr double tolerance = 1e-9;
  System &unknowns = system();
  const std::size_t size = increment.size();
  std::vector<double> change(size, 0.), total(increment.begin(),
                                              increment.end());
  if (!unknowns.solver)
    return change; // every node is held by a tool
  std::vector<double> force(internal.begin(), internal.end());
  std::vector<double> right(unknowns.matrix.size()), step(right.size());
  for (unsigned iteration = 0; iteration < most; ++iteration) {
    const ToolForces tools = forces(force, total);
    const std::vector<double> rest = imbalance(force, tools);
    double squares = 0;
    std::fill(right.begin(), right.end(), 0.);
    for (std::size_t dof = 0; dof < size; ++dof)
      if (unknowns.unknown[dof] >= 0) {
        right[unknowns.unknown[dof]] -= rest[dof];
        squares += rest[dof] * rest[dof];
      }
    // One solution at least: its size is a measure of the error.
    if (iteration > 0 &&
        std::sqrt(squares) <=
            tolerance * std::max(tools.reactions, smallest_reference))
      return change;
    if (!prepare(stiffness, tools.wall, unknowns) ||
        !unknowns.solver->solve(right, step))
      return {};
    // Stick and slip may alternate for ever; shorter steps end that.
    const double length = iteration < undamped ? 1 : 0.5;
    for (std::size_t dof = 0; dof < size; ++dof)
      if (unknowns.unknown[dof] >= 0)
        change[dof] += length * step[unknowns.unknown[dof]];
    force = multiply(stiffness, change);
    for (std::size_t dof = 0; dof < size; ++dof) {
      force[dof] += internal[dof];
      total[dof] = increment[dof] + change[dof];
    }
  }
  return {};
}
} // namespace tamp::fem
