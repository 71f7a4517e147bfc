// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_series_writer_h
#define apps_run_series_writer_h

#include <apps/run/run_folder.h>

#include <string>

namespace tamp::apps
{
/// A .pvd file, with which ParaView opens the files of many steps as one
/// series.
class SeriesWriter
{
public:
  /// @param name  of the file in the run's folder, "fields.pvd"
  SeriesWriter(const RunFolder &folder, std::string name);

  /// Adds a file, its path from the run's folder, and writes the series anew.
  /// Files of one step are told apart by `part`. Throws OutputError.
  void add(double step, std::size_t part, const std::string &file);

  /// What add() has added so far, and going on after it. Throws OutputError.
  const std::string &entries() const { return entries_; }
  void go_on(const std::string &entries);
  /// Removes files .vtu and .vtp of a folder in that of the run that were not
  /// added: those of steps after a checkpoint.
  void remove_others(const std::string &folder) const;

private:
  void write() const;

  const RunFolder &folder_;
  std::string name_, entries_;
};
} // namespace tamp::apps

#endif
