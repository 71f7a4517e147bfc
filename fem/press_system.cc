// SPDX-License-Identifier: BSD-3-Clause
#include <fem/dot.h>
#include <fem/press_system.h>

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
namespace
{
/// This share of the mean diagonal is added to it: a body that no tool holds
/// stays where it is. The equations' right side, and so their answer, is
/// untouched: only the way there is.
constexpr double grounding = 1e-10;

/// A loaded tool is held by nothing if its stiffness is less than this share of
/// friction over slip.
constexpr double unheld = 1e-6;

/// Rigid displacements and rotations that the mesh's section knows, zero where
/// a node is held.
std::vector<std::vector<double>> rigid_modes(const Mesh &mesh,
                                             const std::vector<char> &held)
{
  std::vector<std::vector<double>> modes;
  const auto add = [&](auto displacement) {
    std::vector<double> mode(mesh.number_of_dofs(), 0.);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      const dealii::Tensor<1, 3> u = displacement(mesh.nodes[node]);
      for (unsigned c = 0; c < mesh.components(); ++c)
        if (!held[mesh.dof(node, c)])
          mode[mesh.dof(node, c)] = u[mesh.axis(c)];
    }
    modes.push_back(std::move(mode));
  };
  for (unsigned c = 0; c < mesh.components(); ++c)
    add([&](const auto &) {
      dealii::Tensor<1, 3> u;
      u[mesh.axis(c)] = 1;
      return u;
    });
  for (unsigned turn = 0; turn < 3; ++turn) {
    if (mesh.is_axisymmetric() && turn != 1)
      continue;
    add([&](const auto &x) {
      dealii::Tensor<1, 3> axis;
      axis[turn] = 1;
      return dealii::cross_product_3d(axis, x);
    });
  }
  return modes;
}

/// What `automatic` means for a mesh: direct solvers win in the plane, and in
/// three dimensions as long as there are few unknowns.
LinearSettings decided(LinearSettings settings, const Mesh &mesh)
{
  constexpr std::size_t many = 20000;
  if (settings.method == LinearMethod::automatic)
    settings.method = !mesh.is_axisymmetric() && mesh.number_of_dofs() > many
                          ? LinearMethod::iterative
                          : LinearMethod::direct;
  return settings;
}

std::vector<char> held_dofs(const Mesh &mesh)
{
  std::vector<char> held(mesh.number_of_dofs(), 0);
  for (const Mesh::Held &h : mesh.held)
    for (unsigned c = 0; c < mesh.components(); ++c)
      if (mesh.axis(c) == h.axis)
        held[mesh.dof(h.node, c)] = 1;
  return held;
}

/// Nodes whose first cell is in this rank's share.
std::vector<char> owned_nodes(const Mesh &mesh, const Ranks &ranks)
{
  const Share share = ranks.share(mesh.number_of_cells());
  std::vector<char> seen(mesh.nodes.size(), 0), owned(mesh.nodes.size(), 0);
  for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
    for (unsigned a = 0; a < mesh.nodes_per_cell(); ++a) {
      const unsigned node = mesh.nodes_of_cell(cell)[a];
      if (!seen[node])
        owned[node] = share.holds(cell);
      seen[node] = 1;
    }
  return owned;
}

/// Do they differ by little?
bool are_alike(const std::vector<ContactBlock> &a,
               const std::vector<ContactBlock> &b)
{
  constexpr double little = 1e-6; // contact is 1e3 times stiffer than powder
  const auto alike = [](const ContactBlock &x, const ContactBlock &y) {
    return x.node == y.node && x.tool == y.tool && x.status == y.status &&
           (x.stiffness - y.stiffness).norm() <= little * y.stiffness.norm();
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), alike);
}
} // namespace

PressSystem::PressSystem(const Mesh &mesh,
                         const Assembler &assembler,
                         const LinearSettings &settings,
                         const Ranks &ranks)
    : mesh_(mesh), ranks_(ranks), matrix_(assembler.pattern()),
      held_(held_dofs(mesh)), owned_(owned_nodes(mesh, ranks)),
      solver_(matrix_,
              decided(settings, mesh),
              ranks,
              decided(settings, mesh).method == LinearMethod::iterative
                  ? rigid_modes(mesh, held_)
                  : std::vector<std::vector<double>>())
{
}

std::vector<char> PressSystem::free_unknowns(
    const std::array<bool, number_of_tools> &loaded) const
{
  std::vector<char> result(number_of_unknowns(mesh_), 0);
  for (std::size_t dof = 0; dof < held_.size(); ++dof)
    result[dof] = !held_[dof];
  for (const Tool tool : {upper_punch, lower_punch, die_wall})
    result[tool_dof(mesh_, tool)] = loaded[tool];
  return result;
}

