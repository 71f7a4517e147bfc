// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_compaction_equations_h
#define apps_fit_compaction_equations_h

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// An equation of compaction fitted to a curve.
struct CompactionFit {
  std::string name;     ///< as the user writes it, for example "heckel"
  std::string equation; ///< in the form that was fitted, with its source
  /// Names with units, and values in SI; not a number if none fits.
  std::vector<std::pair<std::string, double>> parameters = {};
  /// Share of the variance of the fitted ordinate that the equation explains.
  /// Ordinates differ: compare equations by density_error.
  double r_squared = 0;
  /// The points that were fitted [Pa].
  double lowest_pressure = 0, highest_pressure = 0;
  double density_error = 0; ///< root mean square over these points [-]
  /// What the equation says at every pressure of the curve, also outside that
  /// range; not a number where it says nothing.
  std::vector<double> fitted_density = {};
  std::string remark = {}; ///< what to mind, empty if there is nothing
};

/// Fits equations to the loading part of a compaction curve by linear least
/// squares in the form their authors used; every point counts alike. P is the
/// pressure, D the relative density, D_0 that before compaction:
///
/// - heckel: ln(1 / (1 - D)) = P / P_y + A (R. W. Heckel, 1961, Trans. Metall.
///   Soc. AIME 221:671), for its linear part alone: the part of the curve, of
///   at least five points if there are as many, that spans the largest
///   difference of pressure with r^2 >= 0.999; all of it if there is none;
/// - kawakita: P / C = P / a + 1 / (a b), C = 1 - D_0 / D (K. Kawakita and
/// K.-H.
///   Luedde, 1971, Powder Technol. 4:61);
/// - walker: 1 / D = V_1 - W ln(P / MPa) (E. E. Walker, 1923, Trans. Faraday
///   Soc. 19:73; his coefficient, per decade and in per cent, is 230.26 W);
/// - panelli-ambrosio: ln(1 / (1 - D)) = A sqrt(P) + B (R. Panelli and
///   F. Ambrozio Filho, 2001, Powder Technol. 114:255);
/// - adams: ln P = ln(tau / alpha) + alpha e + ln(1 - exp(-alpha e)), e = ln(D
/// /
///   D_0) (M. J. Adams, M. A. Mullier and J. P. K. Seville, 1994, Powder
///   Technol. 78:5): ln tau linearly, alpha by bisection of the slope of the
///   sum of squares.
///
/// kawakita and adams use the points with D > D_0.
/// @param pressure          rising, above zero [Pa]
/// @param relative_density  between zero and one [-]
/// @param initial_density   D_0 [-]
/// Throws std::invalid_argument for other values, fewer than three points, or
/// fewer than three of them with D > D_0.
std::vector<CompactionFit>
fit_compaction_equations(std::span<const double> pressure,
                         std::span<const double> relative_density,
                         double initial_density);
} // namespace tamp::apps

#endif
