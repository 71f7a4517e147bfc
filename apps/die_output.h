// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_output_h
#define apps_die_output_h

#include <apps/run_session.h>
#include <apps/series_writer.h>
#include <coupling/unit_cell_points.h>
#include <fem/die_model.h>

namespace tamp::apps
{
/// Fields and grains of a die on disk.
class DieOutput
{
public:
  /// @param cells  null for continua. All must outlive this.
  DieOutput(const RunSession &session,
            const fem::DieModel &model,
            const coupling::UnitCellPoints *cells);

  /// Writes what is due at a step; everything if `must` is set. A step is
  /// written once.
  void write(unsigned step, bool must);

private:
  void write_fields(unsigned step);
  void write_grains(unsigned step);

  const RunSession &session_;
  const fem::DieModel &model_;
  const coupling::UnitCellPoints *cells_;
  std::vector<std::size_t> grain_points_;
  SeriesWriter fields_, grains_;
  long last_fields_ = -1, last_grains_ = -1;
};
} // namespace tamp::apps

#endif
