// The vector and matrix types of the engine: Eigen in double precision, never vectorised.
//
// EIGEN_DONT_VECTORIZE is part of the determinism contract: vectorised sums associate differently
// on different instruction sets.
// SPDX-License-Identifier: MIT
#pragma once

#ifndef EIGEN_DONT_VECTORIZE
#error "Impetus: expected EIGEN_DONT_VECTORIZE, as the target impetus::engine defines it"
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace impetus::inline numerics {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// Where a body is: `p_WB` (metres) places its centre of mass, `R_WB` (unit) turns body into world.
struct Pose {
  Vector3 position{Vector3::Zero()};
  Quaternion orientation{Quaternion::Identity()};

  [[nodiscard]] Vector3 transform(const Vector3& p_BP) const {
    return position + orientation * p_BP;
  }
};

}  // namespace impetus::inline numerics
