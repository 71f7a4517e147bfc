// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_units_h
#define apps_input_units_h

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tamp::apps
{
/// Something in the user's input, arguments or folders that cannot be used:
/// the program ends with exit code 2 and this message.
class InputError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The exponents of metre, kilogram, second and radian in a unit.
struct Dimension {
  int metre = 0, kilogram = 0, second = 0, radian = 0;
  bool operator==(const Dimension &) const = default;
};

/// Dimensions of the quantities that inputs speak of.
namespace dimension
{
inline constexpr Dimension number{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension pressure{-1, 1, -2, 0};
inline constexpr Dimension force{1, 1, -2, 0};
inline constexpr Dimension density{-3, 1, 0, 0};
inline constexpr Dimension rate{0, 0, -1, 0};
inline constexpr Dimension speed{1, 0, -1, 0};
inline constexpr Dimension angular_speed{0, 0, -1, 1};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension surface_energy{0, 1, -2, 0};
} // namespace dimension

/// The SI unit, for example "Pa"; "-" for a pure number.
std::string si_unit(const Dimension &dimension);
/// What a dimension is called and how it is written, for example "a pressure,
/// for example 200 MPa".
std::string described(const Dimension &dimension);

/// A value in SI and the dimension of its unit, if it had one.
struct Quantity {
  double value = 0;
  std::optional<Dimension> dimension;
};

/// Reads "200 MPa", "5 mm/min", "4 g/cm3", "1e-5 1/s", "5 %" or "0.3". Throws
/// InputError saying what is wrong.
Quantity parse_quantity(std::string_view text);

/// Reads a quantity of a given dimension; a bare number is SI. Throws
/// InputError if the unit does not fit.
double parse_quantity(std::string_view text, const Dimension &expected);

/// The factor to SI and the dimension of "mm/min"; empty if `unit` is no unit.
std::optional<Quantity> parse_unit(std::string_view unit);

/// The text without blanks at both ends.
std::string_view trimmed(std::string_view text);
} // namespace tamp::apps

#endif
