// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_hill_mandel_h
#define dem_hill_mandel_h

#include <dem/measures.h>
#include <dem/tensors.h>
#include <dem/unit_cell.h>

#include <span>

namespace tamp::dem
{
/// How far the work of the contacts is from the work of the stress over an
/// increment: |micro - macro| / (1/V sum |f . du|) [-], with
/// micro = -1/V sum f . du, du the relative displacement of the two surfaces,
/// and macro = stress : G, G = I - U^-1. It vanishes at exact equilibrium.
/// @param cell    after the increment, with its forces
/// @param back    U^-1 of the increment
/// @param motion  per grain: non-affine displacement, radius x rotation [m]
/// @param least   what sum |f . du| counts as at least: there is none to
///                compare with where next to nothing is strained [J]
/// Source: Hill (1963), J. Mech. Phys. Solids 11:357, for discrete periodic
/// media.
double hill_mandel_residual(const UnitCell &cell,
                            std::span<const ContactForce> forces,
                            const Matrix3 &back,
                            std::span<const double> motion,
                            double least = 0);
} // namespace tamp::dem

#endif
