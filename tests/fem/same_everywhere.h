// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_same_everywhere_h
#define tests_fem_same_everywhere_h

#include <fem/ranks.h>

#include <cstring>
#include <vector>

namespace tamp::fem::test
{
/// Does every rank hold the bits of rank 0? The answer is everywhere the same.
inline bool same_everywhere(const std::vector<double> &values,
                            const Ranks &ranks)
{
  std::vector<double> first = values;
  ranks.spread(first);
  return ranks.all(std::memcmp(first.data(),
                               values.data(),
                               values.size() * sizeof(double)) == 0);
}
} // namespace tamp::fem::test

#endif
