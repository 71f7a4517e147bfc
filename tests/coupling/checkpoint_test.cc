// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/checkpoint.h>
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <tests/coupling/sample_cells.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace tamp::coupling
{
namespace
{
namespace fs = std::filesystem;
using fem::Advance;
using fem::Stage;

/// A folder that is removed at the end.
class Folder
{
public:
  Folder() : path_(fs::temp_directory_path() / name())
  {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder &) = delete;
  Folder &operator=(const Folder &) = delete;
  const fs::path &path() const { return path_; }

  /// Names in it, in order.
  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const auto &entry : fs::directory_iterator(path_))
      result.push_back(entry.path().filename());
    std::ranges::sort(result);
    return result;
  }

private:
  static std::string name()
  {
    return "tamp_checkpoint_" + std::to_string(getpid());
  }
  fs::path path_;
};

/// Points whose states are any bytes.
class Letters final : public fem::MaterialPoints
{
public:
  std::vector<std::string> states;

  std::size_t size() const override { return states.size(); }
  void evaluate(std::span<const fem::Deformation>,
                fem::Want,
                std::span<fem::Response>) override
  {
  }
  void commit() override {}
  void pack(std::size_t i, std::vector<char> &bytes) const override
  {
    bytes.insert(bytes.end(), states[i].begin(), states[i].end());
  }
  void unpack(std::size_t i, std::span<const char> bytes) override
  {
    states[i].assign(bytes.begin(), bytes.end());
  }
  double cost(std::size_t) const override { return 0; }
};

Letters three_points()
{
  Letters points;
  points.states = {"first", "", std::string(5000, 'x')};
  return points;
}

const std::string version = "1.2.3";
const fem::Ranks alone;

void write(const Folder &folder, unsigned step)
{
  const std::string state = "state of step " + std::to_string(step);
  write_checkpoint(folder.path(),
                   {version, "all of the input", step},
                   state,
                   three_points(),
                   alone);
}

std::string read(const fs::path &file)
{
  const auto bytes = read_whole_file(file);
  return {bytes.begin(), bytes.end()};
}

void replace(const fs::path &file, const std::string &bytes)
{
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}
} // namespace

TEST(Checkpoint, GivesBackWhatWasStored)
{
  const Folder folder;
  write(folder, 7);
  auto found = find_checkpoint(folder.path(), version);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->title.input, "all of the input");
  EXPECT_EQ(found->title.step, 7u);
  const std::vector<char> state = stored_state(&*found, alone);
  EXPECT_EQ(std::string(state.begin(), state.end()), "state of step 7");
  Letters points;
  points.states.resize(3);
  unpack_points(&*found, points, alone);
  EXPECT_EQ(points.states, three_points().states);
  for (const std::size_t other : {2, 4}) {
    points.states.resize(other);
    EXPECT_ANY_THROW(unpack_points(&*found, points, alone)) << other;
  }
}

TEST(Checkpoint, KeepsTheLastTwo)
{
  const Folder folder;
  EXPECT_FALSE(find_checkpoint(folder.path(), version));
  EXPECT_FALSE(find_checkpoint(folder.path() / "missing", version));
  for (const unsigned step : {3, 5, 9, 12000})
    write(folder, step);
  replace(folder.path() / "step_0004.tamp.part", "of a run that was killed");
  EXPECT_EQ(find_checkpoint(folder.path(), version)->title.step, 12000u);
  // A run that went back to step 9 goes on from there.
  write(folder, 10);
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"step_0009.tamp", "step_0010.tamp"}));
}

TEST(Checkpoint, EveryBitThatFlipsAndEveryCutIsNoticed)
{
  const Folder folder;
  write(folder, 1);
  write(folder, 2);
  const fs::path newest = folder.path() / "step_0002.tamp";
  const std::string good = read(newest);
  const auto passed_over = [&](const std::string &bytes) {
    replace(newest, bytes);
    const auto found = find_checkpoint(folder.path(), version);
    return found && found->title.step == 1 && found->passed_over.size() == 1 &&
           found->passed_over[0].find("step_0002") != std::string::npos;
  };
  // All bytes but those that are alike: the long state's.
  for (std::size_t i = 0;
       i<good.size(); i += i> 400 && i + 400 < good.size() ? 97 : 1) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << i % 8));
    ASSERT_TRUE(passed_over(bad)) << "byte " << i;
    ASSERT_TRUE(passed_over(good.substr(0, i))) << "cut at " << i;
  }
  EXPECT_TRUE(passed_over(good + "x"));
  EXPECT_TRUE(passed_over(std::string(good.size(), '\0')));
  replace(newest, good);
  EXPECT_EQ(find_checkpoint(folder.path(), version)->title.step, 2u);
}

