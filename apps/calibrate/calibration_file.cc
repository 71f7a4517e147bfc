// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/calibration_file.h>
#include <apps/calibrate/curve_targets.h>
#include <apps/input/csv_line.h>
#include <apps/input/units.h>

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

namespace tamp::apps
{
namespace
{
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t first_columns =
    3; // run, kind, packing; then parameters, misfit
} // namespace

CalibrationFile::CalibrationFile(const std::filesystem::path &file,
                                 const std::vector<std::string> &remarks,
                                 const std::vector<FitParameter> &parameters)
    : file_(file), remarks_(remarks), parameters_(parameters)
{
  if (std::filesystem::is_regular_file(file))
    read();
}

void CalibrationFile::read()
{
  std::ifstream in(file_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  const std::size_t others = first_columns + parameters_.size() + 1;
  std::size_t remark = 0;
  unsigned number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with("#") || remark < remarks_.size()) {
      const std::string expected =
          remark < remarks_.size() ? "# " + remarks_[remark] : "";
      if (line != expected)
        throw InputError(fmt::format(
            "--resume: '{}' is of another calibration: it has '{}' instead of "
            "'{}'. Nothing was changed; resume with the same input, data and "
            "options, or start a new run",
            file_.string(),
            line,
            expected));
      ++remark;
    } else if (residuals_ == 0) {
      const std::size_t columns = fields_of(line).size();
      residuals_ = columns - std::min(columns, others);
    } else {
      CalibrationRun run;
      const auto fields = fields_of(line);
      if (fields.size() != others + residuals_)
        throw InputError(fmt::format(
            "--resume: {}:{}: expected {} values, as in the header, not {}",
            file_.string(),
            number,
            others + residuals_,
            fields.size()));
      run.kind = static_cast<RunKind>(number_of(fields[1]).value_or(1));
      run.packing = static_cast<unsigned>(number_of(fields[2]).value_or(0));
      for (std::size_t k = 0; k < parameters_.size(); ++k)
        run.values.push_back(
            number_of(fields[first_columns + k]).value_or(nothing));
      if (number_of(fields[others - 1])) {
        run.residuals.resize(static_cast<Eigen::Index>(residuals_));
        for (std::size_t k = 0; k < residuals_; ++k)
          run.residuals[static_cast<Eigen::Index>(k)] =
              number_of(fields[others + k]).value_or(nothing);
      }
      runs_.push_back(run);
    }
    size_ += line.size() + 1;
  }
}

std::vector<std::string> CalibrationFile::header(std::size_t residuals) const
{
  std::vector<std::string> names{"run", "kind", "packing"};
  for (const FitParameter &parameter : parameters_)
    names.push_back(fmt::format("{}[{}]", parameter.path, parameter.unit));
  names.emplace_back("misfit[-]");
  for (std::size_t k = 0; k < residuals; ++k)
    names.push_back(fmt::format("residual_{}[-]", k + 1));
  return names;
}

void CalibrationFile::open(std::size_t residuals)
{
  const auto names = header(residuals);
  if (residuals_ > 0 && residuals_ != residuals)
    throw InputError(fmt::format("--resume: '{}' has {} residuals a run, not "
                                 "{}: it is of another program",
                                 file_.string(),
                                 residuals_,
                                 residuals));
  writer_ = residuals_ > 0
                ? std::make_unique<CurveWriter>(file_, names.size(), size_)
                : std::make_unique<CurveWriter>(file_, names, remarks_);
  residuals_ = residuals;
}

std::optional<CalibrationRun>
CalibrationFile::stored(std::size_t number,
                        const std::vector<double> &values) const
{
  if (number >= runs_.size())
    return {};
  if (runs_[number].values != values)
    throw InputError(fmt::format("--resume: run {} of '{}' was made with other "
                                 "values than now: by another program, or on "
                                 "another machine",
                                 number + 1,
                                 file_.string()));
  return runs_[number];
}

void CalibrationFile::write(const CalibrationRun &run)
{
  if (++written_ <= runs_.size())
    return; // it is there
  std::vector<double> values{static_cast<double>(written_),
                             static_cast<double>(run.kind),
                             static_cast<double>(run.packing)};
  values.insert(values.end(), run.values.begin(), run.values.end());
  const bool failed = run.residuals.size() == 0;
  std::vector<double> residuals(residuals_, nothing);
  if (!failed)
    residuals.assign(run.residuals.begin(), run.residuals.end());
  values.push_back(failed ? nothing : misfit_of(residuals));
  values.insert(values.end(), residuals.begin(), residuals.end());
  writer_->write(values);
}
} // namespace tamp::apps
