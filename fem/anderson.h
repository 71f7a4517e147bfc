// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_anderson_h
#define fem_anderson_h

#include <deque>
#include <vector>

namespace tamp::fem
{
/// Anderson acceleration of the fixed point u = G(u).
/// Source: H. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011), algorithm AA.
class Anderson
{
public:
  /// @param depth  number of differences remembered; zero: plain iteration.
  explicit Anderson(unsigned depth) : depth_(depth) {}

  /// The next iterate from u and its change g = G(u) - u. Columns that depend
  /// on newer ones are left out of the least squares problem.
  std::vector<double> next(const std::vector<double> &u,
                           const std::vector<double> &g);

private:
  struct Difference {
    std::vector<double> u, g;
  };
  unsigned depth_;
  std::vector<double> last_u_, last_g_;
  std::deque<Difference> differences_; ///< newest first
};
} // namespace tamp::fem

#endif
