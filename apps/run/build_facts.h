// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_build_facts_h
#define apps_run_build_facts_h

#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// What the build knows about itself; filled in by CMake.
struct BuildFacts {
  std::string version;
  std::string build_type;
  /// Names and versions of the compiler and of libraries.
  std::vector<std::pair<std::string, std::string>> libraries;
  /// Folders that may hold the examples: of the source, of an installation.
  std::string source_examples, installed_examples;
};

BuildFacts build_facts();
} // namespace tamp::apps

#endif
