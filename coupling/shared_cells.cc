// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/shared_cells.h>
#include <dem/unit_cell_bytes.h>
#include <fem/state_bytes.h>

#include <cstring>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace tamp::coupling
{
namespace
{
/// Remarks as bytes and back.
class RemarkBytes
{
public:
  RemarkBytes() = default;
  explicit RemarkBytes(std::vector<char> bytes) : bytes_(std::move(bytes)) {}

  void add(std::size_t point, const dem::Remark &remark)
  {
    append(point);
    append(remark.kind);
    append(remark.value);
    append(remark.bound);
    append(remark.text.size());
    bytes_.insert(bytes_.end(), remark.text.begin(), remark.text.end());
  }
  std::vector<PointRemarks> all() const
  {
    std::vector<PointRemarks> result;
    for (std::size_t at = 0; at < bytes_.size();) {
      const auto point = take<std::size_t>(at);
      const auto kind = take<dem::Remark::Kind>(at);
      const auto value = take<double>(at), bound = take<double>(at);
      const auto size = take<std::size_t>(at);
      if (result.empty() || result.back().point != point)
        result.push_back({point, {}});
      result.back().remarks.push_back(
          {kind, value, bound, std::string(&bytes_[at], size)});
      at += size;
    }
    return result;
  }
  const std::vector<char> &bytes() const { return bytes_; }

private:
  template <class Value>
  void append(const Value &value)
  {
    const char *begin = reinterpret_cast<const char *>(&value);
    bytes_.insert(bytes_.end(), begin, begin + sizeof value);
  }
  template <class Value>
  Value take(std::size_t &at) const
  {
    Value value;
    std::memcpy(&value, &bytes_[at], sizeof value);
    at += sizeof value;
    return value;
  }

  std::vector<char> bytes_;
};
} // namespace

SharedCells::SharedCells(std::unique_ptr<UnitCellPoints> own,
                         std::size_t count,
                         const fem::Ranks &ranks)
    : SharedCells(own.release(), count, ranks)
{
}

SharedCells::SharedCells(UnitCellPoints *own,
                         std::size_t count,
                         const fem::Ranks &ranks)
    : SharedPoints(std::unique_ptr<fem::MovablePoints>(own), count, ranks),
      cells_(*own)
{
}

CellReport SharedCells::report() const
{
  CellReport report = cells_.report();
  report.points = size();
  // Sums of whole numbers are exact as long as they are below 2^53.
  double sums[] = {static_cast<double>(report.evaluations),
                   static_cast<double>(report.unsettled),
                   static_cast<double>(report.done_evaluations),
                   static_cast<double>(report.cells)};
  ranks().sum(sums);
  report.evaluations = static_cast<std::uint64_t>(sums[0]);
  report.unsettled = static_cast<std::size_t>(sums[1]);
  report.done_evaluations = static_cast<std::uint64_t>(sums[2]);
  report.cells = static_cast<std::size_t>(sums[3]);
  const double worst = ranks().largest(report.worst_unbalance);
  // The first of the worst.
  const auto after = static_cast<double>(size());
  const bool here = report.worst_unbalance == worst;
  report.worst_unbalance_point = static_cast<std::size_t>(
      after -
      ranks().largest(here ? after - double(report.worst_unbalance_point) : 0));
  report.worst_unbalance = worst;
  report.worst_hill_mandel = ranks().largest(report.worst_hill_mandel);
  report.worst_asymmetry = ranks().largest(report.worst_asymmetry);
  report.problem = ranks().first_text(report.problem);
  return report;
}

std::size_t SharedCells::different_cells() const
{
  // Points that share a cell ask for the same object.
  std::set<const dem::UnitCell *> seen;
  std::vector<char> hashes;
  std::vector<char> bytes;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const dem::UnitCell &cell = cells_.cell(i);
    if (!seen.insert(&cell).second)
      continue;
    bytes.clear();
    dem::to_bytes(cell, bytes);
    fem::append_state(
        hashes, std::hash<std::string_view>()({bytes.data(), bytes.size()}));
  }
  hashes = ranks().join(hashes);
  std::set<std::size_t> different;
  for (fem::StateBytes all(hashes); !all.empty();) {
    std::size_t hash = 0;
    all.take(hash);
    different.insert(hash);
  }
  return different.size();
}

TurnedCell SharedCells::cell(std::size_t point) const
{
  std::vector<char> bytes;
  pack(point, bytes);
  UnitCellPoints copy({}, {});
  copy.hold({0, 1});
  copy.unpack(0, bytes);
  return {copy.cell(0), copy.rotation(0)};
}

std::vector<PointRemarks>
SharedCells::judge(const dem::Driving &driving,
                   std::span<const double> pressures) const
{
  RemarkBytes own;
  for (std::size_t point = share().begin; point < share().end; ++point)
    for (const dem::Remark &remark : dem::judge(
             cells_.cell(point - share().begin), driving, pressures[point]))
      own.add(point, remark);
  return RemarkBytes(ranks().join(own.bytes())).all();
}
} // namespace tamp::coupling
