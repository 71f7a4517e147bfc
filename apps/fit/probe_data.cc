// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/probe_data.h>
#include <apps/input/csv_reader.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <string>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;
using Column = CsvReader::Column;

/// Fewer states of loading say nothing about a curve.
constexpr std::size_t fewest_states = 5;

/// A line of curve.csv.
struct CurveLine {
  PathPoint point;
  double lateral_strain = 0; ///< the larger one, without sign
};

std::vector<CurveLine> read_curve(const fs::path &file)
{
  CsvReader reader(file, "curve of a probe");
  const auto pure = dimension::number;
  const Column density = reader.column("relative_density", pure),
               xx = reader.column("strain_xx", pure),
               yy = reader.column("strain_yy", pure),
               zz = reader.column("strain_zz", pure),
               p = reader.column("pressure", dimension::pressure),
               q = reader.column("deviatoric_stress", dimension::pressure),
               axial = reader.column("stress_zz", dimension::pressure);
  std::vector<CurveLine> lines;
  while (reader.next()) {
    CurveLine line{
        {reader.number(density),
         reader.number(p),
         reader.number(q),
         reader.number(zz),
         reader.number(axial)},
        std::max(std::abs(reader.number(xx)), std::abs(reader.number(yy)))};
    if (!(line.point.relative_density > 0))
      reader.complain(fmt::format("'{}': expected a relative density above 0",
                                  reader.text(density)));
    lines.push_back(line);
  }
  if (lines.size() < fewest_states)
    reader.complain(fmt::format("the curve has {} states; expected at least {}",
                                lines.size(),
                                fewest_states));
  return lines;
}

Loading loading_of(const fs::path &file, const CurveLine &end)
{
  if (end.lateral_strain <= 1e-3 * std::abs(end.point.axial_strain) + 1e-9)
    return Loading::uniaxial;
  if (end.point.deviatoric_stress < 0.1 * end.point.pressure)
    return Loading::isotropic;
  throw InputError(fmt::format(
      "'{}': at its largest axial stress the lateral strain is {:.3g} and q / "
      "p "
      "is {:.3g}; expected uniaxial loading (no lateral strain) or isotropic "
      "loading (q / p below 0.1)",
      file.string(),
      end.lateral_strain,
      end.point.deviatoric_stress / end.point.pressure));
}

void take_curve(const fs::path &file, ProbeData &probe)
{
  const auto lines = read_curve(file);
  const auto peak = std::ranges::max_element(
      lines, {}, [](const CurveLine &line) { return line.point.axial_stress; });
  if (!(peak->point.pressure > 0))
    throw InputError(
        fmt::format("'{}': the powder carries no pressure", file.string()));
  probe.loading = loading_of(file, *peak);
  double densest = 0;
  for (auto line = lines.begin(); line <= peak; ++line)
    if (line->point.relative_density > densest) {
      densest = line->point.relative_density;
      probe.curve.push_back(line->point);
    }
  if (probe.curve.size() < fewest_states)
    throw InputError(
        fmt::format("'{}': the powder becomes denser in {} states of loading; "
                    "expected at least {}",
                    file.string(),
                    probe.curve.size(),
                    fewest_states));
  probe.unloading.push_back(peak->point);
  for (auto line = peak + 1; line != lines.end(); ++line) {
    if (!(line->point.axial_stress < probe.unloading.back().axial_stress))
      break;
    probe.unloading.push_back(line->point);
  }
}

