// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_stage_reader_h
#define apps_input_stage_reader_h

#include <apps/input/units.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// Divides "press to density 0.85; unload to 5 % of peak" at semicolons; empty
/// stages are left out.
std::vector<std::string> split_stages(const std::string &stages);

/// Walks through the words of one stage. Every function throws InputError
/// naming the stage, the word and what was expected.
class StageReader
{
public:
  StageReader(std::string stage, unsigned number);

  /// Takes the next word if it is this one.
  bool accept(const std::string &word);
  /// Takes the next word, which must be one of these; returns which.
  std::size_t expect(const std::vector<std::string> &words);
  /// Takes a number and its unit.
  double quantity(const Dimension &dimension);
  /// Takes a number above zero and its unit.
  double positive(const Dimension &dimension);
  /// Takes a number with any unit or none.
  Quantity any_quantity();
  unsigned whole();
  /// Takes all that is left as one text, a name of a file; must not be empty.
  std::string rest();
  /// Does the next word begin like a number?
  bool at_number() const;
  bool done() const { return next_ == words_.size(); }
  /// Throws if words are left.
  void finish() const;
  [[noreturn]] void fail(const std::string &expected) const;

private:
  std::string stage_;
  unsigned number_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};
} // namespace tamp::apps

#endif
