// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/plots.h>

namespace tamp::apps
{
std::vector<Plot> replica_plots()
{
  return {
      {"stress_strain",
       R"(set title "Stress against strain, mean and standard deviation"
set xlabel "axial strain {/Symbol e}_{zz} [-]"
set ylabel "stress [MPa]"
strain = "strain_zz[-]"
axial = "stress_zz[Pa]"
lateral = "stress_xx[Pa]"
low(name) = (column(name."[Pa]") - column(name."_deviation[Pa]")) / 1e6
high(name) = (column(name."[Pa]") + column(name."_deviation[Pa]")) / 1e6
plot "../curve.csv" using (column(strain)):(low("stress_zz")):(high("stress_zz")) with filledcurves linecolor rgb "#800b6e99" notitle, \
     "" using (column(strain)):(low("stress_xx")):(high("stress_xx")) with filledcurves linecolor rgb "#80d1495b" notitle, \
     "" using (column(strain)):(column(axial) / 1e6) with lines linetype 1 title "axial", \
     "" using (column(strain)):(column(lateral) / 1e6) with lines linetype 2 title "lateral"
)"},
      {"density_pressure",
       R"(set title "Relative density against pressure, with standard deviation"
set xlabel "mean pressure [MPa]"
set ylabel "relative density [-]"
set logscale x
set format x "%g"
unset key
pressure(row) = column("pressure[Pa]") > 0 ? column("pressure[Pa]") / 1e6 : NaN
density = "relative_density[-]"
off = "relative_density_deviation[-]"
plot "../curve.csv" using (pressure(0)):(column(density) - column(off)):(column(density) + column(off)) with filledcurves linecolor rgb "#800b6e99", \
     "" using (pressure(0)):(column(density)) with lines linetype 1
)"},
      {"sizes",
       R"(set title "Peak axial stress of every cell"
set xlabel "grains [-]"
set ylabel "peak axial stress [MPa]"
set offsets graph 0.1, graph 0.1, graph 0.1, graph 0.1
unset key
plot "../replicas.csv" using (column("size[-]")):(column("peak_axial_stress[Pa]") / 1e6) with points pointsize 1.5
)"}};
}
} // namespace tamp::apps
