// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/plots.h>

namespace tamp::apps
{
namespace
{
constexpr const char *colours =
    R"(set palette defined (0 "#440154", 1 "#3b528b", 2 "#21918c", 3 "#5ec962", 4 "#e3c515")
density = "relative_density[-]"
mega(name) = column(name) / 1e6
)";
} // namespace

std::vector<Plot> scan_plots()
{
  return {
      {"yield",
       std::string(R"(set title "Yield points"
set xlabel "mean pressure [MPa]"
set ylabel "deviatoric stress [MPa]"
set cblabel "relative density [-]"
set xrange [0:*]
set yrange [0:*]
)") + colours +
           R"(criterion(number) = column("criterion[-]") == number ? mega("deviatoric_stress[Pa]") : NaN
plot "../yield.csv" using (mega("pressure[Pa]")):(criterion(0)):(column(density)) with points palette pointtype 7 pointsize 1.5 title "irreversible strain", \
     "" using (mega("pressure[Pa]")):(criterion(1)):(column(density)) with points palette pointtype 6 pointsize 1.8 linewidth 2 title "plastic work", \
     "" using (mega("pressure[Pa]")):(criterion(2)):(column(density)) with points palette pointtype 8 pointsize 2 linewidth 2 title "peak or critical state", \
     "" using (mega("reached_pressure[Pa]")):(mega("reached_deviatoric_stress[Pa]")):(column(density)) with points palette pointtype 3 pointsize 2 linewidth 2 title "reached on the path"
)"},
      {"moduli",
       std::string(R"(set title "Elastic moduli of small probes"
set xlabel "relative density [-]"
set ylabel "modulus [MPa]"
set logscale y
set format y "%g"
)") + colours +
           R"(plot "../moduli.csv" using (column(density)):(mega("bulk_modulus[Pa]")) with points pointsize 1.5 title "bulk", \
     "" using (column(density)):(mega("shear_modulus[Pa]")) with points pointsize 1.5 title "shear"
)"}};
}
} // namespace tamp::apps