void PressSystem::fill(const SparseRows &stiffness,
                       const std::vector<ContactBlock> &contacts)
{
  matrix_.value = stiffness.value;
  for (const ContactBlock &contact : contacts)
    if (owned_[contact.node])
      for (unsigned c = 0; c < mesh_.components(); ++c)
        for (unsigned d = 0; d < mesh_.components(); ++d)
          matrix_.at(static_cast<int>(mesh_.dof(contact.node, c)),
                     static_cast<int>(mesh_.dof(contact.node, d))) +=
              contact.stiffness[mesh_.axis(c)][mesh_.axis(d)];
  std::vector<double> mean{0, 0};
  for (int row = 0; row < matrix_.size(); ++row)
    if (owned_[row / mesh_.components()]) {
      mean[0] += std::abs(stiffness.at(row, row));
      mean[1] += 1;
    }
  ranks_.sum(mean);
  const double scale = mean[0] / mean[1];
  for (int row = 0; row < matrix_.size(); ++row) {
    const bool owned = owned_[row / mesh_.components()] != 0;
    for (int k = matrix_.begin[row]; k < matrix_.begin[row + 1]; ++k) {
      const int column = matrix_.column[k];
      if (held_[row] || held_[column])
        matrix_.value[k] = row == column && owned ? scale : 0;
      else if (row == column && owned)
        matrix_.value[k] += grounding * scale;
    }
  }
}

bool PressSystem::border(const std::vector<ContactBlock> &contacts)
{
  dealii::Tensor<2, 3> schur;
  dealii::Tensor<1, 3> secant;
  for (unsigned i = 0; i < 3; ++i) {
    answers_[i].clear();
    rows_[i].clear();
    schur[i][i] = 1;
    if (!loaded_[i])
      continue;
    std::vector<double> column(mesh_.number_of_dofs(), 0.);
    rows_[i] = column;
    schur[i][i] = 0;
    for (const ContactBlock &contact : contacts) {
      if (tool_dof(mesh_, contact.tool) != tool_dof(mesh_, i))
        continue;
      schur[i][i] += contact.stiffness[2][2];
      secant[i] += contact.secant;
      for (unsigned c = 0; c < mesh_.components(); ++c) {
        const std::size_t dof = mesh_.dof(contact.node, c);
        if (held_[dof])
          continue;
        column[dof] -= contact.stiffness[mesh_.axis(c)][2];
        rows_[i][dof] -= contact.stiffness[2][mesh_.axis(c)];
      }
    }
    answers_[i].resize(column.size());
    if (!solver_.solve(column, answers_[i]))
      return false;
  }
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      if (loaded_[i] && loaded_[j])
        schur[i][j] -= dot(rows_[i], answers_[j]);
  // Where all nodes slip nothing holds a loaded tool: it goes back by as much
  // as they slip, until some stick.
  for (unsigned i = 0; i < 3; ++i)
    if (loaded_[i] && std::abs(schur[i][i]) < unheld * secant[i])
      schur[i][i] = secant[i];
  if (!(std::abs(dealii::determinant(schur)) > 0))
    return false;
  inverse_schur_ = dealii::invert(schur);
  return true;
}

bool PressSystem::factorise(const SparseRows &stiffness,
                            const std::vector<ContactBlock> &contacts,
                            const std::array<bool, number_of_tools> &loaded)
{
  if (factored_ && loaded == loaded_ && are_alike(contacts, contacts_))
    return true;
  contacts_ = contacts;
  loaded_ = loaded;
  fill(stiffness, contacts);
  factored_ = solver_.factorise(matrix_.value) && border(contacts);
  return factored_;
}

bool PressSystem::solve(std::span<const double> right, std::span<double> change)
{
  const std::size_t nodes = mesh_.number_of_dofs();
  std::vector<double> rest(right.begin(), right.begin() + nodes);
  for (std::size_t dof = 0; dof < nodes; ++dof)
    if (held_[dof])
      rest[dof] = 0;
  if (!solver_.solve(rest, change.first(nodes)))
    return false;
  dealii::Tensor<1, 3> tools;
  for (unsigned i = 0; i < 3; ++i)
    if (loaded_[i])
      tools[i] = right[nodes + i] - dot(rows_[i], change.first(nodes));
  tools = inverse_schur_ * tools;
  for (unsigned i = 0; i < 3; ++i)
    for (std::size_t dof = 0; dof < answers_[i].size(); ++dof)
      change[dof] -= answers_[i][dof] * tools[i];
  for (unsigned tool = 0; tool < number_of_tools; ++tool)
    change[nodes + tool] = tool < 3 && loaded_[tool] ? tools[tool] : 0;
  return std::all_of(change.begin(), change.end(), [](double value) {
    return std::isfinite(value);
  });
}

std::vector<double>
PressSystem::multiply_powder(const SparseRows &stiffness,
                             std::span<const double> change) const
{
  std::vector<double> force = multiply(stiffness, change);
  ranks_.sum(force);
  return force;
}
} // namespace tamp::fem
