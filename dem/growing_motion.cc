// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_growth.h>
#include <dem/dynamics.h>
#include <dem/growing_motion.h>
#include <dem/stretch.h>
#include <dem/unit_cell.h>

namespace tamp::dem
{
namespace
{
// Grains grow, and laws are made anew, after the sooner of these.
constexpr double strain_of_a_motion = 1e-3;
constexpr std::size_t steps_of_a_motion = 500;

/// Motions one after the other. Each begins with the growth of the grains and
/// with the limiting contact pressures of the density then.
class GrowingMotion final : public Motion
{
public:
  GrowingMotion(UnitCell &cell,
                const Dynamics &settings,
                const Arithmetic &arithmetic)
      : cell_(cell), settings_(settings), arithmetic_(arithmetic),
        grow_(grains_grow(cell)),
        first_loss_(grow_ ? cell.energy.plastic_dissipation - unstored() : 0)
  {
    start();
  }

  bool advance(const Matrix3 &log_stretch,
               std::size_t steps,
               double time_step) override
  {
    constexpr double round_off = 1e-9;
    if (strain_ >= (1 - round_off) * strain_of_a_motion ||
        motion_->steps() >= steps_of_a_motion) {
      write_cell();
      earlier_steps_ += motion_->steps();
      start();
    }
    strain_ += largest_principal(log_stretch);
    return motion_->advance(log_stretch, steps, time_step);
  }
  void write_cell() override
  {
    motion_->write_cell();
    if (grow_)
      cell_.energy.plastic_dissipation = first_loss_ + unstored();
  }
  double time_step() const override { return motion_->time_step(); }
  Matrix3 stress() const override { return motion_->stress(); }
  double unbalance() const override { return motion_->unbalance(); }
  double hill_mandel() const override { return motion_->hill_mandel(); }
  std::size_t steps() const override
  {
    return earlier_steps_ + motion_->steps();
  }

private:
  double unstored() const
  {
    return unstored_work(cell_,
                         measure_dynamics(cell_, settings_, 0).kinetic_energy);
  }
  void start()
  {
    grow(cell_);
    motion_ = start_motion(cell_, settings_, arithmetic_);
    strain_ = 0;
  }

  UnitCell &cell_;
  Dynamics settings_;
  Arithmetic arithmetic_;
  std::unique_ptr<Motion> motion_;
  bool grow_;
  double first_loss_; // plastic, less the unstored work [J]
  double strain_ = 0; // of the motion now
  std::size_t earlier_steps_ = 0;
};
} // namespace

std::unique_ptr<Motion> start_growing_motion(UnitCell &cell,
                                             const Dynamics &settings,
                                             const Arithmetic &arithmetic)
{
  if (!grains_grow(cell) && !cell.adjusts_pressures())
    return start_motion(cell, settings, arithmetic);
  return std::make_unique<GrowingMotion>(cell, settings, arithmetic);
}
} // namespace tamp::dem
