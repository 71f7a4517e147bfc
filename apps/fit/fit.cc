// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_report.h>
#include <apps/fit/constants_report.h>
#include <apps/fit/fit.h>
#include <apps/fit/law_names.h>
#include <apps/input/units.h>

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <set>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

std::string name_of(const fs::path &folder)
{
  const auto path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::string names_of(const FitRequest &request)
{
  std::vector<std::string> names;
  for (const auto &folder : request.folders)
    names.push_back(name_of(folder));
  return fmt::format("{}", fmt::join(names, " "));
}

std::vector<ProbeData> read_probes(const FitRequest &request)
{
  std::set<fs::path> different;
  std::vector<ProbeData> probes;
  for (const auto &folder : request.folders)
    for (const auto &cell : cells_of(folder)) {
      probes.push_back(read_probe(cell));
      if (!different.insert(fs::canonical(cell)).second)
        throw InputError(
            fmt::format("the folder '{}' is named twice", cell.string()));
    }
  if (request.moduli == ModuliSource::unloading)
    take_unloading_moduli(probes);
  return probes;
}

std::vector<fs::path> files_of(const std::vector<ProbeData> &probes)
{
  std::vector<fs::path> files;
  for (const ProbeData &probe : probes)
    std::ranges::copy(probe_files(probe.folder), std::back_inserter(files));
  return files;
}

std::vector<std::string> sentences_on(const FitRequest &request,
                                      const LawNames &law)
{
  std::vector<std::string> sentences{fmt::format(
      "{} fitted by tamp fit to {}.", law.subsection, names_of(request))};
  if (request.moduli == ModuliSource::unloading)
    sentences.emplace_back(
        "Elastic moduli are secants of the whole unloading of the uniaxial "
        "path (--moduli unloading): right at its end, too soft where it "
        "begins.");
  return sentences;
}

// Grains slide long before their packing fails: an irreversible strain may be
// reached below the state on the uniaxial path, and then no cap is possible.
CapFit fit_some_cap(const std::vector<ProbeData> &probes,
                    const std::optional<YieldCriterion> &criterion)
{
  if (criterion)
    return fit_cap(probes, *criterion);
  try {
    return fit_cap(probes, YieldCriterion::strain);
  } catch (const InputError &problem) {
    try {
      CapFit fit = fit_cap(probes, YieldCriterion::peak);
      fit.remarks.emplace_back(
          "yield by irreversible strain is below the states on the uniaxial "
          "path: shear lines were drawn through peaks (--criterion peak)");
      return fit;
    } catch (const InputError &) {
      throw problem;
    }
  }
}
} // namespace

std::vector<std::string> fitted_laws()
{
  std::vector<std::string> names;
  for (const LawNames &known : law_names)
    names.emplace_back(known.law);
  return names;
}

int run_fit(const FitRequest &request, const RunOptions &options)
{
  const auto law = std::ranges::find(law_names, request.law, &LawNames::law);
  if (law == law_names.end())
    throw InputError(fmt::format("there is no law '{}' to fit", request.law));
  if (law->kind == coupling::MaterialKind::modified_cam_clay &&
      request.moduli == ModuliSource::unloading)
    throw InputError(
        "--moduli unloading: expected a law whose elasticity depends on "
        "density alone; that of Cam-Clay falls with pressure by itself");
  const std::vector<ProbeData> probes = read_probes(request);
  RunOptions chosen = options;
  if (chosen.output.empty())
    chosen.output = request.folders.front() / "fit" / request.law;
  const auto give = [&](const auto &fit, auto report) {
    RunSession session("fit", chosen, names_of(request), files_of(probes));
    return session.run([&]() -> RunEnd {
      report(fit, FitReport{probes, sentences_on(request, *law), session});
      return {};
    });
  };
  if (law->kind == coupling::MaterialKind::drucker_prager_cap)
    return give(fit_some_cap(probes, request.criterion), report_cap);
  return give(fit_constants(law->kind,
                            probes,
                            request.criterion.value_or(YieldCriterion::strain)),
              report_constants);
}
} // namespace tamp::apps
