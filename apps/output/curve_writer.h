// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_curve_writer_h
#define apps_output_curve_writer_h

#include <apps/output/growing_file.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// A CSV file that grows line by line: remarks after #, one header line of
/// names with units, then numbers with all their digits. A line is on disk as a
/// whole or not at all.
class CurveWriter
{
public:
  /// Throws OutputError naming the file if it cannot be written.
  CurveWriter(const std::filesystem::path &file,
              const std::vector<std::string> &header,
              const std::vector<std::string> &remarks = {});
  /// Goes on with a file of as many columns: what stands in it after `size`
  /// bytes is removed. Throws OutputError, also if it has fewer.
  CurveWriter(const std::filesystem::path &file,
              std::size_t columns,
              std::uint64_t size);

  /// Appends a line of as many numbers as the header has names. Throws
  /// OutputError.
  void write(std::span<const double> values);

  /// Bytes of all lines so far.
  std::uint64_t size() const { return file_.size(); }
  /// Has all lines on the disk, as far as the system can tell.
  void sync() const { file_.sync(); }

private:
  GrowingFile file_;
  std::size_t columns_;
};
} // namespace tamp::apps

#endif
