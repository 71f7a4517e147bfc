// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/density_field.h>
#include <apps/input/input_sections.h>
#include <apps/input/parameter_table.h>
#include <apps/input/run_input.h>
#include <apps/input/start_density.h>

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
namespace
{
void declare_path(ParameterTable &table)
{
  table.enter("Path");
  table.text("Stages",
             "uniaxial to strain 0.15; unload to 1 % of peak",
             "Divided by semicolons, compression positive, axis z: isotropic "
             "to strain E or pressure P; uniaxial to strain E or stress S; "
             "unload to strain E, stress S or R % of peak; triaxial to "
             "strain E at pressure P; proportional K to strain E; pure shear "
             "'shear to strain E'; simple shear to strain G; constant-p shear "
             "or compression to strain E at pressure P ("
             "'by strain E': since the start of the stage); components xx "
             "strain E yy stress S "
             "...; hold N steps; csv FILE with F of every increment. Strains "
             "are logarithmic");
  table.quantity("Maximum strain increment",
                 "5e-3",
                 dimension::number,
                 {0, 0.1, true, false},
                 "While loading");
  table.quantity("Maximum unloading increment",
                 "1e-3",
                 dimension::number,
                 {0, 0.1, true, false},
                 "While unloading");
  table.quantity("Stress tolerance",
                 "1e-3",
                 dimension::number,
                 {0, 0.1, true, false},
                 "Of components whose stress is given, over the largest "
                 "stress");
  table.leave();
}

void declare_output(ParameterTable &table)
{
  table.enter("Output");
  table.integer("Field interval", 5, 1, "Steps between fields on disk; die");
  table.choice("Grain output",
               "chosen points",
               {"none", "chosen points", "all"},
               "Whose grains and force chains are written");
  table.integers("Grain points", "0", "Numbers of the chosen material points");
  table.integer("Grain interval", 5, 1, "Steps between grains on disk");
  table.integer("Bias interval",
                10,
                0,
                "Steps of a die after which a few unit cells are asked again, "
                "driven more finely, and what their stress was off by goes to "
                "the log and the summary; 0: never");
  table.quantity("Checkpoint interval",
                 "10 min",
                 dimension::time,
                 not_negative,
                 "Wall time between checkpoints of a die or a probe, with "
                 "which --resume goes on; 0: at SIGINT, SIGTERM and SIGUSR1 "
                 "only");
  table.choices("Plot format",
                "svg, png",
                {"svg", "png", "pdf"},
                "Files that plots are drawn to");
  table.leave();
}

void read_path(const ParameterTable &table, RunInput &input)
{
  const std::string path = "Path/Stages";
  try {
    input.path = parse_path(table.word(path),
                            {table.number("Path/Maximum strain increment"),
                             table.number("Path/Maximum unloading increment")});
    read_files(input.path, table.folder(path));
  } catch (const InputError &error) {
    table.complain(path, error.what());
  }
  input.stress_tolerance = table.number("Path/Stress tolerance");
  input.scan = read_scan(table);
}

void read_output(const ParameterTable &table, OutputSettings &output)
{
  output.field_interval =
      static_cast<unsigned>(table.whole("Output/Field interval"));
  output.grain_interval =
      static_cast<unsigned>(table.whole("Output/Grain interval"));
  const std::string grains = table.word("Output/Grain output");
  output.grain_output = grains == "none"  ? GrainOutput::none
                        : grains == "all" ? GrainOutput::all
                                          : GrainOutput::chosen_points;
  output.grain_points = table.indices("Output/Grain points");
  std::ranges::sort(output.grain_points);
  const auto repeated = std::ranges::unique(output.grain_points);
  output.grain_points.erase(repeated.begin(), repeated.end());
  output.bias_interval =
      static_cast<unsigned>(table.whole("Output/Bias interval"));
  output.checkpoint_interval = table.number("Output/Checkpoint interval");
  output.plot_formats = table.words("Output/Plot format");
}

// What only the packing itself can judge, such as its cell's width.
void check_packing(const ParameterTable &table,
                   const coupling::MaterialChoice &material)
{
  if (!material.packing_files.empty())
    return;
  try {
    material.packing.check();
  } catch (const std::invalid_argument &error) {
    const std::string problem = error.what();
    for (const auto &[begin, path] :
         {std::pair("grain count", "Grains/Count"),
          std::pair("edge ratio", "Packing/Cell shape"),
          std::pair("relative density of", "Packing/Relative density"),
          std::pair("packing by dynamics", "Packing/Method")})
      if (problem.starts_with(begin))
        table.complain(path, problem);
    throw InputError(problem);
  }
}

void read_replicas(const ParameterTable &table, Need need, RunInput &input)
{
  input.replicas = static_cast<std::size_t>(table.whole("Packing/Replicas"));
  const std::size_t starts = input.material.packing_files.size();
  if (need == Need::pack && starts > 0 && input.replicas > starts)
    table.complain("Packing/Replicas",
                   fmt::format("packings of a file are the same every time; "
                               "expected at most as many as Packing/File "
                               "names, {}",
                               starts));
}

std::vector<std::filesystem::path> files_of(const ParameterTable &table,
                                            const RunInput &input)
{
  std::vector<std::filesystem::path> files = input.material.packing_files;
  for (const ProbeStage &stage : input.path.stages)
    if (!stage.file.empty())
      files.push_back(stage.file);
  if (!input.die.geometry.mesh_file.empty())
    files.emplace_back(input.die.geometry.mesh_file);
  if (const std::string path = "Die/Initial density file";
      !input.material.densities.empty() && !table.word(path).empty())
    files.push_back(table.folder(path) / table.word(path));
  for (const std::string section : {"Grains/", "Grains/Second species/"})
    if (const std::string path = section + "Size table";
        !table.word(path).empty())
      files.push_back(table.folder(path) / table.word(path));
  return files;
}

void check_start(const ParameterTable &table, const RunInput &input)
{
  std::optional<double> density = start_density(input.material);
  if (!input.material.densities.empty())
    density = std::ranges::max(input.material.densities);
  if (!density)
    return;
  try {
    input.die.check_start(*density);
  } catch (const std::invalid_argument &error) {
    table.complain("Schedule/Stages", error.what());
  }
}

void read_densities(const ParameterTable &table, RunInput &input)
{
  coupling::MaterialChoice &material = input.material;
  material.densities = read_density_field(table, input.mesh.mesh);
  if (material.densities.empty())
    return;
  const std::string path = density_entry(table);
  if (material.kind == coupling::MaterialKind::modified_cam_clay)
    table.complain(path,
                   "the state of modified Cam-Clay does not follow from its "
                   "density; expected another material");
  if (material.kind != coupling::MaterialKind::unit_cell)
    return;
  if (!material.packing_files.empty() || material.packings > 0)
    table.complain(
        path,
        "every point needs a packing of its own: neither files, nor "
        "Packing/Same at all points, nor Packing/Different packings");
  dem::PackingRequest request = material.packing;
  request.goal.target = dem::CompressionTarget::relative_density;
  for (const double density : material.densities)
    try {
      request.goal.relative_density = density;
      request.check();
    } catch (const std::invalid_argument &error) {
      table.complain(path, error.what());
    }
}

void check_grain_points(const ParameterTable &table,
                        const RunInput &input,
                        std::size_t count)
{
  const OutputSettings &output = input.output;
  if (input.material.kind != coupling::MaterialKind::unit_cell ||
      output.grain_output != GrainOutput::chosen_points)
    return;
  for (const std::size_t point : output.grain_points)
    if (point >= count)
      table.complain("Output/Grain points",
                     fmt::format("there is no point {}; expected numbers from "
                                 "0 to {}",
                                 point,
                                 count - 1));
}
} // namespace

