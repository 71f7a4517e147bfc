// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/compaction_equations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_points = 3;
constexpr std::size_t fewest_of_part = 5;
constexpr double straight = 0.999; // r^2 of Heckel's linear part
using Values = std::vector<double>;

struct Curve {
  Values pressure, density;
  double initial_density;
};

/// y = slope x + level, by least squares.
struct Line {
  double slope = 0, level = 0, r_squared = 0;
};

double mean_of(std::span<const double> values)
{
  double sum = 0;
  for (const double value : values)
    sum += value;
  return sum / static_cast<double>(values.size());
}

Line fit_line(std::span<const double> x, std::span<const double> y)
{
  const double x_mean = mean_of(x), y_mean = mean_of(y);
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - x_mean, dy = y[i] - y_mean;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double slope = xy / xx;
  return {slope, y_mean - slope * x_mean, yy > 0 ? slope * xy / yy : none};
}

Values each(const Values &values, const std::function<double(double)> &f)
{
  Values result(values.size());
  std::ranges::transform(values, result.begin(), f);
  return result;
}

/// ln(1 / (1 - D)).
Values porosity_logarithms(const Curve &curve)
{
  return each(curve.density, [](double D) { return -std::log1p(-D); });
}

/// The points with D > D_0, those of equations that begin there.
Curve compacted(const Curve &curve)
{
  Curve part{{}, {}, curve.initial_density};
  for (std::size_t i = 0; i < curve.density.size(); ++i)
    if (curve.density[i] > curve.initial_density) {
      part.pressure.push_back(curve.pressure[i]);
      part.density.push_back(curve.density[i]);
    }
  return part;
}

/// What the law says along the curve, and how far off it is in its range.
void judge(CompactionFit &fit,
           const Curve &curve,
           const Values &fitted,
           const std::function<double(double)> &density)
{
  fit.lowest_pressure = fitted.front();
  fit.highest_pressure = fitted.back();
  fit.fitted_density = each(curve.pressure, [&](double P) {
    const double D = density(P);
    return D > 0 && D <= 1 ? D : none;
  });
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < curve.pressure.size(); ++i)
    if (std::ranges::binary_search(fitted, curve.pressure[i])) {
      sum += std::pow(fit.fitted_density[i] - curve.density[i], 2);
      ++count;
    }
  fit.density_error = std::sqrt(sum / count);
}

/// The part of the points with the largest span of x that a line fits well:
/// first point and number of points; none: {0, 0}.
std::pair<std::size_t, std::size_t> linear_part(std::span<const double> x,
                                                std::span<const double> y)
{
  const std::size_t fewest = std::min(fewest_of_part, x.size());
  std::pair<std::size_t, std::size_t> best{0, 0};
  double span = 0;
  for (std::size_t first = 0; first + fewest <= x.size(); ++first)
    for (std::size_t count = x.size() - first; count >= fewest; --count) {
      const double wide = x[first + count - 1] - x[first];
      if (!(wide > span))
        break;
      if (fit_line(x.subspan(first, count), y.subspan(first, count))
              .r_squared >= straight) {
        best = {first, count};
        span = wide;
      }
    }
  return best;
}

CompactionFit heckel(const Curve &curve)
{
  CompactionFit fit{"heckel", "ln(1/(1-D)) = P/P_y + A (Heckel 1961)"};
  const Values y = porosity_logarithms(curve);
  auto [first, count] = linear_part(curve.pressure, y);
  if (count == 0) {
    count = y.size();
    fit.remark = fmt::format("no part is straight with r^2 >= {}: all of the "
                             "curve was fitted",
                             straight);
  }
  const auto part = std::span(curve.pressure).subspan(first, count);
  const Line line = fit_line(part, std::span(y).subspan(first, count));
  fit.parameters = {{"mean_yield_pressure[Pa]", 1 / line.slope},
                    {"intercept[-]", line.level}};
  fit.r_squared = line.r_squared;
  judge(fit, curve, {part.begin(), part.end()}, [line](double P) {
    return -std::expm1(-(line.slope * P + line.level));
  });
  return fit;
}

CompactionFit kawakita(const Curve &curve)
{
  const Curve part = compacted(curve);
  CompactionFit fit{"kawakita",
                    "P/C = P/a + 1/(ab), C = 1 - D_0/D (Kawakita & Luedde "
                    "1971)"};
  Values y = part.pressure;
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] /= 1 - part.initial_density / part.density[i];
  const Line line = fit_line(part.pressure, y);
  fit.parameters = {{"a[-]", 1 / line.slope},
                    {"inverse_b[Pa]", line.level / line.slope}};
  fit.r_squared = line.r_squared;
  judge(fit, curve, part.pressure, [&](double P) {
    return curve.initial_density / (1 - P / (line.slope * P + line.level));
  });
  if (!(line.slope >= 1 && line.level > 0))
    fit.remark =
        "a is not between 0 and 1 or b is below zero: no curve of this "
        "equation";
  return fit;
}

