// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/fit_parameter.h>
#include <apps/run/input_table.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
constexpr double decade = 10;

// Packings are made once, from the input, and all runs take the same path.
bool is_kept(const std::string &path)
{
  for (const char *section : {"Packing/", "Path/", "Schedule/", "Output/"})
    if (path.starts_with(section))
      return true;
  if (path.find("nitial relative density") != std::string::npos)
    return true;
  return path.starts_with("Grains/") && !path.ends_with("Young's modulus") &&
         !path.ends_with("Poisson's ratio") &&
         !path.ends_with("Limiting contact pressure");
}

/// Reads one of them with the help of a table of its own.
class FitReader
{
public:
  FitReader(const std::string &text, const RunOptions &options) : text_(text)
  {
    read_table(options, table_);
  }

  FitParameter read()
  {
    const std::size_t equals = text_.find('='), dots = text_.find("..");
    if (equals == std::string::npos || dots == std::string::npos ||
        dots < equals)
      complain("expected \"Section/Name = LOW .. HIGH\"");
    FitParameter parameter;
    parameter.path = trimmed(std::string_view(text_).substr(0, equals));
    const auto of = [&](std::size_t begin, std::size_t end) {
      const std::string value(
          trimmed(std::string_view(text_).substr(begin, end - begin)));
      return number(parameter.path, value);
    };
    parameter.low = of(equals + 1, dots);
    parameter.high = of(dots + 2, text_.size());
    if (!(parameter.low < parameter.high))
      complain("expected the lower bound first, below the upper one");
    // What takes whole numbers only refuses this one.
    number(
        parameter.path,
        fmt::format("{}",
                    parameter.low + 0.3717 * (parameter.high - parameter.low)));
    if (is_kept(parameter.path))
      complain("it cannot be fitted: the packing is made once and all runs "
               "take the path of the measured curve");
    parameter.unit = unit_;
    parameter.logarithmic =
        parameter.low > 0 && parameter.high >= decade * parameter.low;
    return parameter;
  }

private:
  [[noreturn]] void complain(const std::string &problem) const
  {
    throw InputError(fmt::format("--fit \"{}\": {}", text_, problem));
  }

  double number(const std::string &path, const std::string &value)
  {
    if (const auto size = table_.list_size(path); size && *size != 1)
      complain(
          fmt::format("{} is a list with {} entries; expected one of them, "
                      "such as \"{}[1] = LOW .. HIGH\"",
                      path,
                      *size,
                      path));
    const std::string setting = path + " = " + value;
    try {
      table_.set(setting);
      unit_of(value);
      return table_.number(path);
    } catch (const InputError &error) {
      const std::string said = error.what();
      const std::string source = fmt::format("--set \"{}\": ", setting);
      complain(said.starts_with(source) ? said.substr(source.size()) : said);
    }
  }

  void unit_of(const std::string &value)
  {
    const Quantity quantity = parse_quantity(value);
    if (quantity.dimension)
      unit_ = si_unit(*quantity.dimension);
  }

  const std::string &text_;
  ParameterTable table_;
  std::string unit_ = "-";
};
} // namespace

double FitParameter::value(double place) const
{
  if (place <= 0)
    return low;
  if (place >= 1)
    return high;
  return logarithmic ? low * std::pow(high / low, place)
                     : low + place * (high - low);
}

double FitParameter::slope(double place) const
{
  return logarithmic ? value(place) * std::log(high / low) : high - low;
}

std::string FitParameter::setting(double place) const
{
  return fmt::format("{} = {}", path, value(place));
}

std::string FitParameter::words() const
{
  return fmt::format("{} = {} .. {}", path, low, high);
}

std::vector<FitParameter>
read_fit_parameters(const std::vector<std::string> &texts,
                    const RunOptions &options)
{
  if (texts.empty())
    throw InputError("expected at least one --fit \"Section/Name = LOW .. "
                     "HIGH\", for example --fit \"Contact/Friction coefficient "
                     "= 0.1 .. 0.8\"");
  std::vector<FitParameter> parameters;
  for (const std::string &text : texts) {
    parameters.push_back(FitReader(text, options).read());
    if (std::ranges::count(
            parameters, parameters.back().path, &FitParameter::path) > 1)
      throw InputError(
          fmt::format("--fit: {} is named twice", parameters.back().path));
  }
  return parameters;
}
} // namespace tamp::apps
