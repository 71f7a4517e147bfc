// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_contact_network_h
#define dem_contact_network_h

#include <dem/contact_stiffness.h>
#include <dem/tensors.h>

#include <Eigen/SparseCore>

#include <vector>

namespace tamp::dem
{
class UnitCell;

/// What the contacts of a linear network do.
struct NetworkChoice {
  ContactSlope slope = ContactSlope::loading;
  /// Whether contacts on Coulomb's cap go on sliding; if not, all stick. With
  /// sliding the network is no longer symmetric.
  bool sliding = false;
  /// Share of k_t that a sliding contact keeps across its slip: mu N over the
  /// length the tangential force would have without the cap. 1 for a small
  /// increment, less the longer the slip of the increment [-].
  double kept_across = 1;
  /// Whether normal forces turn with their contacts (geometric stiffness
  /// -N/d across the contact); if not, geometry is that of the cell.
  bool turning = false;
  double accuracy = 1e-8; ///< of the balance, over the affine forces [-]

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// What a linear network does under a macroscopic displacement gradient.
struct NetworkResponse {
  /// Of the contact forces over the branches and the volume of the cell, not
  /// symmetrised [Pa].
  Matrix3 stress_change = Matrix3::Zero();
  Eigen::VectorXd motion; ///< per grain: non-affine displacement, radius x
                          ///< rotation [m]
};

/// The contacts of a cell as springs between grains that displace and rotate.
/// A contact answers the relative displacement of its surfaces du [m],
///   du = u_j - u_i + L l - d/(R_i + R_j) (R_i phi_i + R_j phi_j) x n,
/// with df = D du on the first grain; D = k_n nn + k_t (I - nn) where it
/// sticks, D = k_n (nn - mu t n) + k_t (I - nn - tt) where it slides along t:
/// the cap on its length lets a tangential force still turn across t.
///
/// Held by no contact are the sample as a whole, rattlers, and grains that can
/// roll about an axis through two contacts. Springs to the ground of 1e-9 of
/// the mean stiffness keep these at rest.
/// Source: Agnolin & Roux (2007), Phys. Rev. E 76:061304.
class ContactNetwork
{
public:
  ContactNetwork(const UnitCell &cell, const NetworkChoice &choice);

  /// Lets all grains find their balance under each gradient L [-]. Empty if
  /// there is no balance to find: the network is unstable.
  [[nodiscard]] std::vector<NetworkResponse>
  respond(const std::vector<Matrix3> &gradients) const;

private:
  using Columns = Eigen::MatrixXd; // one for each gradient
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// L l of every contact.
  Columns affine(const std::vector<Matrix3> &gradients) const;

  double accuracy_;
  bool symmetric_ = true;
  int rows_;                      // of a contact: 3, with turning 6
  double volume_;                 // [m3]
  std::vector<Vector3> branches_; // [m]
  Matrix motion_, transposed_;    // from grains to contacts, and back
  Matrix stiffness_;              // of the contacts [N/m]
  Matrix balance_;                // of the grains [N/m]
};
} // namespace tamp::dem

#endif
