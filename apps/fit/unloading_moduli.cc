// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/plastic_density.h>
#include <apps/fit/unloading_moduli.h>
#include <apps/input/units.h>

#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tamp::apps
{
namespace
{
/// What secants of an unloading are of the moduli of small probes.
struct Softening {
  double bulk = 0, shear = 0; ///< sums of logarithms over `count` folders
  unsigned count = 0;
};

std::optional<ModuliPoint> secants_of(const ProbeData &probe)
{
  const ModuliPoint secants = moduli_of_unloading(probe, 0);
  if (!(secants.relative_density > 0))
    return {};
  if (!(secants.bulk_modulus > 0 && secants.shear_modulus > 0))
    throw InputError(fmt::format(
        "'{}': the unloading gives K = {:.4g} MPa and G = {:.4g} MPa; expected "
        "both above 0 with --moduli unloading",
        (probe.folder / "curve.csv").string(),
        secants.bulk_modulus / 1e6,
        secants.shear_modulus / 1e6));
  return secants;
}

void soften(std::vector<ModuliPoint> &rows, const Softening &by)
{
  for (ModuliPoint &row : rows) {
    row.bulk_modulus *= std::exp(by.bulk / by.count);
    row.shear_modulus *= std::exp(by.shear / by.count);
  }
}
} // namespace

void take_unloading_moduli(std::vector<ProbeData> &probes)
{
  Softening mean;
  bool unloaded = false;
  std::vector<ProbeData *> others;
  for (ProbeData &probe : probes) {
    const auto secants = secants_of(probe);
    unloaded |= secants.has_value();
    if (secants && probe.moduli.empty())
      probe.moduli.push_back(*secants);
    else if (secants) {
      const ModuliPoint small =
          PathElasticity(probe.moduli).at(secants->relative_density);
      const Softening own{
          std::log(secants->bulk_modulus / small.bulk_modulus),
          std::log(secants->shear_modulus / small.shear_modulus),
          1};
      soften(probe.moduli, own);
      mean.bulk += own.bulk;
      mean.shear += own.shear;
      ++mean.count;
    } else
      others.push_back(&probe);
  }
  if (!unloaded)
    throw InputError(
        "--moduli unloading: no uniaxial probe is unloaded; expected a stage "
        "such as 'unload to 5 % of peak' at the end of its Path/Stages");
  if (mean.count > 0)
    for (ProbeData *probe : others)
      soften(probe->moduli, mean);
}
} // namespace tamp::apps
