// SPDX-License-Identifier: BSD-3-Clause
#include <dem/size_table.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tamp::dem
{
namespace
{
constexpr double rounding = 1e-9; // of shares, as people write them

void check(const std::vector<SizeShare> &lines)
{
  if (lines.size() < 2)
    refuse("lines of the size table", double(lines.size()), "at least 2");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string line = " in line " + std::to_string(k + 1);
    Positive{}(lines[k].diameter, ("diameter" + line).c_str());
    if (!std::isfinite(lines[k].diameter))
      refuse("diameter" + line, lines[k].diameter, "a finite number");
    if (k > 0 && lines[k].diameter < lines[k - 1].diameter)
      refuse("diameter" + line,
             lines[k].diameter,
             "at least that of the line before");
    if (!(lines[k].below >= (k > 0 ? lines[k - 1].below : 0)))
      refuse("share" + line,
             lines[k].below,
             k > 0 ? "at least that of the line before" : "0");
  }
  if (lines.front().below > rounding)
    refuse("first share of the size table",
           lines.front().below,
           "0: no grain is smaller than the first diameter");
  if (!(std::abs(lines.back().below - 1) <= rounding))
    refuse("last share of the size table",
           lines.back().below,
           "1: no grain is larger than the last diameter");
}
} // namespace

SizeTable::SizeTable(const std::vector<SizeShare> &lines, ShareBasis basis)
    : basis_(basis)
{
  check(lines);
  // In units of the smallest diameter: cubes of metres are very small.
  const double unit = lines.front().diameter;
  double sum = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double d0 = lines[k - 1].diameter, d1 = lines[k].diameter;
    double share = lines[k].below - lines[k - 1].below;
    if (basis == ShareBasis::volume) {
      const double a = d0 / unit, b = d1 / unit;
      share *= (a + b) / (2 * a * a * b * b);
    }
    if (share > 0)
      sections_.push_back({d0, d1, sum, share});
    sum += share;
  }
  for (Section &section : sections_) {
    section.below /= sum;
    section.share /= sum;
  }
}

double SizeTable::quantile(double share) const
{
  const auto after = std::ranges::upper_bound(
      sections_, share, {}, [](const Section &s) { return s.below; });
  const Section &section =
      after == sections_.begin() ? *after : *std::prev(after);
  const double part =
      std::clamp((share - section.below) / section.share, 0.0, 1.0);
  const double d0 = section.first, d1 = section.last;
  if (basis_ == ShareBasis::number)
    return std::lerp(d0, d1, part);
  // The number below d within a section goes with 1 - (d_0 / d)^2.
  const double end = (d0 / d1) * (d0 / d1);
  return std::clamp(d0 / std::sqrt(std::lerp(1.0, end, part)), d0, d1);
}
} // namespace tamp::dem
