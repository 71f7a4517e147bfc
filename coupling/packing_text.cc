// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/packing_text.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace tamp::coupling
{
namespace
{
using dem::Matrix3;
using dem::UnitCell;
using dem::Vector3;

void append(std::string &text, double value)
{
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

/// The words of a line; blanks, tabs and commas stand between them.
std::vector<std::string_view> words_of(std::string_view line)
{
  constexpr std::string_view gaps = " \t\r,;";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(gaps); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(gaps, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(gaps, end);
  }
  return words;
}

std::string quoted(std::string_view word)
{
  std::string text(1, '\'');
  text.append(word).push_back('\'');
  return text;
}

std::optional<double> number_of(std::string_view word)
{
  if (word.starts_with('+'))
    word.remove_prefix(1);
  double value = 0;
  const auto [end, error] =
      std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() ||
      !std::isfinite(value))
    return {};
  return value;
}

class TextReader
{
public:
  explicit TextReader(const std::string &name) : name_(name) {}

  UnitCell read(const std::string &text)
  {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      ++line_;
      const auto words = words_of(line);
      if (words.empty())
        continue;
      if (words.front().starts_with('#'))
        take_header(line);
      else
        take_grain(words);
    }
    if (!has_box_)
      complain("expected a line '# L Lx Ly Lz' or '# box' with the three "
               "edges [m]");
    if (cell_.radius.size() < 2)
      complain("expected grains, 'x y z r' [m] in a line");
    finish();
    return std::move(cell_);
  }

private:
  [[noreturn]] void complain(const std::string &problem, std::size_t line) const
  {
    throw std::invalid_argument(name_ + ":" + std::to_string(line) + ": " +
                                problem);
  }
  [[noreturn]] void complain(const std::string &problem) const
  {
    complain(problem, std::max<std::size_t>(line_, 1));
  }

  void take_header(std::string_view line)
  {
    line.remove_prefix(line.find('#') + 1);
    const auto words = words_of(line);
    if (words.empty() || (words.front() != "L" && words.front() != "box"))
      return;
    std::vector<double> values;
    for (std::size_t k = 1; k < words.size(); ++k) {
      const auto value = number_of(words[k]);
      if (!value)
        break; // a remark behind the numbers
      values.push_back(*value);
    }
    const std::size_t wanted = words.front() == "L" ? 3 : 9;
    if (values.size() != wanted)
      complain("expected " + std::to_string(wanted) + " numbers behind " +
               quoted(words.front()) + ", not " +
               std::to_string(values.size()));
    if (has_box_)
      complain("the box was given before");
    Matrix3 &h = cell_.box.h;
    h = wanted == 3 ? Matrix3(Vector3(values.data()).asDiagonal())
                    : Matrix3(Eigen::Map<Matrix3>(values.data()));
    // An edge of h is a column, as values are stored.
    if (!(h.determinant() > 0))
      complain("the edges do not span a right-handed box");
    has_box_ = true;
  }

  void take_grain(const std::vector<std::string_view> &words)
  {
    double values[4];
    if (words.size() != 4)
      complain("expected 'x y z r' [m], not " + std::to_string(words.size()) +
               " values");
    for (std::size_t k = 0; k < 4; ++k) {
      const auto value = number_of(words[k]);
      if (!value)
        complain(quoted(words[k]) + " is no number");
      values[k] = *value;
    }
    if (!(values[3] > 0))
      complain("r = " + std::string(words[3]) + ": expected a radius above 0");
    cell_.place.emplace_back(values[0], values[1], values[2]);
    cell_.radius.push_back(values[3]);
    lines_.push_back(line_);
  }

  void finish()
  {
    const Matrix3 inverse = cell_.box.h.inverse();
    for (Vector3 &place : cell_.place)
      place = inverse * place;
    cell_.reference_volume = cell_.box.volume();
    dem::Neighbours near;
    try {
      near = dem::find_neighbours(cell_.box, cell_.place, cell_.radius, 0);
    } catch (const std::runtime_error &error) {
      complain(error.what());
    }
    for (const auto &[i, j] : near.pairs) {
      const double distance =
          cell_.box.nearest_image(cell_.place[j] - cell_.place[i]).norm();
      if (distance < std::max(cell_.radius[i], cell_.radius[j]))
        complain("the grain covers the centre of the one in line " +
                     std::to_string(lines_[i]) + ", or lies inside it",
                 lines_[j]);
    }
  }

  const std::string &name_;
  std::size_t line_ = 0;
  bool has_box_ = false;
  UnitCell cell_;
  std::vector<std::size_t> lines_; // of grains
};
} // namespace

std::string packing_to_text(const UnitCell &cell)
{
  std::string text = "# periodic packing of " + std::to_string(cell.size()) +
                     " spheres, relative density ";
  append(text, cell.relative_density());
  const Matrix3 &h = cell.box.h;
  const bool straight = h.isDiagonal(0);
  text +=
      straight ? "; columns x y z r [m]\n# L" : "; columns x y z r [m]\n# box";
  for (int edge = 0; edge < 3; ++edge)
    for (int k = 0; k < 3; ++k)
      if (!straight || k == edge)
        append(text += ' ', h(k, edge));
  text += '\n';
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Vector3 s = cell.place[i];
    const Vector3 x = h * (s - Vector3(s.array().floor()));
    for (int k = 0; k < 3; ++k)
      append(text, x[k]), text += ' ';
    append(text, cell.initial_radius_of(i));
    text += '\n';
  }
  return text;
}

UnitCell packing_from_text(const std::string &text, const std::string &name)
{
  return TextReader(name).read(text);
}
} // namespace tamp::coupling
