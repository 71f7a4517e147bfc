// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/plots.h>

namespace tamp::apps
{
std::vector<Plot> contact_plots(bool impact)
{
  std::vector<Plot> plots{{"force_overlap",
                           R"(set title "Normal force against overlap"
set xlabel "overlap [{/Symbol m}m]"
set ylabel "normal force [mN]"
unset key
plot "../curve.csv" using (column("overlap[m]") * 1e6):(column("normal_force[N]") * 1e3) with lines
)"},
                          {"force_slip",
                           R"(set title "Tangential force against slip"
set xlabel "slip [{/Symbol m}m]"
set ylabel "tangential force on the first grain [mN]"
set key inside left top vertical
plot "../curve.csv" using (column("slip_x[m]") * 1e6):(column("tangential_force_x[N]") * 1e3) with lines title "x", \
     "" using (column("slip_y[m]") * 1e6):(column("tangential_force_y[N]") * 1e3) with lines title "y"
)"}};
  if (impact)
    plots.push_back({"force_time",
                     R"(set title "Forces of an impact"
set xlabel "time [{/Symbol m}s]"
set ylabel "force [mN]"
set key inside right top vertical
plot "../curve.csv" using (column("time[s]") * 1e6):(column("normal_force[N]") * 1e3) with lines title "normal", \
     "" using (column("time[s]") * 1e6):(column("tangential_force_x[N]") * 1e3) with lines title "tangential, x"
)"});
  return plots;
}
} // namespace tamp::apps
