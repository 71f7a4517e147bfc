// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_cell_remarks_h
#define apps_run_cell_remarks_h

#include <apps/run/run_session.h>
#include <dem/remarks.h>

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// Says what is doubtful about the cells of a run: every kind of remark once,
/// as a warning that names the first place, and at the end in one line how
/// many cells it was and which was worst.
class CellRemarks
{
public:
  using Place = std::function<std::string()>;

  /// @param name   what a cell is called, as in "point"
  /// @param count  of all cells
  CellRemarks(RunSession &session, std::string name, std::size_t count)
      : session_(session), name_(std::move(name)), count_(count)
  {
  }

  /// @param cell   its number
  /// @param place  of the cell and of the state, as in "point 3, step 7"
  void take(std::size_t cell,
            const std::vector<dem::Remark> &remarks,
            const Place &place);

  /// Says the line of the end, and hands the numbers of cells to the session;
  /// both only if there is more than one cell and something to say.
  void give() const;

  /// Appends all that was found so far; go_on() takes it up.
  void pack(std::vector<char> &bytes) const;
  void go_on(fem::StateBytes &stored);

private:
  struct Finding {
    std::set<std::size_t> cells;
    dem::Remark worst;
    std::string worst_place;
  };

  RunSession &session_;
  std::string name_;
  std::size_t count_;
  std::map<dem::Remark::Kind, Finding> findings_;
};
} // namespace tamp::apps

#endif
