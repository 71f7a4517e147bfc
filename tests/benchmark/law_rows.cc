// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/drucker_prager_cap.h>
#include <tests/benchmark/rows.h>

#include <deal.II/base/tensor.h>

#include <memory>

// What the Drucker-Prager cap costs a material point of a die on the cap: 5e-3
// of axial strain with some shear, from half-way through pressing.
namespace tamp::speed
{
namespace
{
class Pressed
{
public:
  Pressed()
  {
    increment_.relative_F =
        dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
    increment_.relative_F[2][2] -= 5e-3;
    increment_.relative_F[0][2] += 5e-4;
    for (unsigned step = 0; step < 100; ++step) {
      auto now = old_;
      law_.respond(old_, now, increment_, fem::Want::stress);
      old_ = now;
    }
  }
  void respond(const fem::Want want) const
  {
    auto now = old_;
    benchmark::DoNotOptimize(law_.respond(old_, now, increment_, want));
  }

private:
  fem::DruckerPragerCap law_;
  fem::DruckerPragerCap::State old_ = law_.initial_state();
  fem::Deformation increment_;
};
} // namespace

void add_laws()
{
  const auto pressed = std::make_shared<Pressed>();
  add_time("law.cap.stress", [=] { pressed->respond(fem::Want::stress); });
  add_time("law.cap.tangent",
           [=] { pressed->respond(fem::Want::stress_and_tangent); });
}
} // namespace tamp::speed
