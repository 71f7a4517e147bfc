// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tamp::apps
{
namespace
{
struct Unit {
  std::string_view name;
  double factor;
  Dimension dimension;
};

constexpr Dimension mass{0, 1, 0, 0};
constexpr Dimension energy{2, 1, -2, 0};

constexpr std::array units{
    Unit{"1", 1, dimension::number},
    Unit{"-", 1, dimension::number},
    Unit{"%", 1e-2, dimension::number},
    Unit{"m", 1, dimension::length},
    Unit{"cm", 1e-2, dimension::length},
    Unit{"mm", 1e-3, dimension::length},
    Unit{"um", 1e-6, dimension::length},
    Unit{"\u00b5m", 1e-6, dimension::length}, // micro sign
    Unit{"\u03bcm", 1e-6, dimension::length}, // Greek mu
    Unit{"nm", 1e-9, dimension::length},
    Unit{"Pa", 1, dimension::pressure},
    Unit{"kPa", 1e3, dimension::pressure},
    Unit{"MPa", 1e6, dimension::pressure},
    Unit{"GPa", 1e9, dimension::pressure},
    Unit{"bar", 1e5, dimension::pressure},
    Unit{"N", 1, dimension::force},
    Unit{"mN", 1e-3, dimension::force},
    Unit{"kN", 1e3, dimension::force},
    Unit{"MN", 1e6, dimension::force},
    Unit{"s", 1, dimension::time},
    Unit{"ms", 1e-3, dimension::time},
    Unit{"us", 1e-6, dimension::time},
    Unit{"ns", 1e-9, dimension::time},
    Unit{"min", 60, dimension::time},
    Unit{"h", 3600, dimension::time},
    Unit{"kg", 1, mass},
    Unit{"g", 1e-3, mass},
    Unit{"mg", 1e-6, mass},
    Unit{"t", 1e3, mass},
    Unit{"J", 1, energy},
    Unit{"mJ", 1e-3, energy},
    Unit{"kJ", 1e3, energy},
    Unit{"Hz", 1, dimension::rate},
    Unit{"rad", 1, dimension::angle},
    Unit{"deg", std::numbers::pi / 180, dimension::angle},
    Unit{"\u00b0", std::numbers::pi / 180, dimension::angle},
};

struct Kind {
  Dimension dimension;
  std::string_view si, name, example;
};

constexpr std::array kinds{
    Kind{dimension::number, "-", "a number without a unit", "0.3"},
    Kind{dimension::length, "m", "a length", "600 um"},
    Kind{dimension::pressure, "Pa", "a pressure", "200 MPa"},
    Kind{dimension::force, "N", "a force", "10 kN"},
    Kind{dimension::density, "kg/m3", "a density", "2650 kg/m3"},
    Kind{dimension::rate, "1/s", "a rate", "1e-5 1/s"},
    Kind{dimension::speed, "m/s", "a speed", "5 mm/min"},
    Kind{dimension::angular_speed, "rad/s", "a spin", "100 rad/s"},
    Kind{dimension::time, "s", "a time", "10 ms"},
    Kind{dimension::angle, "rad", "an angle", "30 deg"},
    Kind{dimension::surface_energy, "J/m2", "an energy per area", "0.2 J/m2"},
};

const Kind *kind_of(const Dimension &dimension)
{
  for (const Kind &kind : kinds)
    if (kind.dimension == dimension)
      return &kind;
  return nullptr;
}

// One factor of a unit: a name with an exponent, "m3", "m^-2", "s".
std::optional<Quantity> parse_factor(std::string_view factor)
{
  int exponent = 1;
  std::string_view name = factor;
  if (factor != "1") {
    const std::size_t end = factor.find_last_not_of("0123456789^-");
    if (end != std::string_view::npos && end + 1 < factor.size()) {
      name = factor.substr(0, end + 1);
      std::string_view digits = factor.substr(end + 1);
      if (digits.front() == '^')
        digits.remove_prefix(1);
      const auto [rest, error] = std::from_chars(
          digits.data(), digits.data() + digits.size(), exponent);
      if (error != std::errc() || rest != digits.data() + digits.size() ||
          std::abs(exponent) > 9)
        return {};
    }
  }
  for (const Unit &unit : units)
    if (unit.name == name) {
      const Dimension &d = unit.dimension;
      return Quantity{std::pow(unit.factor, exponent),
                      Dimension{d.metre * exponent,
                                d.kilogram * exponent,
                                d.second * exponent,
                                d.radian * exponent}};
    }
  return {};
}
} // namespace

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string si_unit(const Dimension &dimension)
{
  if (const Kind *kind = kind_of(dimension))
    return std::string(kind->si);
  std::string unit;
  const auto append = [&](std::string_view name, int exponent) {
    if (exponent != 0)
      unit += fmt::format("{}{}{}",
                          unit.empty() ? "" : " ",
                          name,
                          exponent == 1 ? "" : fmt::format("^{}", exponent));
  };
  append("kg", dimension.kilogram);
  append("m", dimension.metre);
  append("s", dimension.second);
  append("rad", dimension.radian);
  return unit;
}

std::string described(const Dimension &dimension)
{
  if (const Kind *kind = kind_of(dimension))
    return fmt::format("{}, for example {}", kind->name, kind->example);
  return fmt::format("a quantity in {}", si_unit(dimension));
}

std::optional<Quantity> parse_unit(std::string_view unit)
{
  Quantity result{1, Dimension{}};
  bool divide = false;
  unit = trimmed(unit);
  if (unit.empty())
    return {};
  while (!unit.empty()) {
    const std::size_t end = unit.find_first_of(" */");
    const auto factor = parse_factor(unit.substr(0, end));
    if (!factor)
      return {};
    const int sign = divide ? -1 : 1;
    result.value *= std::pow(factor->value, sign);
    result.dimension->metre += sign * factor->dimension->metre;
    result.dimension->kilogram += sign * factor->dimension->kilogram;
    result.dimension->second += sign * factor->dimension->second;
    result.dimension->radian += sign * factor->dimension->radian;
    if (end == std::string_view::npos)
      break;
    const std::string_view rest = trimmed(unit.substr(end));
    divide = rest.front() == '/';
    unit = trimmed(divide || rest.front() == '*' ? rest.substr(1) : rest);
    if (unit.empty())
      return {};
  }
  return result;
}

Quantity parse_quantity(std::string_view text)
{
  text = trimmed(text);
  if (!text.empty() && text.front() == '+')
    text.remove_prefix(1);
  double number = 0;
  const auto [rest, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number))
    throw InputError(fmt::format("'{}' is not a number", text));
  const std::string_view unit =
      trimmed(text.substr(static_cast<std::size_t>(rest - text.data())));
  if (unit.empty())
    return {number, {}};
  const auto factor = parse_unit(unit);
  if (!factor)
    throw InputError(fmt::format("'{}' is not a unit that is known", unit));
  return {number * factor->value, factor->dimension};
}

double parse_quantity(std::string_view text, const Dimension &expected)
{
  const Quantity quantity = parse_quantity(text);
  if (quantity.dimension && !(*quantity.dimension == expected)) {
    const Kind *kind = kind_of(*quantity.dimension);
    throw InputError(
        kind ? fmt::format("'{}' is {}", trimmed(text), kind->name)
             : fmt::format("'{}' has the wrong unit", trimmed(text)));
  }
  return quantity.value;
}
} // namespace tamp::apps