TEST(Checkpoint, OfAnotherFormatOrProgramIsRefusedInASentence)
{
  const auto reason = [](const Folder &folder, const std::string &program) {
    try {
      find_checkpoint(folder.path(), program);
    } catch (const FileError &error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  const Folder folder;
  write(folder, 4);
  EXPECT_NE(
      reason(folder, "1.3.0").find("written by tamp 1.2.3, this is tamp 1.3.0"),
      std::string::npos);
  std::string later = read(folder.path() / "step_0004.tamp");
  const auto digit = later.find("format 1");
  ASSERT_NE(digit, std::string::npos);
  later.replace(digit, 8, "format 2");
  replace(folder.path() / "step_0004.tamp", later);
  EXPECT_NE(reason(folder, version)
                .find("begins with 'tamp checkpoint, format 2', not with "
                      "'tamp checkpoint, format 1'"),
            std::string::npos);
}

TEST(Checkpoint, ThatCannotBeWrittenLeavesTheOlderOnes)
{
  const Folder folder;
  write(folder, 1);
  write(folder, 2);
  // A folder of that name stands in the way of what is written first.
  fs::create_directories(folder.path() / "step_0003.tamp.part" / "x");
  EXPECT_THROW(write(folder, 3), FileError);
  EXPECT_EQ(find_checkpoint(folder.path(), version)->title.step, 2u);
  EXPECT_TRUE(fs::exists(folder.path() / "step_0001.tamp"));
}

/// A die of eight cells, pressed, unloaded and pushed up, which can be left and
/// gone on with at any step.
class CellDie
{
public:
  explicit CellDie(unsigned threads = 1)
      : cells_(test::different_cells(8), {{}, threads, true}),
        mesh_(fem::build_mesh(settings().geometry))
  {
    make_model({});
  }
  CellDie(FoundCheckpoint &found, unsigned threads)
      : cells_(test::same_cells(8), {{}, threads, true}),
        mesh_(fem::build_mesh(settings().geometry))
  {
    make_model(stored_state(&found, alone));
    unpack_points(&found, cells_, alone);
  }

  Advance advance() { return model_->advance(); }
  const fem::StepRecord &last_step() const { return model_->last_step(); }
  const std::string &problem() const { return model_->failure().reason; }

  void store(const Folder &folder) const
  {
    std::vector<char> state;
    model_->pack(state);
    write_checkpoint(
        folder.path(), {version, "", last_step().step}, state, cells_, alone);
  }

  /// All that the cells are, and what the step cost and gave.
  std::vector<char> bytes() const
  {
    std::vector<char> all;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      cells_.pack(i, all);
    for (const double value : {last_step().upper_force,
                               last_step().wall_friction_force,
                               last_step().force_residual,
                               double(last_step().material_updates),
                               cells_.report().mean_evaluations(),
                               cells_.report().worst_unbalance}) {
      const char *begin = reinterpret_cast<const char *>(&value);
      all.insert(all.end(), begin, begin + sizeof value);
    }
    return all;
  }

private:
  static fem::DieSettings settings()
  {
    fem::DieSettings result;
    result.geometry.radial_elements = 1;
    result.geometry.axial_elements = 2;
    result.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
    result.steps.first = result.steps.maximum = 1e-2;
    Stage press{fem::StageKind::press, fem::StageTarget::density, 0.66};
    Stage unload{fem::StageKind::unload, fem::StageTarget::peak_share, 0.3};
    Stage eject{fem::StageKind::eject, fem::StageTarget::displacement, 1e-4};
    eject.hold_share = 0.3;
    result.stages = {press, unload, eject};
    return result;
  }

  void make_model(const std::vector<char> &state)
  {
    model_ = std::make_unique<fem::DieModel>(
        settings(),
        mesh_,
        cells_,
        [this](unsigned, double) { cells_.turn(); },
        alone,
        state);
  }

  UnitCellPoints cells_;
  fem::Mesh mesh_;
  std::unique_ptr<fem::DieModel> model_;
};

TEST(Checkpoint, ADieOfCellsGoesOnToTheBitAfterEveryStep)
{
  const Folder folder;
  CellDie whole;
  std::vector<std::vector<char>> bytes{whole.bytes()};
  std::vector<unsigned> stages{0};
  Advance end = Advance::stepped;
  while ((end = whole.advance()) == Advance::stepped) {
    bytes.push_back(whole.bytes());
    stages.push_back(whole.last_step().stage);
  }
  ASSERT_EQ(end, Advance::finished) << whole.problem();
  ASSERT_EQ(stages.back(), 2u);

  // Left and gone on with after every step, on one thread and on two in turn.
  auto run = std::make_unique<CellDie>();
  unsigned threads = 1;
  for (std::size_t step = 1; step < bytes.size(); ++step) {
    run->store(folder);
    auto found = find_checkpoint(folder.path(), version);
    ASSERT_TRUE(found);
    threads = 3 - threads;
    run = std::make_unique<CellDie>(*found, threads);
    ASSERT_EQ(run->advance(), Advance::stepped) << "step " << step;
    ASSERT_TRUE(run->bytes() == bytes[step]) << "step " << step;
  }
  EXPECT_EQ(run->advance(), Advance::finished);
}
} // namespace tamp::coupling
