// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/output/curve_writer.h>
#include <apps/output/plots.h>
#include <apps/pack_results.h>
#include <apps/run/cell_remarks.h>
#include <apps/run/interrupt.h>
#include <apps/run/run_material.h>
#include <coupling/grain_output.h>
#include <coupling/packing_file.h>
#include <coupling/packing_library.h>
#include <coupling/work_sharing.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <mutex>
#include <numeric>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
struct Interrupted {
};

/// Makes the packings of a run, several at once. Everything that is written,
/// and all of HDF5 and VTK, waits for its turn.
class PackRun
{
public:
  explicit PackRun(RunSession &session)
      : session_(session), choice_(session.input().material),
        replicas_(session.input().replicas),
        curve_(session.folder().path() / "curve.csv",
               packing_header(),
               {"compression is positive; steps in which loose grains are "
                "still on the move have an unbalance to match"}),
        rows_(replicas_), shares_(replicas_, 0.0), finished_(replicas_, false),
        remarks_(replicas_)
  {
  }

  RunEnd work()
  {
    warn_of_contact_model(session_);
    session_.log().begin(packing_title(choice_, replicas_));
    RunEnd end;
    try {
      std::vector<std::size_t> order(replicas_);
      std::iota(order.begin(), order.end(), std::size_t(0));
      coupling::share_work(
          order, choice_.threads, [this](std::size_t i) { make(i); });
    } catch (const Interrupted &) {
      end = RunSession::interrupted(caught_signal());
    } catch (const coupling::FileError &error) {
      throw OutputError(error.what());
    }
    session_.log().end();
    warn_of_history(session_, history_);
    results_.give(session_);
    say_remarks();
    session_.draw(pack_plots());
    return end;
  }

private:
  void make(std::size_t i)
  {
    const dem::PackingRequest request =
        coupling::sample_of(choice_.packing, choice_.first_packing + i);
    unsigned step = 0;
    const auto observe = [&](const dem::UnitCell &cell,
                             const dem::CellAnswer &answer) {
      take(i, step++, cell, answer);
      if (caught_signal())
        throw Interrupted();
    };
    dem::UnitCell cell;
    if (choice_.packing_files.empty())
      cell = dem::make_packing(request, observe);
    else {
      cell = stored(request, i);
      dem::finish_packing(cell, request, observe);
    }
    keep(i, cell);
  }

  /// The start of a packing that a file has; friction as during packing.
  dem::UnitCell stored(dem::PackingRequest request, std::size_t i)
  {
    if (request.friction_during_packing >= 0)
      request.contact.friction_coefficient = request.friction_during_packing;
    const std::lock_guard lock(turn_);
    const std::size_t number = choice_.first_packing + i;
    auto found =
        coupling::read_packings(choice_.packing_files, request, {&number, 1});
    history_ = std::max(history_, found.history);
    return std::move(found.cells[0]);
  }

  void take(std::size_t i,
            unsigned step,
            const dem::UnitCell &cell,
            const dem::CellAnswer &answer)
  {
    auto row = packing_row(i, step, cell, answer);
    const std::lock_guard lock(turn_);
    if (start_density_ <= 0)
      start_density_ = cell.relative_density();
    shares_[i] = share_of(cell);
    rows_[i].push_back(std::move(row));
    write_rows();
    ++steps_;
    session_.log().step(
        std::accumulate(shares_.begin(), shares_.end(), 0.0) /
            static_cast<double>(replicas_),
        steps_,
        "steps",
        step % steps_between_lines == 0 ? line_of(i, step, cell, answer) : "");
  }

  /// How much of the way to a packing is done, as far as density tells.
  double share_of(const dem::UnitCell &cell) const
  {
    constexpr double usual = 0.62;
    const double goal =
        choice_.packing.goal.target == dem::CompressionTarget::relative_density
            ? choice_.packing.goal.relative_density
            : usual;
    const double way = std::log(goal / start_density_);
    const double gone = std::log(cell.relative_density() / start_density_);
    return way > 0 ? std::clamp(gone / way, 0.0, 0.99) : 0.5;
  }

  std::string line_of(std::size_t i,
                      unsigned step,
                      const dem::UnitCell &cell,
                      const dem::CellAnswer &answer) const
  {
    return fmt::format(
        "packing {:3d}  step {:4d}  density {:.4f}  pressure {:.4g} MPa",
        i + 1,
        step,
        cell.relative_density(),
        goal_pressure(choice_.packing.goal.compression, answer.stress) / 1e6);
  }

  /// Packings one after the other, the steps of each as they come.
  void write_rows()
  {
    for (; writing_ < replicas_; ++writing_) {
      for (const auto &row : rows_[writing_])
        curve_.write(row);
      rows_[writing_].clear();
      if (!finished_[writing_])
        return;
    }
  }

  void keep(std::size_t i, const dem::UnitCell &cell)
  {
    const std::string number =
        replicas_ == 1 ? "" : fmt::format("_{:04d}", i + 1);
    const auto file = [&](const char *name, const char *ending) {
      return session_.folder().path() / (name + number + ending);
    };
    const std::lock_guard lock(turn_);
    coupling::write_packing(cell, file("packing", ".h5"));
    coupling::write_packing_text(cell, file("packing", ".txt"));
    coupling::write_grains(
        cell, dem::Matrix3::Identity(), file("grains", ".vtp"));
    finished_[i] = true;
    shares_[i] = 1;
    write_rows();
    results_.take(i, cell);
    remarks_[i] = dem::judge(cell, {}, choice_.packing.goal.pressure);
  }

  // In the order of the packings, whichever was ready first.
  void say_remarks()
  {
    CellRemarks cell_remarks(session_, "packing", replicas_);
    for (std::size_t i = 0; i < replicas_; ++i)
      cell_remarks.take(
          i, remarks_[i], [i] { return fmt::format("packing {}", i + 1); });
    cell_remarks.give();
  }

  static constexpr unsigned steps_between_lines = 25;

  RunSession &session_;
  const coupling::MaterialChoice &choice_;
  std::size_t replicas_;
  std::mutex turn_;
  CurveWriter curve_;
  std::vector<std::vector<std::vector<double>>> rows_;
  std::vector<double> shares_;
  std::vector<bool> finished_;
  std::vector<std::vector<dem::Remark>> remarks_;
  std::size_t writing_ = 0; // the packing whose rows go to the curve
  double start_density_ = 0, steps_ = 0;
  coupling::History history_ = coupling::History::kept;
  PackResults results_;
};
} // namespace

int run_pack(const RunOptions &options)
{
  RunSession session("pack", options, Need::pack);
  watch_signals();
  return session.run([&]() -> RunEnd { return PackRun(session).work(); });
}
} // namespace tamp::apps
