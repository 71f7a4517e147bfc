// SPDX-License-Identifier: BSD-3-Clause
#include <apps/series_writer.h>

#include <fmt/format.h>

namespace tamp::apps
{
SeriesWriter::SeriesWriter(const RunFolder &folder, std::string name)
    : folder_(folder), name_(std::move(name))
{
}

void SeriesWriter::add(double step, std::size_t part, const std::string &file)
{
  entries_ +=
      fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n",
                  step,
                  part,
                  file);
  write();
}

void SeriesWriter::go_on(const std::string &entries)
{
  entries_ = entries;
  if (!entries_.empty())
    write();
}

void SeriesWriter::write() const
{
  folder_.write(name_,
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
                "version=\"0.1\">\n  <Collection>\n" +
                    entries_ + "  </Collection>\n</VTKFile>\n");
}
} // namespace tamp::apps
