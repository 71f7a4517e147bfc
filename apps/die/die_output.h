// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_die_output_h
#define apps_die_die_output_h

#include <apps/die/recorded_points.h>
#include <apps/output/curve_writer.h>
#include <apps/run/run_session.h>
#include <apps/run/series_writer.h>
#include <coupling/shared_cells.h>
#include <fem/die_model.h>
#include <fem/state_bytes.h>

#include <memory>

namespace tamp::apps
{
/// Fields and grains of a die on disk. Of several ranks the first one writes;
/// all functions are collective.
class DieOutput
{
public:
  /// @param cells  null for continua. All must outlive this.
  DieOutput(const RunSession &session,
            const fem::DieModel &model,
            const RecordedPoints &points,
            const coupling::SharedCells *cells);

  /// Writes what is due at a step; everything if `must` is set. A step is
  /// written once.
  void write(unsigned step, bool must);

  /// Adds the committed step to the path and the answer of each chosen point:
  /// what the point was told, to the last bit, and its stress.
  void write_point_lines();

  /// Starts the files that grow; or goes on with them as they were at a
  /// checkpoint, and removes the fields and grains of later steps. To be called
  /// once before anything is written. Throws OutputError.
  void begin();
  void go_on(fem::StateBytes &stored);
  /// Appends how far the files have been written, and has them on the disk.
  void pack(std::vector<char> &bytes) const;

private:
  std::filesystem::path lines_of(std::size_t point) const;
  void write_fields(unsigned step);
  void write_grains(unsigned step);
  void choose_points();

  const RunSession &session_;
  const fem::DieModel &model_;
  const RecordedPoints &points_;
  const coupling::SharedCells *cells_;
  std::vector<std::size_t> grain_points_;
  std::vector<std::unique_ptr<CurveWriter>> point_lines_;
  SeriesWriter fields_, grains_;
  long last_fields_ = -1, last_grains_ = -1;
};
} // namespace tamp::apps

#endif