CompactionFit walker(const Curve &curve)
{
  CompactionFit fit{"walker", "1/D = V_1 - W ln(P/MPa) (Walker 1923)"};
  const auto x = [](double P) { return std::log(P / 1e6); };
  const Line line =
      fit_line(each(curve.pressure, x),
               each(curve.density, [](double D) { return 1 / D; }));
  fit.parameters = {{"coefficient[-]", -line.slope},
                    {"relative_volume_at_1_MPa[-]", line.level}};
  fit.r_squared = line.r_squared;
  judge(fit, curve, curve.pressure, [&](double P) {
    return 1 / (line.slope * x(P) + line.level);
  });
  return fit;
}

CompactionFit panelli_ambrosio(const Curve &curve)
{
  CompactionFit fit{"panelli-ambrosio",
                    "ln(1/(1-D)) = A sqrt(P) + B (Panelli & Ambrozio Filho "
                    "2001)"};
  const Line line =
      fit_line(each(curve.pressure, [](double P) { return std::sqrt(P); }),
               porosity_logarithms(curve));
  fit.parameters = {{"slope[Pa^-0.5]", line.slope},
                    {"intercept[-]", line.level}};
  fit.r_squared = line.r_squared;
  judge(fit, curve, curve.pressure, [line](double P) {
    return -std::expm1(-(line.slope * std::sqrt(P) + line.level));
  });
  return fit;
}

/// ln(exp(alpha e) - 1), which is alpha e + ln(1 - exp(-alpha e)).
double adams_logarithm(double alpha, double strain)
{
  return alpha * strain + std::log(-std::expm1(-alpha * strain));
}

/// Half the slope over alpha of the sum of squares of what the equation leaves
/// of ln P, with the best tau for this alpha.
double adams_slope(double alpha, const Values &strain, const Values &log_P)
{
  Values rest = log_P, change = strain;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    rest[i] -= adams_logarithm(alpha, strain[i]);
    change[i] /= std::expm1(-alpha * strain[i]);
  }
  const double mean = mean_of(rest);
  double slope = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    slope += (rest[i] - mean) * change[i];
  return slope;
}

/// The alpha of the least sum of squares; not a number if the curve rises less
/// steeply than any.
double adams_alpha(const Values &strain, const Values &log_P)
{
  const double largest = std::ranges::max(strain);
  double low = 1e-6 / largest, high = low;
  if (adams_slope(low, strain, log_P) >= 0)
    return none;
  for (; adams_slope(high, strain, log_P) < 0; high *= 2)
    if (high * largest > 1e6)
      return none;
  while (true) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high))
      return middle;
    (adams_slope(middle, strain, log_P) < 0 ? low : high) = middle;
  }
}

CompactionFit adams(const Curve &curve)
{
  const Curve part = compacted(curve);
  CompactionFit fit{"adams",
                    "ln P = ln(tau/alpha) + alpha e + ln(1 - exp(-alpha e)), e "
                    "= ln(D/D_0) (Adams et al. 1994)"};
  const Values strain = each(part.density, [&](double D) {
    return std::log(D / curve.initial_density);
  });
  const Values log_P =
      each(part.pressure, [](double P) { return std::log(P); });
  const double alpha = adams_alpha(strain, log_P);
  if (std::isnan(alpha))
    fit.remark = "the pressure rises less steeply with strain than the "
                 "equation can";
  Values rest = log_P;
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] -= adams_logarithm(alpha, strain[i]);
  const double level = mean_of(rest), all = mean_of(log_P);
  double left = 0, whole = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    left += std::pow(rest[i] - level, 2);
    whole += std::pow(log_P[i] - all, 2);
  }
  fit.parameters = {{"apparent_strength[Pa]", alpha * std::exp(level)},
                    {"pressure_coefficient[-]", alpha}};
  fit.r_squared = 1 - left / whole;
  judge(fit, curve, part.pressure, [&](double P) {
    return curve.initial_density * std::pow(1 + P / std::exp(level), 1 / alpha);
  });
  return fit;
}

void check(const Curve &curve)
{
  const auto expect = [](bool good, double value, const char *expected) {
    if (!good)
      throw std::invalid_argument(fmt::format(
          "compaction curve: {:.6g}: expected {}", value, expected));
  };
  const auto &[pressure, density, initial] = curve;
  expect(pressure.size() == density.size(),
         static_cast<double>(density.size()),
         "as many densities as pressures");
  expect(initial > 0 && initial < 1,
         initial,
         "an initial relative density between 0 and 1");
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    expect(pressure[i] > (i == 0 ? 0 : pressure[i - 1]) &&
               std::isfinite(pressure[i]),
           pressure[i],
           "pressures above 0 Pa that rise");
    expect(density[i] > 0 && density[i] < 1,
           density[i],
           "relative densities between 0 and 1");
  }
  expect(pressure.size() >= fewest_points,
         static_cast<double>(pressure.size()),
         "at least three points");
  expect(compacted(curve).density.size() >= fewest_points,
         static_cast<double>(compacted(curve).density.size()),
         "at least three points above the initial density");
}
} // namespace

std::vector<CompactionFit>
fit_compaction_equations(std::span<const double> pressure,
                         std::span<const double> relative_density,
                         double initial_density)
{
  const Curve curve{{pressure.begin(), pressure.end()},
                    {relative_density.begin(), relative_density.end()},
                    initial_density};
  check(curve);
  return {heckel(curve),
          kawakita(curve),
          walker(curve),
          panelli_ambrosio(curve),
          adams(curve)};
}
} // namespace tamp::apps
