// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/surface_plots.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <string>

namespace tamp::apps
{
namespace
{
constexpr const char *surface_plot = R"(set title "{}"
set xlabel "{}"
set ylabel "{}"
set key rmargin vertical title "density"
p = "pressure[Pa]"
q = "deviatoric_stress[Pa]"
unit(row) = {}
at(number, name) = column("level[-]") == number ? column(name) / unit(0) : NaN
set xrange [0:*]
set yrange [0:*]
chosen = "{}"
level(k) = word(chosen, k) + 0
plot {}for [k=1:words(chosen)] "surfaces.csv" using (at(level(k), p)):(at(level(k), q)) with lines linewidth 3 linecolor k title word("{}", level(k) + 1), \
     for [k=1:words(chosen)] "points.csv" using (column("kind[-]") == 0 ? at(level(k), p) : NaN):(at(level(k), q)) with points pointtype 7 linecolor k pointsize 1.2 notitle, \
     for [k=1:words(chosen)] "points.csv" using (column("kind[-]") == 1 ? at(level(k), p) : NaN):(at(level(k), q)) with points pointtype 6 linecolor k pointsize 1.6 linewidth 2 notitle
)";

constexpr const char *band_plot =
    R"(for [k=1:words(chosen)] "bands.csv" using (at(level(k), p)):(at(level(k), q)) with filledcurves closed linecolor k fillstyle transparent solid 0.25 noborder notitle, \
     )";

bool has_bands(const std::vector<SurfacePicture> &surfaces)
{
  return std::ranges::any_of(surfaces, [](const SurfacePicture &surface) {
    return !surface.band.empty();
  });
}

Plot drawn(const std::vector<SurfacePicture> &surfaces, bool normalised)
{
  // First and last among them.
  std::string numbers, names;
  const std::size_t last = surfaces.size() - 1;
  const std::size_t count = std::min<std::size_t>(6, surfaces.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = count > 1 ? k * last / (count - 1) : 0;
    numbers += fmt::format("{} ", i);
  }
  for (const SurfacePicture &surface : surfaces)
    names += fmt::format("{:.3f} ", surface.density);
  return {normalised ? "yield_surfaces_normalised" : "yield_surfaces",
          fmt::format(fmt::runtime(surface_plot),
                      normalised
                          ? "Yield surfaces over their yield pressure"
                          : "Yield surfaces (open circles: uniaxial path)",
                      normalised ? "p / p_b [-]" : "pressure p [MPa]",
                      normalised ? "q / p_b [-]" : "deviatoric stress q [MPa]",
                      normalised ? "column(\"yield_pressure[Pa]\")" : "1e6",
                      numbers,
                      has_bands(surfaces) ? band_plot : "",
                      names)};
}
} // namespace

void write_surfaces(const RunFolder &folder,
                    const std::vector<SurfacePicture> &surfaces)
{
  const auto plots = folder.subfolder("plots");
  const std::vector<std::string> header{"level[-]",
                                        "pressure[Pa]",
                                        "deviatoric_stress[Pa]",
                                        "yield_pressure[Pa]"};
  CurveWriter lines(plots / "surfaces.csv", header);
  std::vector<std::string> with_kind = header;
  with_kind.emplace_back("kind[-]");
  CurveWriter points(plots / "points.csv",
                     with_kind,
                     {"kind: 0 yield of a branch, 1 uniaxial path"});
  std::optional<CurveWriter> bands;
  if (has_bands(surfaces))
    bands.emplace(plots / "bands.csv",
                  header,
                  std::vector<std::string>{
                      "around the surfaces of fits to single replicas"});
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const SurfacePicture &surface = surfaces[i];
    const auto number = static_cast<double>(i);
    for (const StressPoint &at : surface.band)
      bands->write(std::array{number, at.p, at.q, surface.yield_pressure});
    for (const StressPoint &at : surface.line)
      lines.write(std::array{number, at.p, at.q, surface.yield_pressure});
    for (const StressPoint &at : surface.yields)
      points.write(std::array{number, at.p, at.q, surface.yield_pressure, 0.});
    for (const StressPoint &at : surface.uniaxial)
      points.write(std::array{number, at.p, at.q, surface.yield_pressure, 1.});
  }
}

std::vector<Plot> surface_plots(const std::vector<SurfacePicture> &surfaces)
{
  return {drawn(surfaces, false), drawn(surfaces, true)};
}
} // namespace tamp::apps
