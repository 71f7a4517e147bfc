// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_step_control_h
#define fem_step_control_h

#include <fem/die_settings.h>

#include <algorithm>

namespace tamp::fem
{
/// How far the next step goes, as mean axial strain [-].
class StepControl
{
public:
  StepControl() = default;
  StepControl(double first, double largest, double growth)
      : strain_(std::min(first, largest)), largest_(largest), growth_(growth)
  {
  }

  double strain() const { return strain_; }

  /// The next step has this size; grows later as any other.
  void accepted(double strain, bool was_cut)
  {
    if (was_cut)
      strain_ = strain;
    else if (strain > 0.99 * strain_)
      strain_ = std::min(largest_, growth_ * strain_);
  }

private:
  double strain_ = 0, largest_ = 0, growth_ = 1;
};

/// Part of a way.
struct Portion {
  double length = 0;
  bool lands = false; ///< it is all that remains
};

/// The next part of what remains of a way if `step` is the longest: no slivers
/// are left, the last two parts are alike.
inline Portion portion_of(double remaining, double step)
{
  if (remaining <= step * (1 + 1e-9))
    return {remaining, true};
  if (remaining < 2 * step)
    return {0.5 * remaining, false};
  return {step, false};
}
} // namespace tamp::fem

#endif
