// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_increment_h
#define fem_laws_cap_increment_h

#include <fem/laws/corotation.h>
#include <fem/laws/drucker_prager_cap.h>

#include <optional>

namespace tamp::fem
{
/// Where an increment leads to, in the frame that does not turn.
struct CapAnswer {
  CorotatedStress stress;
  double plastic_compaction = 0; ///< eps [-]
  double plastic_shear = 0;      ///< [-]
  DruckerPragerCap::Surface surface = DruckerPragerCap::Surface::none;
  bool is_resolved = true; ///< the error met its tolerance
};

/// Integrates an increment; none if it failed.
/// @param strain  logarithmic stretch of the increment [-].
std::optional<CapAnswer>
integrate_cap(const DruckerPragerCapParameters &parameters,
              const DruckerPragerCap::State &old,
              const dealii::SymmetricTensor<2, 3> &strain,
              Want want);
} // namespace tamp::fem

#endif
