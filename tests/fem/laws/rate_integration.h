// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_laws_rate_integration_h
#define tests_fem_laws_rate_integration_h

#include <fem/laws/drucker_prager_cap.h>

#include <array>

namespace tamp::fem
{
/// The rate equations of the cap model for principal strains whose axes do not
/// turn, integrated explicitly in many small steps (Runge and Kutta, fourth
/// order). Independent of the return mapping: it shares the surface and its
/// flow, and takes slopes of the surface from differences.
class RateIntegration
{
public:
  /// Principal values, compression positive.
  using Three = std::array<double, 3>;

  explicit RateIntegration(const DruckerPragerCapParameters &parameters);

  /// Logarithmic strain, compression positive, in equal steps of at most `step`
  /// of its sum.
  void press(const Three &strain, double step);

  const Three &stress() const { return now_.stress; } ///< [Pa]
  double plastic_compaction() const { return now_.compaction; }

private:
  struct Point {
    Three stress{};
    double compaction = 0;
  };
  struct Rate {
    Point change;
    bool loading = false; ///< the elastic rate points out of the surface
  };

  static Point sum(const Point &point, const Point &change, double share);
  double yield(const Point &point) const;
  Rate rate(const Point &point, const Three &strain, bool plastic) const;
  Point step(const Point &point, const Three &strain, bool plastic) const;
  /// An elastic step up to the surface; says what share of it that was.
  double elastic_share(Point &point, const Three &strain) const;

  DruckerPragerCap law_;
  Point now_;
};
} // namespace tamp::fem

#endif
