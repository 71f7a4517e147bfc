// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_obstruction_h
#define dem_obstruction_h

#include <dem/contacts.h>

#include <span>
#include <vector>

namespace tamp::dem
{
/// Two grains that touch, and the way from the centre of the first to that of
/// the second [m].
struct Branch {
  Pair pair;
  Vector3 way = Vector3::Zero();
};

/// How far each contact goes through a third grain, 0 for open contacts to 1
/// for contacts that carry nothing.
///
/// Spheres that overlap much may touch behind a grain that lies between them.
/// In each triangle of grains that touch each other, the contact of the longest
/// side gets 1 / (1 + exp(-50 (alpha / pi - 1/2))), where alpha is the angle at
/// the third grain; the sum over its triangles is cut off at 1.
/// Source: Zunker et al. (2025), Powder Technol., 120972.
/// @param branches  in any order; no pair twice
/// @param grains    number of grains
std::vector<double> obstruction(std::span<const Branch> branches,
                                std::size_t grains);
} // namespace tamp::dem

#endif
