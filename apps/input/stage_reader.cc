// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/nearest_name.h>
#include <apps/input/stage_reader.h>

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tamp::apps
{
std::vector<std::string> split_stages(const std::string &stages)
{
  std::vector<std::string> result;
  std::size_t begin = 0;
  while (begin <= stages.size()) {
    const std::size_t end = std::min(stages.find(';', begin), stages.size());
    const auto stage =
        trimmed(std::string_view(stages).substr(begin, end - begin));
    if (!stage.empty())
      result.emplace_back(stage);
    begin = end + 1;
  }
  return result;
}

StageReader::StageReader(std::string stage, unsigned number)
    : stage_(std::move(stage)), number_(number)
{
  std::string word;
  for (const char letter : stage_ + " ") {
    if (letter != ' ' && letter != '\t' && letter != ',') {
      word += letter;
      continue;
    }
    if (!word.empty())
      words_.push_back(word);
    word.clear();
  }
}

void StageReader::fail(const std::string &expected) const
{
  const std::string at =
      done() ? "it ends too early" : fmt::format("'{}'", words_[next_]);
  throw InputError(fmt::format(
      "stage {} '{}': {}; expected {}", number_, stage_, at, expected));
}

bool StageReader::accept(const std::string &word)
{
  if (done() || words_[next_] != word)
    return false;
  ++next_;
  return true;
}

std::size_t StageReader::expect(const std::vector<std::string> &words)
{
  for (std::size_t i = 0; i < words.size(); ++i)
    if (accept(words[i]))
      return i;
  std::string expected = fmt::format("'{}'", fmt::join(words, "', '"));
  if (words.size() > 1) {
    expected = "one of " + expected;
    if (!done())
      expected +=
          fmt::format(" (nearest: '{}')", nearest_name(words_[next_], words));
  }
  fail(expected);
}

bool StageReader::at_number() const
{
  return !done() &&
         std::string_view("0123456789.+-").find(words_[next_].front()) !=
             std::string_view::npos;
}

Quantity StageReader::any_quantity()
{
  if (done())
    fail("a number");
  std::string text = words_[next_];
  if (next_ + 1 < words_.size() && parse_unit(words_[next_ + 1]))
    text += " " + words_[next_ + 1];
  try {
    const Quantity quantity = parse_quantity(text);
    next_ += text == words_[next_] ? 1 : 2;
    return quantity;
  } catch (const InputError &) {
    fail("a number with its unit");
  }
}

double StageReader::quantity(const Dimension &dimension)
{
  const std::size_t start = next_;
  const Quantity quantity = any_quantity();
  if (quantity.dimension && !(*quantity.dimension == dimension)) {
    next_ = start;
    fail(described(dimension));
  }
  return quantity.value;
}

double StageReader::positive(const Dimension &dimension)
{
  const std::size_t start = next_;
  const double value = quantity(dimension);
  if (!(value > 0)) {
    next_ = start;
    fail("a number above 0; compression is positive");
  }
  return value;
}

unsigned StageReader::whole()
{
  const std::size_t start = next_;
  const double value = quantity(dimension::number);
  if (value < 1 || value > 1e6 || value != std::floor(value)) {
    next_ = start;
    fail("a whole number > 0");
  }
  return static_cast<unsigned>(value);
}

std::string StageReader::rest()
{
  if (done())
    fail("the name of a file");
  // As it was written: a name may hold blanks and commas.
  std::size_t place = 0;
  for (std::size_t i = 0; i < next_; ++i)
    place = stage_.find(words_[i], place) + words_[i].size();
  next_ = words_.size();
  return std::string(trimmed(std::string_view(stage_).substr(place)));
}

void StageReader::finish() const
{
  if (!done())
    fail("nothing more");
}
} // namespace tamp::apps
