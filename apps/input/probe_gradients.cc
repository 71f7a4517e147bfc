// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_line.h>
#include <apps/input/probe_path.h>
#include <apps/input/stage_reader.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <optional>

namespace tamp::apps
{
namespace
{
// Which columns of a CSV file hold the nine components, and of what.
struct GradientColumns {
  std::array<std::size_t, 9> place{0, 1, 2, 3, 4, 5, 6, 7, 8};
  std::size_t count = 9;
  bool relative = false;
};

// The values of a line, which may end with a comma.
std::vector<std::string> cells_of(const std::string &line)
{
  std::vector<std::string> cells = fields_of(line);
  if (cells.back().empty())
    cells.pop_back();
  return cells;
}

// None if a component is missing.
std::optional<GradientColumns> columns_of(const std::vector<std::string> &names)
{
  for (const std::string prefix : {"relative_F_", "F_"}) {
    GradientColumns columns{.count = names.size(), .relative = prefix != "F_"};
    unsigned found = 0;
    for (unsigned i = 0; i < 9; ++i) {
      const std::string name = prefix + "xyz"[i / 3] + "xyz"[i % 3];
      const auto place =
          std::ranges::find_if(names, [&](const std::string &column) {
            return column == name || column == name + "[-]";
          });
      if (place != names.end()) {
        columns.place[i] =
            static_cast<std::size_t>(std::distance(names.begin(), place));
        ++found;
      }
    }
    if (found == 9)
      return columns;
  }
  return {};
}

// None if the line is not what the columns promise.
std::optional<dealii::Tensor<2, 3>>
gradient_of(const std::vector<std::string> &cells,
            const GradientColumns &columns)
{
  if (cells.size() != columns.count)
    return {};
  dealii::Tensor<2, 3> F;
  for (unsigned i = 0; i < 9; ++i) {
    const auto value = number_of(cells[columns.place[i]]);
    if (!value)
      return {};
    F[i / 3][i % 3] = *value;
  }
  if (!(determinant(F) > 0))
    return {};
  return F;
}
} // namespace

GradientPath read_gradients(const std::filesystem::path &file)
{
  std::ifstream in(file);
  if (!std::filesystem::is_regular_file(file) || !in)
    throw InputError(
        fmt::format("the file '{}' with the deformation gradients is missing",
                    file.string()));
  GradientPath path;
  GradientColumns columns;
  std::string line;
  for (unsigned number = 1; std::getline(in, line); ++number) {
    const std::string text(trimmed(line));
    if (text.empty() || text.front() == '#')
      continue;
    const auto refuse = [&](const char *expected) {
      throw InputError(fmt::format(
          "{}:{}: '{}': expected {}", file.string(), number, text, expected));
    };
    const std::vector<std::string> cells = cells_of(text);
    if (path.gradients.empty() && text.find("F_") != std::string::npos) {
      const auto named = columns_of(cells);
      if (!named)
        refuse("columns F_xx[-], F_xy[-] ... F_zz[-] or relative_F_xx[-] ...");
      columns = *named;
      continue;
    }
    const auto F = gradient_of(cells, columns);
    if (!F)
      refuse("nine numbers F_xx, F_xy ... F_zz with det F > 0");
    path.gradients.push_back(*F);
  }
  if (path.gradients.empty())
    throw InputError(file.string() + ": there is no deformation gradient");
  path.relative = columns.relative;
  return path;
}

void read_files(ProbePath &path, const std::filesystem::path &folder)
{
  for (ProbeStage &probe : path.stages) {
    if (probe.file.empty())
      continue;
    probe.file = folder / probe.file;
    GradientPath read = read_gradients(probe.file);
    if (read.relative && path.stages.size() == 1) {
      path.increments = std::move(read.gradients);
      continue;
    }
    if (read.relative)
      for (std::size_t i = 1; i < read.gradients.size(); ++i)
        read.gradients[i] = read.gradients[i] * read.gradients[i - 1];
    probe.stage.gradients = std::move(read.gradients);
  }
}
} // namespace tamp::apps
