// SPDX-License-Identifier: BSD-3-Clause
#include <dem/balance_solver.h>
#include <dem/contact_network.h>
#include <dem/measures.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

namespace tamp::dem
{
namespace
{
using Triplets = std::vector<Eigen::Triplet<double>>;
constexpr double ground = 1e-9; // springs to the ground, over the mean

/// The matrix of v -> a x v.
Matrix3 cross_matrix(const Vector3 &a)
{
  Matrix3 result;
  result << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return result;
}

void add(Triplets &triplets, int row, int column, const Matrix3 &block)
{
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (block(a, b) != 0)
        triplets.emplace_back(row + a, column + b, block(a, b));
}

/// How the relative displacement of a contact's surfaces follows its grains
/// and, with turning, that of their centres in three more rows.
void add_motion(Triplets &triplets,
                int row,
                const UnitCell &cell,
                const ContactForce &contact,
                bool turning)
{
  const auto [i, j] = contact.pair;
  const Matrix3 arm =
      cross_matrix(contact.branch) / (cell.radius[i] + cell.radius[j]);
  for (const int start : {row, row + 3}) {
    if (start != row && !turning)
      break;
    add(triplets, start, 6 * int(i), -Matrix3::Identity());
    add(triplets, start, 6 * int(j), Matrix3::Identity());
  }
  add(triplets, row, 6 * int(i) + 3, arm);
  add(triplets, row, 6 * int(j) + 3, arm);
}

/// D, see ContactNetwork.
Matrix3 contact_matrix(const ContactStiffness &k,
                       const ContactForce &contact,
                       const NetworkChoice &choice)
{
  const Vector3 n = contact.branch.normalized();
  const Matrix3 normal = n * n.transpose();
  Matrix3 across = Matrix3::Identity() - normal;
  const double friction = contact.tangential_force.norm();
  if (!choice.sliding || !contact.sliding || friction <= 0)
    return k.normal * normal + k.tangential * across;
  const Vector3 t = contact.tangential_force / friction;
  across -= t * t.transpose();
  return k.normal * (n - k.friction * t) * n.transpose() +
         choice.kept_across * k.tangential * across;
}

Matrix3 turning_matrix(const ContactForce &contact)
{
  const double d = contact.branch.norm();
  const Vector3 n = contact.branch / d;
  return -contact.normal_force / d * (Matrix3::Identity() - n * n.transpose());
}
} // namespace

void NetworkChoice::check() const
{
  if (!(kept_across >= 0 && kept_across <= 1))
    refuse("kept across", kept_across, "between 0 and 1");
  if (!(accuracy > 0 && accuracy < 1))
    refuse("accuracy of the balance", accuracy, "between 0 and 1");
}

ContactNetwork::ContactNetwork(const UnitCell &cell,
                               const NetworkChoice &choice)
    : accuracy_(choice.accuracy), rows_(choice.turning ? 6 : 3),
      volume_(cell.box.volume())
{
  choice.check();
  const std::vector<ContactForce> contacts = contact_forces(cell);
  const std::vector<ContactStiffness> springs =
      contact_stiffness(cell, contacts, choice.slope);
  Triplets motion, stiffness;
  int row = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c, row += rows_) {
    const ContactForce &contact = contacts[c];
    symmetric_ = symmetric_ && !(choice.sliding && contact.sliding);
    add_motion(motion, row, cell, contact, choice.turning);
    add(stiffness, row, row, contact_matrix(springs[c], contact, choice));
    if (choice.turning)
      add(stiffness, row + 3, row + 3, turning_matrix(contact));
    branches_.push_back(contact.branch);
  }
  const int unknowns = 6 * int(cell.size());
  motion_.resize(row, unknowns);
  motion_.setFromTriplets(motion.begin(), motion.end());
  transposed_ = motion_.transpose();
  stiffness_.resize(row, row);
  stiffness_.setFromTriplets(stiffness.begin(), stiffness.end());
  balance_ = transposed_ * (stiffness_ * motion_);
  Matrix held(unknowns, unknowns);
  held.setIdentity();
  balance_ += ground * balance_.diagonal().mean() * held;
}

ContactNetwork::Columns
ContactNetwork::affine(const std::vector<Matrix3> &gradients) const
{
  Columns result(stiffness_.rows(), Eigen::Index(gradients.size()));
  for (std::size_t k = 0; k < gradients.size(); ++k) {
    Eigen::Index row = 0;
    for (const Vector3 &branch : branches_)
      for (int part = 0; part < rows_; part += 3, row += 3)
        result.col(Eigen::Index(k)).segment<3>(row) = gradients[k] * branch;
  }
  return result;
}

std::vector<NetworkResponse>
ContactNetwork::respond(const std::vector<Matrix3> &gradients) const
{
  const Columns moved = affine(gradients);
  const Columns affine_force = stiffness_ * moved;
  const Columns unbalanced = -(transposed_ * affine_force);
  const auto motion =
      solve_balance(balance_,
                    unbalanced,
                    symmetric_,
                    accuracy_ * affine_force.colwise().norm().transpose());
  if (!motion)
    return {};
  const Columns force = affine_force + stiffness_ * (motion_ * *motion);
  std::vector<NetworkResponse> result(gradients.size());
  for (std::size_t k = 0; k < gradients.size(); ++k) {
    const auto column = Eigen::Index(k);
    result[k].motion = motion->col(column);
    Eigen::Index row = 0;
    for (const Vector3 &branch : branches_)
      for (int part = 0; part < rows_; part += 3, row += 3)
        result[k].stress_change +=
            force.col(column).segment<3>(row) * branch.transpose() / volume_;
  }
  return result;
}
} // namespace tamp::dem
