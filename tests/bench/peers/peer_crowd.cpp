// SPDX-License-Identifier: MIT
#include "tests/bench/peers/peer_crowd.hpp"

#include <Eigen/Eigenvalues>

namespace impetus {

PrincipalShape in_principal_axes(const CrowdShape& shape) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solved(shape.mass.inertia);
  Matrix3 axes = solved.eigenvectors();
  if (axes.determinant() < 0.0) {
    axes.col(2) = -axes.col(2);
  }
  PrincipalShape principal{shape.mesh, Quaternion(axes), solved.eigenvalues()};
  for (Vector3& vertex : principal.mesh.vertices) {
    vertex = axes.transpose() * vertex;
  }
  return principal;
}

}  // namespace impetus
