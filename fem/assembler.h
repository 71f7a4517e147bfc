// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_assembler_h
#define fem_assembler_h

#include <fem/kinematics.h>
#include <fem/sparse_rows.h>

#include <span>
#include <vector>

namespace tamp::fem
{
/// Zero matrix over all degrees of freedom, with the pattern of the mesh.
SparseRows stiffness_pattern(const DieMesh::Data &mesh);

/// Forces that hold the Cauchy stress of the points, one per degree of freedom,
/// of the full circumference [N]: f_a = int sigma : grad N_a 2 pi r dA over the
/// geometry `positions`.
std::vector<double> internal_forces(const DieMesh::Data &mesh,
                                    const NodePositions &positions,
                                    std::span<const Response> responses);

/// Derivative of internal_forces() with respect to the displacement [N/m], from
/// the material tangents: consistent, hence unsymmetric,
/// d f = int [(C : eps + W sigma - sigma W) : G + sigma : G tr L
///            - (sigma L^T) : G] dv, with L = grad du, eps + W = L, G = grad N.
void assemble_stiffness(const DieMesh::Data &mesh,
                        const NodePositions &positions,
                        std::span<const Response> responses,
                        SparseRows &stiffness);
} // namespace tamp::fem

#endif