void declare_parameters(ParameterTable &table)
{
  declare_grains(table);
  declare_pair(table);
  declare_material(table);
  declare_path(table);
  declare_scan(table);
  declare_die_shape(table);
  declare_press(table);
  declare_output(table);
}

RunInput read_input(const ParameterTable &table, Need need)
{
  RunInput input;
  read_grains(table, input.material);
  const bool everything = need == Need::everything;
  read_output(table, input.output);
  if (everything || need == Need::contact)
    input.pair = read_pair(
        table, input.material.packing.material, input.material.packing.contact);
  if (need == Need::contact)
    return input;
  read_material(table, input.material);
  if (need == Need::pack ||
      input.material.kind == coupling::MaterialKind::unit_cell)
    check_packing(table, input.material);
  if (everything || need == Need::probe)
    read_path(table, input);
  // A point of a die that is filled unevenly needs its place.
  const bool uneven = !density_entry(table).empty();
  if (everything || need == Need::die || (need == Need::point && uneven)) {
    read_die_shape(table, input.die);
    input.mesh = read_press(table, input.material, input.die);
    read_densities(table, input);
    check_start(table, input);
    check_grain_points(table, input, input.mesh.mesh.number_of_points());
  }
  if (need != Need::point)
    read_replicas(table, need, input);
  input.files = files_of(table, input);
  return input;
}
} // namespace tamp::apps
