// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_yield_search_h
#define fem_yield_search_h

#include <fem/path_driver.h>
#include <fem/small_probes.h>

#include <deal.II/base/symmetric_tensor.h>

#include <optional>
#include <vector>

namespace tamp::fem
{
/// By what yield is told.
enum class YieldCriterion : unsigned {
  strain = 0, ///< an irreversible strain
  work = 1,   ///< a plastic work
  peak = 2    ///< the largest deviatoric stress, or the critical state
};

/// Where yield begins.
struct YieldLimits {
  double strain = 5e-4; ///< of the norm of the irreversible strain [-]
  double work = 0;      ///< plastic work per volume [J/m3]
};

/// A point of a yield surface, compression positive.
struct YieldPoint {
  YieldCriterion criterion = YieldCriterion::strain;
  double pressure = 0;          ///< [Pa]
  double deviatoric_stress = 0; ///< q = sqrt(3/2 s:s) [Pa]
  /// How much plastic strain grew by just before: over the last increments that
  /// together have half the irreversible strain of the limit. Compaction, and
  /// sqrt(2/3 e:e) [-].
  double plastic_volumetric_strain = 0, plastic_shear_strain = 0;
};

/// Looks for yield along a path from an elastic state. The plastic strain is
/// the logarithmic strain less what the measured moduli explain of it; its norm
/// is sqrt(eps_v^2 + eps_q^2) with the volumetric strain eps_v and eps_q =
/// sqrt(2/3 e:e). The path must not rotate its principal axes much.
class YieldSearch
{
public:
  YieldSearch(const YieldLimits &limits, const ModuliOverPressure &moduli)
      : limits_(limits), moduli_(moduli)
  {
  }

  /// Takes the state after an increment, the start first.
  void take(const PathRecord &record);

  /// Whether the irreversible strain and the plastic work are beyond limits.
  bool yielded() const;
  /// Whether the path need not go on: the deviatoric stress has fallen by 2 %
  /// from its peak, or grew by less than 1 % over a shear strain of 1 %, or the
  /// density is another: plastic compaction is above 1 %, which hardens the
  /// powder, or dilation above 5 %. Dense grains under low pressure dilate by 1
  /// to 4 % on their way to the peak.
  bool ended() const;
  /// What was found: at most one point for each criterion, in their order.
  /// @param with_peak  whether a largest deviatoric stress means anything
  std::vector<YieldPoint> points(bool with_peak = true) const;

private:
  struct Entry {
    double pressure = 0, deviatoric_stress = 0;
    double shear = 0;      ///< since the start, elastic part included [-]
    double compaction = 0; ///< plastic [-]
    dealii::SymmetricTensor<2, 3> distortion; ///< plastic, deviatoric [-]
    double work = 0;
    double irreversible() const;
  };

  bool peaked() const;
  bool critical() const;
  std::size_t peak() const;
  std::optional<YieldPoint> crossing(YieldCriterion criterion) const;
  /// @param earlier  entries before it
  YieldPoint point(YieldCriterion criterion,
                   const Entry &entry,
                   std::size_t earlier) const;

  YieldLimits limits_;
  const ModuliOverPressure &moduli_;
  std::vector<Entry> entries_;
  dealii::SymmetricTensor<2, 3> start_strain_, strain_, stress_;
};
} // namespace tamp::fem

#endif
