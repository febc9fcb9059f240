// SPDX-License-Identifier: MIT
#include "engine/shapes/mass_properties.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace impetus::inline shapes {
namespace {

// Sums that lose nothing to the number of their terms.

/// A running sum of vectors or matrices, number by number, with what rounding took from it kept
/// beside: its error does not grow with the count of terms. (Neumaier 1974)
template <typename Array>
class CompensatedSum {
 public:
  void add(const Array& term) {
    const Array next = sum_ + term;
    for (Eigen::Index i = 0; i < term.size(); ++i) {
      const bool larger = std::fabs(sum_(i)) >= std::fabs(term(i));
      lost_(i) += larger ? (sum_(i) - next(i)) + term(i) : (term(i) - next(i)) + sum_(i);
    }
    sum_ = next;
  }

  [[nodiscard]] Array total() const { return sum_ + lost_; }

  /// As if nothing had been kept.
  [[nodiscard]] Array plain_total() const { return sum_; }

 private:
  Array sum_{Array::Zero()};
  Array lost_{Array::Zero()};
};

/// Sums of this many terms are exact enough as they are, and recorded trials of small shapes rest
/// on their bits.
constexpr std::size_t kFewTriangles = 256;

}  // namespace

MassProperties solid_sphere(double radius_m, double density_kg_m3) {
  MassProperties result;
  result.volume_m3 = 4.0 / 3.0 * std::numbers::pi * radius_m * radius_m * radius_m;
  result.mass_kg = density_kg_m3 * result.volume_m3;
  result.inertia = Matrix3::Identity() * (0.4 * result.mass_kg * radius_m * radius_m);
  return result;
}

MassProperties solid_of(const TriangleMesh& mesh, double density_kg_m3) {
  if (mesh.triangles.empty()) {
    return {};
  }
  // The solid is the signed sum of the tetrahedra (origin, a, b, c). Each has volume D/6, first
  // moment D/24 (a+b+c) and second moments D/120 (aaᵀ + bbᵀ + ccᵀ + (a+b+c)(a+b+c)ᵀ), D = a·(b×c).
  const Vector3 origin = mesh.vertices[mesh.triangles.front()[0]];
  CompensatedSum<Eigen::Matrix<double, 1, 1>> six_volumes_sum;
  CompensatedSum<Vector3> first_sum;
  CompensatedSum<Matrix3> second_sum;
  for (const auto& triangle : mesh.triangles) {
    const Vector3 a = mesh.vertices[triangle[0]] - origin;
    const Vector3 b = mesh.vertices[triangle[1]] - origin;
    const Vector3 c = mesh.vertices[triangle[2]] - origin;
    const double determinant = a.dot(b.cross(c));
    const Vector3 sum = a + b + c;
    six_volumes_sum.add(Eigen::Matrix<double, 1, 1>(determinant));
    first_sum.add(determinant * sum);
    second_sum.add(determinant * (a * a.transpose() + b * b.transpose() + c * c.transpose() +
                                  sum * sum.transpose()));
  }
  const auto total_of = [&](const auto& sum) {
    return mesh.triangles.size() > kFewTriangles ? sum.total() : sum.plain_total();
  };
  const double six_volumes = total_of(six_volumes_sum)(0);
  const Vector3 first = total_of(first_sum);
  const Matrix3 second = total_of(second_sum);
  MassProperties result;
  result.volume_m3 = six_volumes / 6.0;
  result.mass_kg = density_kg_m3 * result.volume_m3;
  const Vector3 offset = first / (4.0 * six_volumes);
  result.centre = origin + offset;
  // A matrix of its own: scaled as an expression, Eigen scales one factor and loses the symmetry.
  const Matrix3 square = offset * offset.transpose();
  const Matrix3 covariance = density_kg_m3 * second / 120.0 - result.mass_kg * square;
  result.inertia = Matrix3::Identity() * covariance.trace() - covariance;
  return result;
}

TriangleMesh about_centre_of_mass(TriangleMesh mesh) {
  const Vector3 centre = solid_of(mesh, /*density_kg_m3=*/1.0).centre;
  for (Vector3& vertex : mesh.vertices) {
    vertex -= centre;
  }
  return mesh;
}

}  // namespace impetus::inline shapes
