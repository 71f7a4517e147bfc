// SPDX-License-Identifier: BSD-3-Clause
#include <tests/benchmark/rows.h>

int main(int argc, char **argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  tamp::speed::Packings packings;
  tamp::speed::add_sweeps(packings);
  tamp::speed::add_pair_lists(packings);
  tamp::speed::add_maps(packings);
  tamp::speed::add_tangents(packings);
  tamp::speed::add_bytes(packings);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
