// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_opening_h
#define fem_opening_h

#include <fem/compact.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace tamp::fem
{
/// How far material points may be unloaded by a step without having opened.
struct OpeningLimits {
  /// Share of its pressure that the step leaves to a point: all of it but for
  /// what the tools give way [-].
  double kept_pressure = 1;
  /// Points that bear less than this are not judged by their pressure [Pa].
  double least_pressure = 0;
  /// Mean strain by which the punches part [-].
  double parting = 0;
  /// Relative densities of all points of the die before it left them room, if
  /// they may not grow much since; empty: they may.
  std::span<const double> densities = {};
};

/// A point that opens.
struct Opening {
  std::size_t point = 0;
  std::string reason; ///< what it lost, with numbers
};

/// Finds the point that opens most in the trial, if any does: that bears less
/// than 0.3 of the pressure left to it, grows by more than 2e-3 in the step
/// beyond twice what the punches part, or by more than 5 % since it had those
/// densities. Zero stress is an equilibrium of grains that have parted, however
/// far, and no residual tells it from that of the compact. Collective.
std::optional<Opening> find_opening(const Compact &compact,
                                    const OpeningLimits &limits);
} // namespace tamp::fem

#endif
