// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_citations_h
#define apps_citations_h

#include <apps/input/parameter_table.h>

#include <string>
#include <string_view>
#include <vector>

namespace tamp::apps
{
/// The keys of all works that the program stands on: itself, libraries, laws
/// and methods, in that order.
std::vector<std::string_view> all_citations();

/// The keys of those that runs of an input stand on, in the same order. The
/// sections that are given say which runs these are.
std::vector<std::string_view> citations_of(const ParameterTable &table);

/// The BibTeX entry of a key.
std::string citation(std::string_view key);
} // namespace tamp::apps

#endif
