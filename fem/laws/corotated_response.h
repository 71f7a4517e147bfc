// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_corotated_response_h
#define fem_laws_corotated_response_h

#include <fem/laws/corotation.h>

namespace tamp::fem
{
/// An increment whose logarithmic stretch is larger than this fails.
inline constexpr double largest_log_stretch = 1;

/// What a plastic law does around its integration: it refuses an increment that
/// is impossible or too large, follows the relative density, and leaves the
/// state as it was after a failure.
/// @param integrate  of (corotation, now, tangent): gives `now`, which has the
///                   new relative density already, all the rest of the new
///                   state, and the tangent if it is wanted; says how far the
///                   answer can be trusted, `failed` if there is none.
template <class State, class Integrate>
Response corotated_response(const State &old,
                            State &now,
                            const Deformation &deformation,
                            const Integrate &integrate)
{
  now = old;
  Response response{old.stress, {}, old.relative_density, Status::failed};
  const Corotation corotation(deformation.relative_F);
  if (!corotation.is_possible() ||
      corotation.log_stretch().norm() > largest_log_stretch)
    return response;
  now.relative_density = old.relative_density / corotation.volume_ratio();
  response.status = integrate(corotation, now, response.tangent);
  if (response.status == Status::failed) {
    now = old;
    response.tangent = {};
    return response;
  }
  response.stress = now.stress;
  response.relative_density = now.relative_density;
  return response;
}
} // namespace tamp::fem

#endif
