// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/input_purpose.h>

namespace tamp::apps
{
std::string name_of(Need need)
{
  switch (need) {
  case Need::die:
    return "die";
  case Need::probe:
    return "probe";
  case Need::pack:
    return "pack";
  case Need::contact:
    return "contact";
  case Need::point:
  case Need::everything:
    break;
  }
  return {};
}

std::vector<Need> purposes(const ParameterTable &table)
{
  std::vector<Need> needs;
  if (table.given_below("Die") || table.given_below("Schedule"))
    needs.push_back(Need::die);
  if (table.given_below("Path"))
    needs.push_back(Need::probe);
  if (table.given_below("Pair"))
    needs.push_back(Need::contact);
  if (table.given("Packing/Replicas"))
    needs.push_back(Need::pack);
  if (!needs.empty())
    return needs;
  if (table.given_below("Material"))
    return {Need::die, Need::probe};
  return {Need::pack};
}
} // namespace tamp::apps
