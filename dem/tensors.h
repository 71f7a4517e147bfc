// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_tensors_h
#define dem_tensors_h

#include <Eigen/Core>

namespace tamp::dem
{
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
} // namespace tamp::dem

#endif
