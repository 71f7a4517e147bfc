// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_benchmark_peers_peer_cell_h
#define tests_benchmark_peers_peer_cell_h

#include <dem/unit_cell.h>

#include <string>

namespace tamp::speed
{
/// The number that a word stands for; throws std::invalid_argument if it stands
/// for none.
double number(const std::string &text);

/// Grains of the peers' case at rest without contact history: Hertz's normal
/// and Mindlin's tangential law, 70 MPa, Poisson's ratio 0.3, 2650 kg/m3; the
/// scripts give the same to the peers.
/// @param file      a line "# L lx ly lz", then a line "x y z r" per grain [m]
/// @param friction  coefficient [-]
dem::UnitCell read_peer_cell(const std::string &file, double friction);
} // namespace tamp::speed

#endif
