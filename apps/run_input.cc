// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input_sections.h>
#include <apps/parameter_table.h>
#include <apps/run_input.h>

#include <algorithm>
#include <fmt/format.h>

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
             "unload to strain E, stress S or R % of peak; triaxial to strain "
             "E at pressure P; proportional K to strain E; shear to strain E; "
             "components xx strain E yy stress S ...; hold N steps; or csv "
             "FILE alone with F of every increment. Strains are logarithmic");
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
  } catch (const InputError &error) {
    table.complain(path, error.what());
  }
  auto &gradients = input.path.gradients;
  if (!gradients.empty()) {
    gradients = table.folder(path) / gradients;
    if (!std::filesystem::is_regular_file(gradients))
      table.complain(path, "there is no file '" + gradients.string() + "'");
    try {
      read_gradients(gradients);
    } catch (const InputError &error) {
      table.complain(path, error.what());
    }
  }
  input.stress_tolerance = table.number("Path/Stress tolerance");
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
  output.plot_formats = table.words("Output/Plot format");
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
  declare_die(table);
  declare_output(table);
}

RunInput read_input(const ParameterTable &table, Need need)
{
  RunInput input;
  read_grains(table, input.material);
  read_output(table, input.output);
  const bool everything = need == Need::everything;
  if (everything || need == Need::contact)
    input.pair = read_pair(
        table, input.material.packing.material, input.material.packing.contact);
  if (need == Need::contact)
    return input;
  read_material(table, input.material);
  if (everything || need == Need::probe)
    read_path(table, input);
  if (everything || need == Need::die)
    check_grain_points(
        table, input, read_die(table, input.material.kind, input.die));
  return input;
}
} // namespace tamp::apps
