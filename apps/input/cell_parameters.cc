// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/cell_parameters.h>
#include <apps/input/parameter_table.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace tamp::apps
{
void declare_cell(ParameterTable &table)
{
  table.enter("Cell");
  table.choice("Method",
               "quasi-static",
               methods,
               "How grains follow a strain: static equilibrium, or damped "
               "motion at a strain rate");
  table.quantity("Unbalance tolerance",
                 "1e-3",
                 dimension::number,
                 {0, 0.1, true, false},
                 "Mean force on a grain over mean contact force, at "
                 "equilibrium; quasi-static");
  table.quantity("Maximum strain increment",
                 "1e-2",
                 dimension::number,
                 {0, 0.1, true, false},
                 "A larger one is divided; quasi-static");
  table.integer("Maximum evaluations",
                3000,
                10,
                "Of all contact forces for an increment; quasi-static");
  table.flag("Warm start",
             true,
             "Start from the last trial of the same step: half the work, same "
             "answer within the tolerance; quasi-static");
  table.choice("Precision",
               "double",
               {"double", "mixed"},
               "Mixed: forces in single, places in double precision");
  table.quantity("Strain rate",
                 "1e-5 1/s",
                 dimension::rate,
                 positive,
                 "Largest principal rate; dynamics");
  table.quantity("Density scaling",
                 "1e12",
                 dimension::number,
                 positive,
                 "Factor on the density of the grains; dynamics");
  table.quantity("Time step fraction",
                 "0.2",
                 dimension::number,
                 {0, 1, true, false},
                 "Of the Rayleigh time step; dynamics");
  table.quantity("Global damping",
                 "0.05",
                 dimension::number,
                 not_negative,
                 "Share of the critical damping of a mean grain; dynamics");
  table.quantity("Local damping",
                 "0",
                 dimension::number,
                 {0, 1, false, true},
                 "Share by which each force on a grain is less while it drives "
                 "the grain and more while it brakes it (Cundall); dynamics");
  table.leave();
}
void read_cell(const ParameterTable &table, dem::Driving &driving)
{
  driving.method = static_cast<dem::Method>(std::distance(
      methods.begin(), std::ranges::find(methods, table.word("Cell/Method"))));
  if (table.word("Cell/Precision") == "mixed")
    driving.arithmetic.precision = dem::Precision::mixed;
  driving.quasi_static.unbalance_tolerance =
      table.number("Cell/Unbalance tolerance");
  driving.quasi_static.maximum_strain_increment =
      table.number("Cell/Maximum strain increment");
  driving.quasi_static.maximum_evaluations =
      static_cast<std::size_t>(table.whole("Cell/Maximum evaluations"));
  driving.dynamics.strain_rate = table.number("Cell/Strain rate");
  driving.dynamics.density_scaling = table.number("Cell/Density scaling");
  driving.dynamics.time_step_fraction = table.number("Cell/Time step fraction");
  driving.dynamics.global_damping = table.number("Cell/Global damping");
  driving.dynamics.local_damping = table.number("Cell/Local damping");
}
} // namespace tamp::apps
