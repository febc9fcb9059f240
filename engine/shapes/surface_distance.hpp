// How far a point lies from a closed surface, and on which side: many questions to one mesh.
//
// A tree of boxes over the triangles finds the nearest one. Its sign is that of the angle-weighted
// pseudonormal of the face, edge or vertex that the nearest point lies on, which is right wherever
// the surface does not pass through itself (Bærentzen and Aanæs 2005).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_distance.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// The point of a surface nearest to another; the triangle of the least index among equals.
struct NearestOnSurface {
  double distance_m{0.0};
  Vector3 point{Vector3::Zero()};
  std::uint32_t triangle{0};
};

/// How far a point is from the surface, and which triangle is nearest.
struct SignedDistance {
  double distance_m{0.0};  ///< negative inside
  std::uint32_t triangle{0};
};

/// The tree of boxes and the pseudonormals of one surface.
class SurfaceDistance {
 public:
  /// Copies what it needs of `mesh`. Precondition: find_defects(mesh).none(), one triangle or more.
  explicit SurfaceDistance(const TriangleMesh& mesh);

  /// Quicker when `near` is a triangle near the point.
  [[nodiscard]] NearestOnSurface nearest(const Vector3& point, std::uint32_t near = 0) const;

  /// Metres; negative inside the solid.
  [[nodiscard]] double signed_distance_m(const Vector3& point) const;

  /// The same, and the nearest triangle; quicker when `near` is a triangle near the point.
  [[nodiscard]] SignedDistance signed_distance(const Vector3& point, std::uint32_t near = 0) const;

  /// To one triangle: never less than to the surface (metres, not negative).
  [[nodiscard]] double distance_to_m(std::uint32_t triangle, const Vector3& point) const;

  /// Every triangle that comes within the radius of the point, and some that do not.
  [[nodiscard]] std::vector<Triangle> triangles_near(const Vector3& point, double radius_m) const;

  /// The corners of a triangle of the mesh.
  [[nodiscard]] Triangle corners(std::uint32_t triangle) const;

 private:
  /// A box about a run of triangles.
  struct Node {
    Vector3 least;
    Vector3 most;
    std::uint32_t begin;  ///< of its triangles in order_
    std::uint32_t end;
    std::uint32_t second_child;  ///< the first follows its parent; 0 for a leaf
  };

  /// The nearest point so far.
  struct Found {
    double squared_m2;
    Vector3 point;
    std::uint32_t triangle;
    TriangleFeature feature;
  };

  void build(std::uint32_t begin, std::uint32_t end, const std::vector<Vector3>& middles);
  void add_normals();
  void search(std::uint32_t index, const Vector3& point, Found& best) const;
  void try_triangles(const Node& node, const Vector3& point, Found& best) const;
  [[nodiscard]] Found find(const Vector3& point, std::uint32_t near) const;
  [[nodiscard]] const Vector3& pseudonormal(const Found& at) const;

  TriangleMesh mesh_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Triangle> in_order_;                    ///< corners of the triangles of order_
  std::vector<Vector3> face_normals_;                 ///< unit, by triangle
  std::vector<std::array<Vector3, 3>> edge_normals_;  ///< by triangle, of any length
  std::vector<Vector3> vertex_normals_;               ///< of any length
};

/// Whether a point lies inside the solid that a closed mesh bounds. by the winding number, the sum
/// of the triangles' solid angles over 4π (Van Oosterom and Strackee 1983). Points of the surface
/// itself may fall either way.
bool contains(const TriangleMesh& solid, const Vector3& point);

}  // namespace impetus::inline shapes
