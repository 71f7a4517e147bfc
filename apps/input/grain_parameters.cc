// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/cell_parameters.h>
#include <apps/input/contact_parameters.h>
#include <apps/input/input_sections.h>
#include <apps/input/parameter_table.h>
#include <apps/input/size_table_file.h>

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>

namespace tamp::apps
{
namespace
{
// Order as in the enumerations of dem.
const std::vector<std::string> distributions{
    "uniform", "normal", "lognormal", "table"};
const std::vector<std::string> compressions{"isotropic", "uniaxial"};
const std::vector<std::string> targets{"pressure", "relative density"};

constexpr const char *second = "Second species";

// The sizes and the solid of one kind of grains, in the section entered last.
void declare_kind(ParameterTable &table)
{
  table.choice("Diameter distribution",
               "uniform",
               distributions,
               "How diameters are distributed, by number; normal and lognormal "
               "are cut off at the minimum and maximum; table: as measured");
  table.text("Size table",
             "",
             "CSV with diameter[um] and cumulative_share_by_mass[-], "
             "..._by_volume, ..._by_number, or share_by_... of classes; the "
             "path starts at the input's folder; table only");
  table.quantity("Minimum diameter",
                 "136 um",
                 dimension::length,
                 positive,
                 "Diameter of the smallest grain");
  table.quantity("Maximum diameter",
                 "264 um",
                 dimension::length,
                 positive,
                 "Diameter of the largest grain");
  table.quantity("Mean diameter",
                 "200 um",
                 dimension::length,
                 positive,
                 "Mean of a normal or lognormal distribution");
  table.quantity("Standard deviation",
                 "30 um",
                 dimension::length,
                 positive,
                 "Of the diameter, normal or lognormal distribution");
  table.quantity("Young's modulus",
                 "70 GPa",
                 dimension::pressure,
                 positive,
                 "E of the grains");
  table.quantity("Poisson's ratio",
                 "0.3",
                 dimension::number,
                 {-1, 0.5, true, true},
                 "nu of the grains");
  table.quantity("Density",
                 "2650 kg/m3",
                 dimension::density,
                 positive,
                 "Of the solid that grains are made of; only dynamics feels "
                 "it");
}

void declare_sizes(ParameterTable &table)
{
  table.enter("Grains");
  table.integer("Count", 1000, 20, "Grains in a unit cell, of all species");
  declare_kind(table);
  table.enter(second);
  table.quantity("Number share",
                 "0",
                 dimension::number,
                 {0, 1, false, true},
                 "Of all grains; 0: there is no second species");
  declare_kind(table);
  table.quantity("Limiting contact pressure",
                 "0.5 GPa",
                 dimension::pressure,
                 positive,
                 "p_y of these grains; a contact has the smaller one of its "
                 "grains");
  table.leave();
  table.leave();
}

void declare_packing(ParameterTable &table)
{
  table.enter("Packing");
  table.choice("Source",
               "generate",
               {"generate", "file"},
               "Where packings come from; tamp pack compresses those of a file "
               "further");
  table.text("File",
             "",
             "packing.h5 or text with x y z r [m], or a folder with packings "
             "(.h5) that points take in turn; the path starts at the input's "
             "folder; Source = file only");
  table.integer("Seed",
                1,
                0,
                "Of the random numbers of the run; every material point has "
                "its own, made from this and its number");
  table.quantity("Initial relative density",
                 "0.35",
                 dimension::number,
                 {0.05, 0.38, false, false},
                 "Of the loose random start, before compression");
  table.choice("Compression",
               "isotropic",
               compressions,
               "How loose packings are compressed: alike in all directions, or "
               "along the die axis z with the sides held, as a die is filled");
  table.choice(
      "Method",
      "quasi-static",
      methods,
      "How grains follow the compression: through equilibria, or by the "
      "damped motion of section Cell, in which they hit each other on "
      "the way; dynamics: isotropic compression to a pressure only");
  table.choice("Target",
               "pressure",
               targets,
               "What tells that a packing is dense enough");
  table.quantity("Pressure",
                 "100 kPa",
                 dimension::pressure,
                 positive,
                 "At which packings are handed over, mean stress or, uniaxial, "
                 "axial stress; at least 0.5 MPa for a die; Target = pressure");
  table.quantity("Relative density",
                 "0.6",
                 dimension::number,
                 {0, 1, true, true},
                 "At which packings are handed over; Target = relative "
                 "density");
  table.quantity("Cell shape",
                 "0",
                 dimension::number,
                 not_negative,
                 "Height (z) over width of the loose start; 0: such that the "
                 "packing is about cubic, and taller if it is of so few grains "
                 "that it would become too low at full density");
  table.quantity("Friction during packing",
                 "-1",
                 dimension::number,
                 {-1, 10, false, false},
                 "mu while packing; negative: as between grains. Less friction "
                 "packs denser");
  table.flag("Same at all points",
             false,
             "All material points start from the same packing");
  table.integer(
      "Different packings",
      0,
      0,
      "Of a die, which its points take in turn, in the order of their "
      "numbers; 0: one for each point, or all of a folder");
  table.integer("Sample",
                0,
                0,
                "Number of the run's packing that a probe takes, or the "
                "first point of a die: point N of a die is sample N of a "
                "probe with the same seed");
  table.integer("Replicas",
                1,
                1,
                "Packings that tamp pack makes; the first is number Sample");
  table.leave();
}

std::filesystem::path size_table(const ParameterTable &table,
                                 const std::string &path)
{
  const std::string name = table.word(path);
  if (name.empty())
    table.complain(path,
                   "the distribution 'table' needs a file with diameters and "
                   "shares");
  const auto file = table.folder(path) / name;
  if (!std::filesystem::is_regular_file(file))
    table.complain(path, "there is no file '" + file.string() + "'");
  return file;
}

// The sizes of a kind of grains, `section` with its slash.
dem::GrainSizes read_sizes(const ParameterTable &table,
                           const std::string &section)
{
  const auto distribution = chosen<dem::SizeDistribution>(
      table, section + "Diameter distribution", distributions);
  if (distribution == dem::SizeDistribution::table)
    return read_size_table(size_table(table, section + "Size table"));
  dem::GrainSizes sizes;
  sizes.distribution = distribution;
  sizes.minimum_diameter = table.number(section + "Minimum diameter");
  sizes.maximum_diameter = table.number(section + "Maximum diameter");
  sizes.mean_diameter = table.number(section + "Mean diameter");
  sizes.standard_deviation = table.number(section + "Standard deviation");
  if (sizes.minimum_diameter > sizes.maximum_diameter)
    table.complain(section + "Minimum diameter",
                   fmt::format("it is above {}Maximum diameter = {}",
                               section,
                               table.word(section + "Maximum diameter")));
  if (distribution == dem::SizeDistribution::uniform) {
    sizes.mean_diameter =
        0.5 * (sizes.minimum_diameter + sizes.maximum_diameter);
  } else if (sizes.mean_diameter <= sizes.minimum_diameter ||
             sizes.mean_diameter >= sizes.maximum_diameter) {
    table.complain(section + "Mean diameter",
                   "expected a diameter between the minimum, " +
                       table.word(section + "Minimum diameter") +
                       ", and the maximum, " +
                       table.word(section + "Maximum diameter"));
  }
  return sizes;
}

dem::GrainMaterial read_solid(const ParameterTable &table,
                              const std::string &section)
{
  dem::GrainMaterial solid;
  solid.youngs_modulus = table.number(section + "Young's modulus");
  solid.poissons_ratio = table.number(section + "Poisson's ratio");
  solid.density = table.number(section + "Density");
  return solid;
}

// The stored packings of the run; none if they are generated.
std::vector<std::filesystem::path> read_files(const ParameterTable &table)
{
  namespace fs = std::filesystem;
  const std::string name = table.word("Packing/File");
  const bool from_file = table.word("Packing/Source") == "file";
  if (name.empty() && from_file)
    table.complain("Packing/Source", "expected Packing/File to name a packing");
  if (name.empty())
    return {};
  if (!from_file)
    table.complain("Packing/File",
                   "it needs Packing/Source = file, which is " +
                       table.word("Packing/Source"));
  const fs::path path = table.folder("Packing/File") / name;
  if (!fs::exists(path))
    table.complain("Packing/File",
                   "there is no file '" + path.string() +
                       "'; expected a packing (.h5, or x y z r as text)");
  if (!fs::is_directory(path))
    return {path};
  std::vector<fs::path> files;
  for (const auto &entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".h5")
      files.push_back(entry.path());
  std::ranges::sort(files);
  if (files.empty())
    table.complain("Packing/File",
                   "there is no packing (.h5) in the folder '" + path.string() +
                       "'");
  return files;
}
} // namespace

void declare_grains(ParameterTable &table)
{
  declare_sizes(table);
  declare_contact(table);
  declare_packing(table);
  declare_cell(table);
}

void read_grains(const ParameterTable &table,
                 coupling::MaterialChoice &material)
{
  dem::PackingRequest &packing = material.packing;
  packing.grain_count = static_cast<std::size_t>(table.whole("Grains/Count"));
  packing.sizes = read_sizes(table, "Grains/");
  packing.material = read_solid(table, "Grains/");
  packing.material.limiting_pressure =
      table.number("Contact/Limiting contact pressure");
  packing.material.adjusted_pressures = read_adjusted_pressures(table);
  const std::string other = fmt::format("Grains/{}/", second);
  if (const double share = table.number(other + "Number share"); share > 0) {
    packing.others = {
        {share, read_sizes(table, other), read_solid(table, other)}};
    packing.others[0].material.limiting_pressure =
        table.number(other + "Limiting contact pressure");
  }
  read_contact(table, packing.contact);

  packing.seed = static_cast<std::uint64_t>(table.whole("Packing/Seed"));
  packing.initial_relative_density =
      table.number("Packing/Initial relative density");
  packing.goal.compression =
      chosen<dem::Compression>(table, "Packing/Compression", compressions);
  packing.goal.target =
      chosen<dem::CompressionTarget>(table, "Packing/Target", targets);
  packing.goal.pressure = table.number("Packing/Pressure");
  packing.goal.relative_density = table.number("Packing/Relative density");
  packing.edge_ratio = table.number("Packing/Cell shape");
  packing.friction_during_packing =
      table.number("Packing/Friction during packing");

  material.packing_files = read_files(table);
  material.packings =
      static_cast<std::size_t>(table.whole("Packing/Different packings"));
  if (table.on("Packing/Same at all points")) {
    if (material.packings > 1)
      table.complain("Packing/Different packings",
                     "it needs Packing/Same at all points = false");
    material.packings = 1;
  }
  material.first_packing =
      static_cast<std::size_t>(table.whole("Packing/Sample"));

  read_cell(table, material.driving);
  if (table.word("Packing/Method") == "dynamics")
    packing.dynamics = material.driving.dynamics;
  material.warm = table.on("Cell/Warm start");
}
} // namespace tamp::apps
