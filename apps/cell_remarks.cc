// SPDX-License-Identifier: BSD-3-Clause
#include <apps/cell_remarks.h>
#include <dem/measures.h>

namespace tamp::apps
{
void CellRemarks::judge(const dem::UnitCell &cell, const dem::Driving &driving)
{
  for (const dem::Remark &remark :
       dem::judge(cell, driving, dem::love_weber_stress(cell)))
    if (said_.insert(remark.kind).second)
      session_.warn(remark.text);
}
} // namespace tamp::apps
