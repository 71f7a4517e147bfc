// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_pack_results_h
#define apps_pack_results_h

#include <apps/run/run_session.h>
#include <dem/deform.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace tamp::apps
{
/// Names of the columns of the curve of packings.
std::vector<std::string> packing_header();
/// The values that belong to packing_header(), of a step of a packing.
/// Compression positive; packings count from 1.
std::vector<double> packing_row(std::size_t packing,
                                unsigned step,
                                const dem::UnitCell &cell,
                                const dem::CellAnswer &answer);

/// The key results of packings: means, and with several their deviations.
class PackResults
{
public:
  void take(std::size_t packing, const dem::UnitCell &cell);
  /// Hands all results to the session.
  void give(RunSession &session) const;

private:
  std::vector<std::string> names_; // in the order of the summary
  // By name and packing, whichever was ready first.
  std::map<std::string, std::map<std::size_t, double>> values_;
  std::size_t count_ = 0;
};
} // namespace tamp::apps

#endif
