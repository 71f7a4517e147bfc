// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/state_bytes.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

namespace tamp::fem
{
namespace
{
/// What stands in memory of a model and its points.
struct Stored {
  std::vector<char> model;
  std::vector<std::vector<char>> points;
};

/// A model with its mesh and points, from the start or from what was stored.
struct StoredRun {
  Mesh mesh;
  ContinuumPoints<DruckerPragerCap> points;
  DieModel model;

  explicit StoredRun(const DieSettings &settings, const Stored &stored = {})
      : mesh(build_mesh(settings.geometry)),
        points(DruckerPragerCap(), mesh.number_of_points()),
        model(settings, mesh, points, {}, Ranks(), stored.model)
  {
    for (std::size_t i = 0; i < stored.points.size(); ++i)
      points.unpack(i, stored.points[i]);
  }

  Stored store() const
  {
    Stored stored;
    model.pack(stored.model);
    stored.points.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      points.pack(i, stored.points[i]);
    return stored;
  }
};

/// All numbers of a step and all stresses after it.
std::vector<double> numbers_of(const DieModel &model)
{
  const StepRecord &now = model.last_step();
  std::vector<double> numbers{double(now.step),
                              double(now.stage),
                              double(now.iterations),
                              double(now.material_updates),
                              double(now.cuts),
                              now.upper_displacement,
                              now.lower_displacement,
                              now.die_displacement,
                              now.upper_force,
                              now.lower_force,
                              now.wall_friction_force,
                              now.wall_normal_force,
                              now.wall_area,
                              now.compact_height,
                              now.compact_radius,
                              now.mean_relative_density,
                              now.force_residual,
                              now.displacement_change,
                              now.stage_progress};
  for (const Response &response : model.responses())
    for (unsigned i = 0; i < 6; ++i)
      numbers.push_back(response.stress.access_raw_entry(i));
  for (const auto &F : model.deformation_gradients())
    for (unsigned i = 0; i < 9; ++i)
      numbers.push_back(F[i / 3][i % 3]);
  return numbers;
}

/// A floating die with friction: every member of the schedule and of contact
/// has a part in it, and nodes are let go at the rim.
DieSettings whole_trip(NonlinearMethod method, bool f_bar)
{
  DieSettings settings;
  settings.geometry.radial_elements = 2;
  settings.geometry.axial_elements = 4;
  settings.friction[die_wall] = FrictionCoefficient(0.15);
  settings.floating_die = true;
  settings.solver.method = method;
  settings.solver.f_bar = f_bar;
  settings.steps.maximum = 3e-2;
  settings.steps.unloading = 1e-2;
  settings.steps.first = 1e-2;
  Stage press{StageKind::press, StageTarget::density, 0.6};
  press.pressing = Pressing::both;
  Stage unload{StageKind::unload, StageTarget::peak_share, 0.1};
  Stage eject{StageKind::eject, StageTarget::out, 0};
  eject.hold_share = 0.05;
  settings.stages = {press, unload, eject};
  settings.check();
  return settings;
}

using Case = std::pair<NonlinearMethod, bool>;
class StoredStates : public testing::TestWithParam<Case>
{
};
} // namespace

INSTANTIATE_TEST_SUITE_P(,
                         StoredStates,
                         testing::Values(Case{NonlinearMethod::newton, true},
                                         Case{NonlinearMethod::anderson,
                                              false}));

TEST_P(StoredStates, GoOnToTheBitFromAnyStepOfATrip)
{
  const DieSettings settings = whole_trip(GetParam().first, GetParam().second);
  StoredRun whole(settings);
  std::vector<Stored> stored{whole.store()};
  std::vector<std::vector<double>> numbers{numbers_of(whole.model)};
  std::set<unsigned> stages;
  Advance end = Advance::stepped;
  while ((end = whole.model.advance()) == Advance::stepped) {
    stored.push_back(whole.store());
    numbers.push_back(numbers_of(whole.model));
    stages.insert(whole.model.last_step().stage);
  }
  ASSERT_EQ(end, Advance::finished) << whole.model.failure().reason;
  ASSERT_EQ(stages.size(), 3u);

  // Each stored state gives the next step; some give all that is left.
  for (std::size_t from = 0; from + 1 < stored.size(); ++from) {
    StoredRun later(settings, stored[from]);
    EXPECT_EQ(numbers_of(later.model), numbers[from]) << "step " << from;
    const std::size_t last = from % 7 == 3 ? stored.size() - 1 : from + 1;
    for (std::size_t step = from + 1; step <= last; ++step) {
      ASSERT_EQ(later.model.advance(), Advance::stepped) << "step " << step;
      ASSERT_EQ(numbers_of(later.model), numbers[step])
          << "step " << step << " after " << from;
    }
    if (last + 1 == stored.size()) {
      EXPECT_EQ(later.model.advance(), Advance::finished);
    }
  }
}

TEST(StoredState, OfAnotherMeshOrCutOffIsRefused)
{
  DieSettings settings = whole_trip(NonlinearMethod::newton, false);
  StoredRun run(settings);
  ASSERT_EQ(run.model.advance(), Advance::stepped);
  Stored stored = run.store();
  const std::vector<char> good = stored.model;
  for (const std::size_t left :
       {std::size_t(1), good.size() / 2, good.size() - 1}) {
    stored.model.assign(good.begin(), good.begin() + std::ptrdiff_t(left));
    EXPECT_THROW(StoredRun(settings, stored), std::runtime_error) << left;
  }
  stored.model = good;
  stored.model.push_back('x');
  EXPECT_THROW(StoredRun(settings, stored), std::runtime_error);
  stored.model = good;
  settings.geometry.axial_elements = 3;
  EXPECT_THROW(StoredRun(settings, stored), std::runtime_error);
}
} // namespace tamp::fem
