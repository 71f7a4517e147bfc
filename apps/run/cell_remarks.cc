// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/cell_remarks.h>

#include <fmt/format.h>
#include <string_view>

namespace tamp::apps
{
namespace
{
using Kind = dem::Remark::Kind;

// How the line of the end and the result call a kind that is about states.
struct KindNames {
  std::string_view line, result;
};

KindNames names_of(Kind kind)
{
  switch (kind) {
  case Kind::beyond_pair_laws:
    return {"relative density above", "beyond_pair_laws"};
  case Kind::not_quasi_static:
    return {"inertial number above", "not_quasi_static"};
  default:
    return {"largest grains across the cell below", "too_narrow"};
  }
}
} // namespace

void CellRemarks::take(std::size_t cell,
                       const std::vector<dem::Remark> &remarks,
                       const Place &place)
{
  for (const dem::Remark &remark : remarks) {
    if (!dem::about_a_state(remark.kind)) {
      if (findings_.try_emplace(remark.kind).second)
        session_.warn(remark.text);
      continue;
    }
    const auto [entry, first] = findings_.try_emplace(remark.kind);
    Finding &finding = entry->second;
    finding.cells.insert(cell);
    if (!first && !dem::worse(remark, finding.worst))
      continue;
    finding.worst = remark;
    finding.worst_place = place();
    if (first)
      session_.warn(finding.worst_place + ": " + remark.text);
  }
}

void CellRemarks::give() const
{
  std::string line;
  for (const auto &[kind, finding] : findings_) {
    if (count_ < 2 || !dem::about_a_state(kind))
      continue;
    const KindNames names = names_of(kind);
    line += fmt::format("{}{} {:.4g}: {} of {} {}s, worst {:.4g} in {}",
                        line.empty() ? "" : "; ",
                        names.line,
                        finding.worst.bound,
                        finding.cells.size(),
                        count_,
                        name_,
                        finding.worst.value,
                        finding.worst_place);
    session_.result(fmt::format("{}s_{}[-]", name_, names.result),
                    static_cast<double>(finding.cells.size()));
  }
  if (!line.empty())
    session_.log().say(line);
}

void CellRemarks::pack(std::vector<char> &bytes) const
{
  fem::append_state(bytes, findings_.size());
  for (const auto &[kind, finding] : findings_) {
    fem::append_state(bytes, kind);
    fem::append_state(
        bytes,
        std::vector<std::size_t>(finding.cells.begin(), finding.cells.end()));
    fem::append_state(bytes, finding.worst.value);
    fem::append_state(bytes, finding.worst.bound);
    fem::append_state(bytes, finding.worst.text);
    fem::append_state(bytes, finding.worst_place);
  }
}

void CellRemarks::go_on(fem::StateBytes &stored)
{
  std::size_t count = 0;
  stored.take(count);
  while (count-- > 0) {
    Kind kind{};
    stored.take(kind);
    Finding &finding = findings_[kind];
    std::vector<std::size_t> cells;
    stored.take(cells);
    finding.cells.insert(cells.begin(), cells.end());
    finding.worst.kind = kind;
    stored.take(finding.worst.value);
    stored.take(finding.worst.bound);
    stored.take(finding.worst.text);
    stored.take(finding.worst_place);
  }
}
} // namespace tamp::apps
