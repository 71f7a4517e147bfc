// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_tables_h
#define fem_laws_cap_tables_h

#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/strain_derivative.h>

#include <type_traits>

namespace tamp::fem
{
/// A value and its derivative by the plastic volumetric strain.
using ByCompaction = Sacado::Fad::SFad<double, 1>;

/// Moduli K and G [Pa].
template <class Number>
struct CapModuli {
  Number bulk, shear;
};

/// Reads the tables of a cap law at plastic volumetric strains, one close to
/// the other: keeps the lines between rows as long as they hold.
class CapTables
{
public:
  /// @param parameters  have to outlive this.
  explicit CapTables(const DruckerPragerCapParameters &parameters)
      : parameters_(parameters)
  {
  }

  CapSurface<ByCompaction> surface(double compaction);
  CapModuli<ByCompaction> moduli(double compaction);

private:
  /// A table and the line of it that was read last.
  struct Reader {
    const DensityTable &table;
    DensityTable::Line line;

    ByCompaction operator()(const ByCompaction &x)
    {
      if (!line.holds(x.val()))
        line = table.line(x.val());
      return line.value + line.slope * (x - line.place);
    }
  };

  ByCompaction density(const ByCompaction &compaction) const
  {
    return parameters_.reference_density * exp(compaction);
  }

  const DruckerPragerCapParameters &parameters_;
  Reader cohesion_{parameters_.cohesion, {}};
  Reader friction_angle_{parameters_.friction_angle, {}};
  Reader eccentricity_{parameters_.eccentricity, {}};
  Reader hardening_{parameters_.hardening, {}};
  Reader youngs_modulus_{parameters_.elasticity.youngs_modulus, {}};
  Reader poissons_ratio_{parameters_.elasticity.poissons_ratio, {}};
};

/// What depends on compaction at a compaction that has derivatives by other
/// things: its value is where the surface was read.
template <class Number>
Number carry(const ByCompaction &y, const Number &compaction)
{
  if constexpr (std::is_same_v<Number, double>)
    return y.val();
  else
    return Number(y.val() +
                  y.fastAccessDx(0) * (compaction - compaction.val()));
}
template <class Number>
CapSurface<Number> carry(const CapSurface<ByCompaction> &surface,
                         const Number &compaction)
{
  CapSurface<Number> result;
  result.cohesion = carry(surface.cohesion, compaction);
  result.eccentricity = carry(surface.eccentricity, compaction);
  result.transition = surface.transition;
  result.dilation_rule = surface.dilation_rule;
  result.tan_beta = carry(surface.tan_beta, compaction);
  result.inverse_cosine = carry(surface.inverse_cosine, compaction);
  result.centre = carry(surface.centre, compaction);
  result.strength = carry(surface.strength, compaction);
  result.factor = carry(surface.factor, compaction);
  return result;
}
inline CapSurface<double> values_of(const CapSurface<ByCompaction> &surface)
{
  return carry(surface, 0.);
}
} // namespace tamp::fem

#endif
