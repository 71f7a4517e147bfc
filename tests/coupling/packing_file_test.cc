// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/packing_adoption.h>
#include <coupling/packing_file.h>
#include <dem/deform.h>
#include <dem/measures.h>
#include <dem/random_start.h>
#include <tests/coupling/sample_cells.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tamp::coupling
{
namespace
{
using dem::test::message_of;
namespace fs = std::filesystem;
using test::granules;
using test::growing_cell;
using test::sample_cell;

class PackingFile : public testing::Test
{
protected:
  PackingFile()
      : folder_(fs::temp_directory_path() /
                ("tamp_packing_" + std::to_string(getpid())))
  {
    fs::create_directories(folder_);
  }
  ~PackingFile() override { fs::remove_all(folder_); }

  fs::path path(const std::string &name) const { return folder_ / name; }
  fs::path file(const std::string &name, const std::string &text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  std::string content(const std::string &name) const
  {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

private:
  fs::path folder_;
};

/// A cell with something in every part: sheared, unloaded, moving.
dem::UnitCell busy_cell()
{
  dem::UnitCell cell = sample_cell();
  dem::Stretch stretch = dem::Stretch::Identity();
  stretch(2, 2) = 0.98;
  stretch(0, 1) = stretch(1, 0) = 0.003;
  deform(cell, stretch, {});
  deform(cell, stretch.inverse(), {});
  cell.velocity.assign(cell.size(), {1e-3, -0.0, 1.0 / 3});
  cell.spin.assign(cell.size(), {0, 5e-324, 2});
  cell.energy.damping_dissipation = 1e-7;
  cell.materials.push_back({1e9, 0.25, 1500, 2e7});
  cell.species.assign(cell.size(), 0);
  cell.species[3] = 1;
  return cell;
}

std::string refusal(const fs::path &file)
{
  return message_of<std::invalid_argument>([&] { (void)read_packing(file); });
}

TEST_F(PackingFile, Hdf5GivesTheCellBackToTheBit)
{
  for (const dem::UnitCell &cell : {sample_cell(), busy_cell()}) {
    const fs::path stored = path(cell.velocity.empty() ? "a.h5" : "b.h5");
    write_packing(cell, stored);
    EXPECT_EQ(read_packing(stored), cell);
  }
}

TEST_F(PackingFile, GrownGrainsKeepBothSizes)
{
  const dem::UnitCell &cell = growing_cell();
  ASSERT_EQ(cell.initial_radius.size(), cell.size());
  ASSERT_NE(cell.initial_radius, cell.radius);
  write_packing(cell, path("a.h5"));
  EXPECT_EQ(read_packing(path("a.h5")), cell);
  write_packing_text(cell, path("a.txt"));
  EXPECT_EQ(read_packing(path("a.txt")).radius, cell.initial_radius);
}

TEST_F(PackingFile, AdjustedPressuresOfEachMaterialAreKept)
{
  dem::UnitCell cell = test::adjusted_cell();
  cell.materials.push_back(cell.materials[0]);
  cell.materials[1].adjusted_pressures = {{0.7, 1e8}};
  cell.materials.push_back({1e9, 0.25, 1500, 2e7});
  write_packing(cell, path("a.h5"));
  EXPECT_EQ(read_packing(path("a.h5")), cell);
}

TEST_F(PackingFile, FilesFromBeforeGrainsGrewAreRead)
{
  // 30 grains, written before there were initial sizes and a bulk onset.
  const dem::UnitCell cell =
      read_packing(fs::path(TAMP_TEST_DATA) / "packing_of_lasting_sizes.h5");
  EXPECT_EQ(cell.size(), 30u);
  EXPECT_TRUE(cell.initial_radius.empty());
  EXPECT_EQ(cell.initial_radius_of(3), cell.radius[3]);
  EXPECT_EQ(cell.contact.bulk_onset, dem::ContactModel().bulk_onset);
  EXPECT_FALSE(cell.contacts.empty());
}

TEST_F(PackingFile, SameCellGivesTheSameBytes)
{
  write_packing(sample_cell(), path("a.h5"));
  write_packing(sample_cell(), path("b.h5"));
  EXPECT_EQ(content("a.h5"), content("b.h5"));
}

TEST_F(PackingFile, IsNeverOverwritten)
{
  file("there.h5", "mine");
  for (const bool text : {false, true}) {
    const std::string message = message_of<FileError>([&] {
      text ? write_packing_text(sample_cell(), path("there.h5"))
           : write_packing(sample_cell(), path("there.h5"));
    });
    EXPECT_NE(message.find("there.h5"), std::string::npos) << message;
    EXPECT_NE(message.find("exists"), std::string::npos) << message;
  }
  EXPECT_EQ(content("there.h5"), "mine");
  EXPECT_FALSE(fs::exists(path("there.h5.part")));
}

TEST_F(PackingFile, TextGivesThePlacesBack)
{
  write_packing_text(sample_cell(), path("a.txt"));
  const dem::UnitCell read = read_packing(path("a.txt"));
  EXPECT_EQ(read.radius, sample_cell().radius);
  EXPECT_EQ(read.box, sample_cell().box);
  for (std::size_t i = 0; i < read.size(); ++i)
    // Once multiplied by h and once by its inverse.
    EXPECT_LT(
        read.box.nearest_image(read.place[i] - sample_cell().place[i]).norm(),
        1e-14 * read.box.h.norm());
  EXPECT_TRUE(read.contacts.empty());
}

TEST_F(PackingFile, TextHoldsAnObliqueBoxToo)
{
  dem::UnitCell cell = sample_cell();
  cell.box.h(0, 1) = 0.1 * cell.box.h(0, 0);
  cell.box.h(2, 0) = -0.05 * cell.box.h(0, 0);
  write_packing_text(cell, path("a.txt"));
  EXPECT_NE(content("a.txt").find("\n# box "), std::string::npos);
  EXPECT_EQ(read_packing(path("a.txt")).box, cell.box);
}

TEST_F(PackingFile, TextOfOthersIsRead)
{
  const dem::UnitCell cell = read_packing(
      file("a.txt",
           "# a remark\r\n# L 1e-3 2e-3 +3e-3 # and another\r\n\r\n"
           "0.1e-3\t1e-3, 2.5e-3 1e-4\r\n-0.2e-3 0 0 2e-4"));
  ASSERT_EQ(cell.size(), 2u);
  EXPECT_DOUBLE_EQ(cell.place[0][2], 2.5 / 3);
  EXPECT_DOUBLE_EQ(cell.place[1][0], -0.2);
  EXPECT_EQ(cell.radius[1], 2e-4);
  EXPECT_DOUBLE_EQ(cell.box.volume(), 6e-9);
}

TEST_F(PackingFile, WrongLinesOfATextAreNamed)
{
  const auto names = [&](const std::string &text,
                         std::initializer_list<const char *> parts) {
    const std::string message = refusal(file("a.txt", text));
    for (const char *part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const std::string box = "# L 1e-3 1e-3 1e-3\n", two = "0 0 0 1e-4\n";
  names(box + two + "0 0 1e-4\n", {"a.txt:3", "x y z r", "not 3"});
  names(box + two + "0 0 zero 1e-4\n", {"a.txt:3", "'zero'"});
  names(box + two + "0 0 nan 1e-4\n", {"a.txt:3", "'nan'"});
  names(box + two + "0 0 5e-4 -1e-4\n", {"a.txt:3", "-1e-4", "above 0"});
  names(box + two + "0 0 9.5e-4 1e-4\n", {"a.txt:3", "line 2"});
  names(box + box + two, {"a.txt:2", "before"});
  names("# L 1e-3 1e-3\n" + two, {"a.txt:1", "3 numbers", "not 2"});
  names("# box 1 0 0 0 1 0 0 0 -1\n", {"a.txt:1", "right-handed"});
  names(two + two, {"a.txt:2", "# L"});
  names(box + two, {"a.txt", "expected grains"});
  names("# L 3e-4 1e-3 1e-3\n" + two + "5e-5 5e-4 0 1e-4\n",
        {"a.txt", "too small"});
  names("", {"a.txt:1", "# L"});
}

TEST_F(PackingFile, DamagedAndForeignHdf5IsRefused)
{
  write_packing(sample_cell(), path("good.h5"));
  const std::string good = content("good.h5");
  const auto says = [&](const std::string &bytes, const char *part) {
    const std::string message = refusal(file("bad.h5", bytes));
    EXPECT_NE(message.find("bad.h5"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  says(good.substr(0, good.size() / 2), "incomplete");
  says(good.substr(0, 80), "incomplete");
  says(good.substr(512), "another program");
  // One flipped bit in the radii: the checksum finds it.
  std::string flipped = good;
  const double radius = sample_cell().radius[7];
  const auto at =
      good.find(std::string(reinterpret_cast<const char *>(&radius), 8));
  ASSERT_NE(at, std::string::npos);
  flipped[at] ^= 1;
  says(flipped, "checksum");
  EXPECT_NE(message_of<FileError>([&] {
              (void)read_packing(path("no.h5"));
            }).find("no.h5"),
            std::string::npos);
  EXPECT_NE(message_of<FileError>([&] {
              (void)read_packing(path(""));
            }).find("directory"),
            std::string::npos);
}

TEST_F(PackingFile, AnyFlippedByteIsFound)
{
  write_packing(dem::random_start(granules(60)), path("good.h5"));
  std::string bytes = content("good.h5");
  // Behind the blanks that fill the first block, which mean nothing.
  for (std::size_t at = 512; at < bytes.size(); at += 97) {
    bytes[at] = static_cast<char>(~bytes[at]);
    EXPECT_NE(refusal(file("bad.h5", bytes)), "") << at;
    bytes[at] = static_cast<char>(~bytes[at]);
  }
  EXPECT_EQ(refusal(file("bad.h5", bytes)), "");
}

TEST_F(PackingFile, CellsThatCannotBeAreRefused)
{
  dem::UnitCell cell = sample_cell();
  cell.radius[3] = -cell.radius[3];
  write_packing(cell, path("radius.h5"));
  EXPECT_NE(refusal(path("radius.h5")).find("radius"), std::string::npos);
  cell = sample_cell();
  cell.contacts[0].pair.second = 100000;
  write_packing(cell, path("pair.h5"));
  EXPECT_NE(refusal(path("pair.h5")).find("fit together"), std::string::npos);
}

TEST(AdoptedPacking, IsKeptUnderItsOwnModel)
{
  const dem::UnitCell &cell = sample_cell();
  dem::UnitCell adopted = cell;
  EXPECT_EQ(adopt_packing(adopted, cell.materials, cell.contact),
            History::kept);
  EXPECT_EQ(adopted, cell);
}

TEST(AdoptedPacking, NeedsAMaterialForEachSpecies)
{
  dem::UnitCell cell = sample_cell();
  cell.materials.push_back(cell.materials[0]);
  cell.species.assign(cell.size(), 0);
  cell.species[5] = 1;
  const std::vector<dem::GrainMaterial> one(1, cell.materials[0]);
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              adopt_packing(cell, one, cell.contact);
            }).find("2 materials, this run has 1"),
            std::string::npos);
}

TEST(AdoptedPacking, SlipsWhereFrictionIsLess)
{
  dem::UnitCell cell = sample_cell();
  dem::ContactModel contact = cell.contact;
  contact.friction_coefficient = 0.1;
  EXPECT_EQ(adopt_packing(cell, cell.materials, contact), History::slipped);
  EXPECT_EQ(cell.box, sample_cell().box);
  // Of a mean contact force p d^2; the overlap of grains that barely touch is
  // a difference of large numbers.
  constexpr double rounding = 1e-8 * 0.5e6 * 550e-6 * 550e-6;
  for (const dem::ContactForce &force : dem::contact_forces(cell))
    EXPECT_LE(force.tangential_force.norm(),
              0.1 * force.normal_force + rounding);
  EXPECT_EQ(cell.energy, dem::EnergyAccount{});
}

TEST(AdoptedPacking, ForgetsTheGrowthOfGrainsWithTheContacts)
{
  dem::UnitCell kept = growing_cell(), forgotten = growing_cell();
  EXPECT_EQ(adopt_packing(kept, kept.materials, kept.contact), History::kept);
  EXPECT_EQ(kept.radius, growing_cell().radius);
  dem::ContactModel other = forgotten.contact;
  other.normal_law = dem::NormalLaw::thornton_ning;
  EXPECT_EQ(adopt_packing(forgotten, forgotten.materials, other),
            History::forgotten);
  EXPECT_EQ(forgotten.radius, growing_cell().initial_radius);
  EXPECT_TRUE(forgotten.initial_radius.empty());
  EXPECT_EQ(forgotten.solid_volume(), growing_cell().solid_volume());
}

TEST(AdoptedPacking, OfATextPushesAsHardAsBefore)
{
  dem::UnitCell cell = sample_cell();
  cell.contacts.clear();
  cell.more_memory.clear();
  EXPECT_EQ(adopt_packing(cell, cell.materials, cell.contact),
            History::forgotten);
  const auto pressure = [](const dem::UnitCell &of) {
    return -dem::measure(of).stress.trace() / 3;
  };
  // The overlaps carry the normal forces. What the tangential ones carried
  // must be found again: grains move, some per cent of the pressure get lost.
  EXPECT_NEAR(pressure(cell) / pressure(sample_cell()), 1, 0.3);
  dem::UnitCell again = cell;
  EXPECT_EQ(deform(again, dem::Stretch::Identity(), {}).outcome,
            dem::Outcome::settled);
}
} // namespace
} // namespace tamp::coupling
