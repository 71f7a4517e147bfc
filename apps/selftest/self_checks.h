// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_selftest_self_checks_h
#define apps_selftest_self_checks_h

#include <string>
#include <vector>

namespace tamp::apps
{
/// A number that the program computes, beside what it must be.
struct SelfCheck {
  std::string quantity; ///< with its unit, "[-]" left out
  double value, reference;
  double tolerance;   ///< largest size of difference()
  std::string source; ///< of the reference
};

/// Value less reference, over the reference unless that is zero.
double difference(const SelfCheck &check);
/// False also for what is not a number.
bool passes(const SelfCheck &check);

/// What was checked of a part of the program.
struct SelfCheckRoom {
  std::string name;
  std::vector<SelfCheck> checks;
  double seconds = 0;  ///< of processor time
  std::string problem; ///< why it ended before its checks, empty if it did not
};

/// How many checks failed; a room with a problem counts once more.
std::size_t failures(const std::vector<SelfCheckRoom> &rooms);
/// A line for each check below the name and the time of its room.
std::string self_check_table(const std::vector<SelfCheckRoom> &rooms);

/// Each does its work anew. References are closed forms, or numbers that
/// were computed from them without this program.
std::vector<SelfCheck> check_contacts(); ///< laws of pairs of grains
std::vector<SelfCheck> check_cells();    ///< unit cells
std::vector<SelfCheck> check_points();   ///< cells as material points
std::vector<SelfCheck> check_laws();     ///< continuum laws
std::vector<SelfCheck> check_dies();     ///< needs MPI
} // namespace tamp::apps

#endif
