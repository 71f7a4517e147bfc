// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/curve_writer.h>

#include <cassert>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tamp::apps
{
CurveWriter::CurveWriter(const std::filesystem::path &file,
                         const std::vector<std::string> &header,
                         const std::vector<std::string> &remarks)
    : file_(file), columns_(header.size())
{
  for (const std::string &remark : remarks)
    file_.append("# " + remark + "\n");
  file_.append(fmt::format("{}\n", fmt::join(header, ",")));
}

CurveWriter::CurveWriter(const std::filesystem::path &file,
                         std::size_t columns,
                         std::uint64_t size)
    : file_(file, size), columns_(columns)
{
}

void CurveWriter::write(std::span<const double> values)
{
  assert(values.size() == columns_);
  file_.append(fmt::format("{}\n", fmt::join(values, ",")));
}
} // namespace tamp::apps
