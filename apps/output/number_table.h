// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_number_table_h
#define apps_output_number_table_h

#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A CSV file that this program wrote: remarks, a header, numbers.
struct NumberTable {
  std::vector<std::string> remarks; ///< without #
  std::vector<std::string> names;   ///< "name[unit]"
  std::vector<std::vector<double>> rows;

  /// The number of a column. Throws OutputError naming it if there is none.
  std::size_t column(const std::string &name) const;
};

/// Throws OutputError naming the file if it is none.
NumberTable read_number_table(const std::filesystem::path &file);
} // namespace tamp::apps

#endif