void take_yields(const fs::path &file, ProbeData &probe)
{
  CsvReader reader(file, "table of yield points");
  const auto pure = dimension::number, stress = dimension::pressure;
  const Column replica = reader.column("replica", pure),
               density = reader.column("relative_density", pure),
               reached_p = reader.column("reached_pressure", stress),
               reached_q = reader.column("reached_deviatoric_stress", stress),
               branch = reader.column("branch", pure),
               criterion = reader.column("criterion", pure),
               p = reader.column("pressure", stress),
               q = reader.column("deviatoric_stress", stress),
               volume = reader.column("plastic_volumetric_strain", pure),
               shear = reader.column("plastic_shear_strain", pure);
  while (reader.next())
    probe.yields.push_back({static_cast<int>(reader.number(replica)),
                            reader.number(density),
                            reader.number(reached_p),
                            reader.number(reached_q),
                            static_cast<int>(reader.number(branch)),
                            static_cast<int>(reader.number(criterion)),
                            reader.number(p),
                            reader.number(q),
                            reader.number(volume),
                            reader.number(shear)});
  if (probe.yields.empty())
    reader.complain("the table has no yield points");
}

void take_moduli(const fs::path &file, ProbeData &probe)
{
  CsvReader reader(file, "table of moduli");
  const Column replica = reader.column("replica", dimension::number),
               density = reader.column("relative_density", dimension::number),
               bulk = reader.column("bulk_modulus", dimension::pressure),
               shear = reader.column("shear_modulus", dimension::pressure);
  while (reader.next()) {
    probe.moduli.push_back({static_cast<int>(reader.number(replica)),
                            reader.number(density),
                            reader.number(bulk),
                            reader.number(shear)});
    if (!(probe.moduli.back().bulk_modulus > 0 &&
          probe.moduli.back().shear_modulus > 0))
      reader.complain("expected moduli above zero");
  }
  if (probe.moduli.empty())
    reader.complain("the table has no moduli");
}
} // namespace

ProbeData read_probe(const fs::path &folder)
{
  if (!fs::is_directory(folder))
    throw InputError(fmt::format(
        "there is no folder '{}'; expected one that tamp probe has written",
        folder.string()));
  ProbeData probe;
  probe.folder = folder;
  take_curve(folder / "curve.csv", probe);
  if (fs::exists(folder / "yield.csv"))
    take_yields(folder / "yield.csv", probe);
  if (fs::exists(folder / "moduli.csv"))
    take_moduli(folder / "moduli.csv", probe);
  return probe;
}

std::vector<fs::path> cells_of(const fs::path &folder)
{
  const std::string mark = "size_";
  std::map<std::string, std::vector<fs::path>> by_size;
  if (fs::exists(folder / "replicas.csv"))
    for (const auto &entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(mark) && fs::exists(entry.path() / "curve.csv"))
        by_size[name.substr(0, name.find('_', mark.size()))].push_back(
            entry.path());
    }
  if (by_size.empty())
    return {folder};
  auto &largest = by_size.rbegin()->second;
  std::ranges::sort(largest);
  return largest;
}

std::vector<fs::path> probe_files(const fs::path &folder)
{
  std::vector<fs::path> files;
  for (const char *name : {"curve.csv", "yield.csv", "moduli.csv"})
    if (fs::exists(folder / name))
      files.push_back(folder / name);
  return files;
}

ModuliPoint moduli_of_unloading(const ProbeData &probe, double share)
{
  ModuliPoint moduli;
  if (probe.loading != Loading::uniaxial || probe.unloading.size() < 2)
    return moduli;
  const PathPoint &peak = probe.unloading.front();
  PathPoint end = peak;
  for (const PathPoint &point : probe.unloading)
    if (point.axial_stress >= share * peak.axial_stress)
      end = point;
  const double strain = peak.axial_strain - end.axial_strain;
  if (!(strain > 0))
    return moduli;
  moduli.relative_density = peak.relative_density;
  moduli.bulk_modulus = (peak.pressure - end.pressure) / strain;
  // q with its sign, which turns where the lateral stress becomes the larger.
  const auto q = [](const PathPoint &point) {
    return 1.5 * (point.axial_stress - point.pressure);
  };
  moduli.shear_modulus = (q(peak) - q(end)) / (2 * strain);
  return moduli;
}
} // namespace tamp::apps
