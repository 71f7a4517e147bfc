// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_smooth_chain_h
#define fem_smooth_chain_h

#include <fem/profile.h>

#include <vector>

namespace tamp::fem
{
/// A smooth profile through the nodes of a chain, all of which it meets to
/// rounding (but is straight where it turns by less than 1e-9): between two
/// nodes two arcs with a common tangent, whose ends are tangents at the nodes.
/// A node at which the chain turns
///
/// - by less than 1e-3 is smooth;
/// - by more than 35 degrees is a corner and stays sharp;
/// - by less is smooth if the chain turns to the same side at a neighbour, too,
///   by a third as much at least: so turns the trace of a curve, and where it
///   joins a line. A turn that stands alone is a corner: of a bevel, a taper.
///
/// A smooth node's tangent is that of the circle through it and its two
/// neighbours, but of a straight line if one ends there. Nodes on a circle thus
/// give that circle, nodes on lines those lines, nodes on other curves them to
/// the third order of the spacing. At its ends the chain goes straight on.
/// Source of the arcs: K. M. Bolton, Biarc curves, Computer-Aided Design 7
/// (1975) 89-92, with tangents of equal lengths.
/// @param nodes  at least two; successive ones must differ [m]. The chain is
///               not closed.
/// Throws std::invalid_argument like the constructor of Profile.
Profile smooth_chain(const std::vector<Profile::Point> &nodes);
} // namespace tamp::fem

#endif
