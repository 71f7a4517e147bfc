// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_servo_gain_h
#define dem_servo_gain_h

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
/// Turns a stress that is missing into a strain rate g x missing, with the gain
/// g = rate / missing of the start. The gain is bounded by what a cell can
/// follow, halved whenever the stress passes its goal, without which a stiff
/// packing would swing about it, and recovers slowly.
/// Source: Sheng et al. (2004), eqs (7) and (8).
class ServoGain
{
public:
  /// @param fastest  largest rate [1/s]
  explicit ServoGain(double fastest) : fastest_(fastest) {}

  /// The rate now [1/s].
  /// @param missing    goal - stress [Pa]
  /// @param near       less than this is no miss [Pa]
  /// @param stiffness  d stress / d strain, an upper estimate [Pa]
  /// @param time       until the next look [s]
  double rate(double missing, double near, double stiffness, double time)
  {
    // The share of what is missing that one look may make up for: grains need
    // some ten looks to answer.
    constexpr double share = 0.05;
    const double size = std::abs(missing);
    const double most = stiffness > 0 ? share / (stiffness * time)
                                      : fastest_ / std::max(size, near);
    if (gain_ <= 0)
      gain_ = std::min(most, fastest_ / std::max(size, near));
    else if (missing * before_ < 0 && size > near)
      gain_ *= 0.5;
    else
      gain_ *= 1.02;
    gain_ = std::clamp(gain_, most / 64, most);
    before_ = missing;
    return std::clamp(gain_ * missing, -fastest_, fastest_);
  }

private:
  double fastest_, gain_ = 0, before_ = 0;
};
} // namespace tamp::dem

#endif
