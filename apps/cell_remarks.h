// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_cell_remarks_h
#define apps_cell_remarks_h

#include <apps/run_session.h>
#include <dem/remarks.h>

#include <set>

namespace tamp::apps
{
/// Says what is doubtful about cells as warnings of a run, each kind once.
class CellRemarks
{
public:
  explicit CellRemarks(RunSession &session) : session_(session) {}
  void judge(const dem::UnitCell &cell, const dem::Driving &driving);

private:
  RunSession &session_;
  std::set<dem::Remark::Kind> said_;
};
} // namespace tamp::apps

#endif
