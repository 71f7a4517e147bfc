// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_powder_h
#define apps_input_powder_h

#include <apps/input/parameter_table.h>

namespace tamp::apps
{
/// Fills the Drucker-Prager cap with the values of the powder that
/// Material/Drucker-Prager cap/Powder names, but for those that a file or --set
/// gave. Call it once, after reading and before values are used: an echo then
/// has the values of the run.
void take_powder(ParameterTable &table);
} // namespace tamp::apps

#endif
