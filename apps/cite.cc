// SPDX-License-Identifier: BSD-3-Clause
#include <apps/build_facts.h>
#include <apps/commands.h>

#include <fmt/format.h>

namespace tamp::apps
{
int print_citations()
{
  fmt::print(R"(@software{{tamp,
  title   = {{tamp: multiscale powder die compaction}},
  author  = {{{{The tamp authors}}}},
  version = {{{}}}
}}
@article{{dealii94,
  title   = {{The deal.II library, Version 9.4}},
  author  = {{Arndt, Daniel and others}},
  journal = {{Journal of Numerical Mathematics}},
  volume  = {{30}},
  number  = {{3}},
  pages   = {{231--246}},
  year    = {{2022}},
  doi     = {{10.1515/jnma-2022-0054}}
}}
)",
             build_facts().version);
  return exit_done;
}
} // namespace tamp::apps
