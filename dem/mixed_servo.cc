// SPDX-License-Identifier: BSD-3-Clause
#include <dem/growing_motion.h>
#include <dem/mixed_servo.h>
#include <dem/servo_gain.h>
#include <dem/six.h>
#include <dem/stretch.h>
#include <dem/tangent.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace tamp::dem
{
namespace
{
// Time steps between two looks at the stress, and looks after which stiffness
// and time step are taken anew.
constexpr std::size_t steps_between_looks = 5, looks_of_a_round = 100;

/// A cell under servos.
class Servos
{
public:
  Servos(UnitCell &cell,
         const MixedControl &control,
         const Dynamics &settings,
         const Arithmetic &arithmetic);
  MixedAnswer run();

private:
  double accuracy() const;
  double worst_miss() const;
  Six rates(double time);
  bool look(double share);

  UnitCell &cell_;
  const MixedControl &control_;
  double rate_;
  std::unique_ptr<Motion> motion_;
  std::vector<ServoGain> gains_;
  Six prescribed_ = Six::Zero(), strain_ = Six::Zero();
  Six stiffness_ = Six::Zero();
  double largest_target_ = 0, duration_, step_ = 0;
};

Servos::Servos(UnitCell &cell,
               const MixedControl &control,
               const Dynamics &settings,
               const Arithmetic &arithmetic)
    : cell_(cell), control_(control), rate_(settings.strain_rate),
      motion_(start_growing_motion(cell, settings, arithmetic)),
      gains_(6, ServoGain(settings.strain_rate))
{
  for (int k = 0; k < 6; ++k) {
    const ComponentControl &component = control.components[k];
    if (component.kind == ComponentControl::Kind::strain)
      prescribed_[k] = component.value;
    else
      largest_target_ = std::max(largest_target_, std::abs(component.value));
  }
  duration_ = largest_principal(from_six(prescribed_)) / rate_;
}

double Servos::accuracy() const
{
  const double pressure = std::abs(motion_->stress().trace()) / 3;
  return control_.accuracy * std::max(largest_target_, pressure);
}

double Servos::worst_miss() const
{
  const Six stress = to_six(motion_->stress());
  double worst = 0;
  for (int k = 0; k < 6; ++k)
    if (control_.components[k].kind == ComponentControl::Kind::stress)
      worst =
          std::max(worst, std::abs(control_.components[k].value - stress[k]));
  return worst;
}

/// Strain rates of the free components; zero of the others.
Six Servos::rates(double time)
{
  const Six stress = to_six(motion_->stress());
  const double near = accuracy();
  Six result = Six::Zero();
  for (int k = 0; k < 6; ++k)
    if (control_.components[k].kind == ComponentControl::Kind::stress)
      result[k] = gains_[std::size_t(k)].rate(
          control_.components[k].value - stress[k], near, stiffness_[k], time);
  return result;
}

/// A few time steps, in which the prescribed components come a share of their
/// way further.
bool Servos::look(double share)
{
  const double time =
      share > 0 ? share * duration_ : step_ * double(steps_between_looks);
  const auto steps =
      std::max<std::size_t>(1, std::size_t(std::ceil(time / step_ - 1e-9)));
  const Six part = share * prescribed_ + time * rates(time);
  strain_ += part;
  return motion_->advance(from_six(part), steps, time / double(steps));
}

MixedAnswer Servos::run()
{
  const Matrix3 first_box = cell_.box.h;
  MixedAnswer result;
  Outcome outcome = Outcome::unsettled;
  double place = duration_ > 0 ? 0 : 1;
  for (std::size_t looks = 0; motion_->steps() < control_.most_steps; ++looks) {
    if (looks % looks_of_a_round == 0) {
      motion_->write_cell();
      step_ = motion_->time_step();
      stiffness_ = voigt_tangent(cell_).diagonal();
    }
    const double way = std::min(
        1 - place,
        place < 1 ? step_ * double(steps_between_looks) / duration_ : 0);
    const bool whole = look(way);
    place = way < 1 - place ? place + way : 1;
    if (!whole) {
      outcome = Outcome::diverged;
      break;
    }
    if (place == 1 && worst_miss() <= accuracy() &&
        motion_->unbalance() <= control_.unbalance) {
      outcome = Outcome::settled;
      break;
    }
  }
  // The sum of the parts, without their round-off.
  for (int k = 0; k < 6; ++k)
    if (control_.components[k].kind == ComponentControl::Kind::strain &&
        place == 1)
      strain_[k] = prescribed_[k];
  result.strain = from_six(strain_);
  result.stretch = exponential(result.strain);
  if (strain_.tail<3>().isZero(0))
    cell_.box.h = result.stretch * first_box;
  result.cell = end_motion(*motion_, outcome);
  return result;
}
} // namespace

MixedAnswer servo_mixed(UnitCell &cell,
                        const MixedControl &control,
                        const Dynamics &settings,
                        const Arithmetic &arithmetic)
{
  return Servos(cell, control, settings, arithmetic).run();
}
} // namespace tamp::dem
