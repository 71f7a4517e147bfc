// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_parameter_table_h
#define apps_input_parameter_table_h

#include <apps/input/units.h>

#include <algorithm>
#include <filesystem>
#include <iosfwd>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// The values a number may have.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool without_minimum = false; ///< the minimum itself is not allowed
  bool without_maximum = false;

  bool contains(double value) const;
};

inline constexpr Range positive{
    0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range not_negative{
    0, std::numeric_limits<double>::infinity(), false, false};

/// How parameters are printed.
enum class TableFormat { prm, json, md };

/// All parameters of the program: names in sections, defaults, ranges, units,
/// texts and values. Files are in the format of deal.II's ParameterHandler or
/// in JSON. Paths are written "Section/Name" or "Section/Subsection/Name".
class ParameterTable
{
public:
  ParameterTable();
  ~ParameterTable();

  /// @name Declaration, in the section entered last
  /// @{
  void enter(const std::string &section);
  void leave();
  void quantity(const std::string &name,
                const std::string &value,
                const Dimension &dimension,
                const Range &range,
                const std::string &text);
  /// Quantities divided by commas; a unit after the last one holds for all
  /// that have none.
  void quantities(const std::string &name,
                  const std::string &value,
                  const Dimension &dimension,
                  const Range &range,
                  const std::string &text);
  void integer(const std::string &name,
               long value,
               long minimum,
               const std::string &text);
  void integers(const std::string &name,
                const std::string &value,
                const std::string &text);
  void choice(const std::string &name,
              const std::string &value,
              const std::vector<std::string> &choices,
              const std::string &text);
  /// Any number of the choices, divided by commas.
  void choices(const std::string &name,
               const std::string &value,
               const std::vector<std::string> &choices,
               const std::string &text);
  void flag(const std::string &name, bool value, const std::string &text);
  void text(const std::string &name,
            const std::string &value,
            const std::string &text);
  /// @}

  /// @name Reading. Throws InputError naming file and line, the value, what was
  /// expected and the nearest name.
  /// @{
  /// Takes the values of a .prm or, by its ending, .json file.
  void read(const std::filesystem::path &file);
  /// Takes "Section/Name = value", as written after --set, or one entry of a
  /// list of numbers, "Section/Name[2] = value", counted from 1.
  void set(const std::string &assignment);
  /// @}

  /// @name Values in SI. The path must be one that was declared.
  /// @{
  /// Of an entry of a list, too: "Section/Name[2]".
  double number(const std::string &path) const;
  /// Entries of a list of numbers; none if the path is that of no list.
  std::optional<std::size_t> list_size(const std::string &path) const;
  std::vector<double> numbers(const std::string &path) const;
  long whole(const std::string &path) const;
  std::vector<std::size_t> indices(const std::string &path) const;
  std::string word(const std::string &path) const;
  std::vector<std::string> words(const std::string &path) const;
  bool on(const std::string &path) const;
  /// Whether a file or --set gave the value.
  bool given(const std::string &path) const;
  /// Whether a file or --set gave any entry of this section, such as "Die".
  bool given_below(const std::string &section) const;
  /// The folder of the file that gave the value, to find files named in it.
  std::filesystem::path folder(const std::string &path) const;
  /// @}

  /// Throws InputError: where the value was given, the value, and `problem`.
  [[noreturn]] void complain(const std::string &path,
                             const std::string &problem) const;

  /// All parameters with defaults, units, ranges and texts.
  void print(std::ostream &out, TableFormat format) const;
  /// All values in SI, as an input file.
  void echo(std::ostream &out) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The choice of a word: `choices` are in the order of the enumeration.
template <class Choice>
Choice chosen(const ParameterTable &table,
              const std::string &path,
              const std::vector<std::string> &choices)
{
  return static_cast<Choice>(std::distance(
      choices.begin(), std::ranges::find(choices, table.word(path))));
}
} // namespace tamp::apps

#endif
