// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/series_writer.h>

#include <filesystem>
#include <fmt/format.h>
#include <system_error>
#include <vector>

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

void SeriesWriter::remove_others(const std::string &folder) const
{
  std::vector<std::filesystem::path> others;
  std::error_code ignored;
  for (const auto &entry :
       std::filesystem::directory_iterator(folder_.path() / folder, ignored)) {
    const std::string name = entry.path().filename();
    if ((name.ends_with(".vtu") || name.ends_with(".vtp")) &&
        entries_.find("\"" + folder + "/" + name + "\"") == std::string::npos)
      others.push_back(entry.path());
  }
  for (const auto &file : others)
    std::filesystem::remove(file, ignored);
}

void SeriesWriter::write() const
{
  folder_.write(name_,
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
                "version=\"0.1\">\n  <Collection>\n" +
                    entries_ + "  </Collection>\n</VTKFile>\n");
}
} // namespace tamp::apps
