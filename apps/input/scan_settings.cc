// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/parameter_table.h>
#include <apps/input/scan_settings.h>

#include <algorithm>
#include <functional>
#include <string>

namespace tamp::apps
{
namespace
{
constexpr Range share{0, 1, true, true};
constexpr Range small{0, 0.01, true, false};

// The branches on which a point looks for yield.
void declare_branches(ParameterTable &table)
{
  const auto shares = [&](const char *name,
                          const char *value,
                          const char *text) {
    table.quantities(name,
                     value,
                     dimension::number,
                     share,
                     std::string("Shares of the reached pressure to which the "
                                 "point is unloaded, to an isotropic stress, "
                                 "before it is ") +
                         text + "; none: never");
  };
  shares("Compression shares",
         "0.9, 0.6, 0.3, 0.1",
         "sheared by axial compression at constant pressure");
  shares("Extension shares",
         "",
         "sheared by axial extension at constant pressure");
  shares("Triaxial shares",
         "0.3, 0.1",
         "compressed along the axis at constant lateral stress");
  shares("Isotropic shares", "0.9", "compressed alike in all directions");
  shares("Uniaxial shares",
         "0.9, 0.6",
         "compressed along the axis, lateral strains held");
}
} // namespace

void declare_scan(ParameterTable &table)
{
  table.enter("Scan");
  table.quantities("Densities",
                   "",
                   dimension::number,
                   share,
                   "Relative densities of the path, rising, at which copies of "
                   "the point look for yield and moduli: yield.csv, "
                   "moduli.csv; none: no scan");
  declare_branches(table);
  table.quantity("Strain offset",
                 "5e-4",
                 dimension::number,
                 small,
                 "Irreversible strain at yield, criterion 0");
  table.quantity("Plastic work",
                 "5e-4",
                 dimension::number,
                 small,
                 "Plastic work per volume at yield over the reached pressure, "
                 "criterion 1");
  table.quantity("Modulus strain",
                 "1e-4",
                 dimension::number,
                 small,
                 "Of the small probes that are unloaded and loaded again");
  table.quantity("Maximum strain increment",
                 "2e-4",
                 dimension::number,
                 small,
                 "Of the branches until they yield");
  table.quantity("Maximum strain",
                 "0.2",
                 dimension::number,
                 {0, 0.5, true, false},
                 "Of the branches until they yield, and from there until a "
                 "peak or critical state");
  table.leave();
}

ScanSettings read_scan(const ParameterTable &table)
{
  ScanSettings scan;
  scan.densities = table.numbers("Scan/Densities");
  if (std::ranges::adjacent_find(scan.densities, std::greater_equal<>()) !=
      scan.densities.end())
    table.complain("Scan/Densities",
                   "each density must be larger than the one before");
  scan.compression_shares = table.numbers("Scan/Compression shares");
  scan.extension_shares = table.numbers("Scan/Extension shares");
  scan.triaxial_shares = table.numbers("Scan/Triaxial shares");
  scan.isotropic_shares = table.numbers("Scan/Isotropic shares");
  scan.uniaxial_shares = table.numbers("Scan/Uniaxial shares");
  scan.strain_offset = table.number("Scan/Strain offset");
  scan.plastic_work = table.number("Scan/Plastic work");
  scan.modulus_strain = table.number("Scan/Modulus strain");
  scan.increment = table.number("Scan/Maximum strain increment");
  scan.largest_strain = table.number("Scan/Maximum strain");
  return scan;
}
} // namespace tamp::apps
