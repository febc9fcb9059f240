// SPDX-License-Identifier: MIT
#include "experiments/drawing/rounded_box_mesh.hpp"

#include <utility>

namespace impetus::inline drawing {
namespace {

/// Places the eight pieces of the sphere and joins them.
class Joiner {
 public:
  explicit Joiner(int parts) : parts_(parts) {
    for (unsigned octant = 0; octant < 8; ++octant) {
      add_octant(octant);
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
      add_strips(axis);
      add_faces(axis);
    }
  }

  RoundedBoxMesh take() { return std::move(mesh_); }

 private:
  using Steps = std::array<int, 3>;  ///< along the three axes; they add up to parts_

  static float sign(unsigned octant, unsigned axis) {
    return (octant >> axis & 1U) != 0 ? -1.0F : 1.0F;
  }

  /// Rows of an octant's triangle have one vertex fewer each.
  [[nodiscard]] std::uint32_t index(unsigned octant, const Steps& steps) const {
    const int row = steps[0];
    const int of_octant = (parts_ + 1) * (parts_ + 2) / 2;
    const int before = row * (parts_ + 1) - row * (row - 1) / 2;
    return static_cast<std::uint32_t>(static_cast<int>(octant) * of_octant + before + steps[1]);
  }

  void add_octant(unsigned octant) {
    for (int i = 0; i <= parts_; ++i) {
      for (int j = 0; i + j <= parts_; ++j) {
        add_vertex(octant, {i, j, parts_ - i - j});
      }
    }
    for (int i = 0; i < parts_; ++i) {
      for (int j = 0; i + j < parts_; ++j) {
        const int k = parts_ - i - j;
        const std::uint32_t a = index(octant, {i + 1, j, k - 1});
        const std::uint32_t b = index(octant, {i, j + 1, k - 1});
        add_triangle(a, b, index(octant, {i, j, k}));
        if (k > 1) {
          add_triangle(a, b, index(octant, {i + 1, j + 1, k - 2}));
        }
      }
    }
  }

  void add_vertex(unsigned octant, const Steps& steps) {
    const Eigen::Vector3f corner(sign(octant, 0), sign(octant, 1), sign(octant, 2));
    const Eigen::Vector3f along(static_cast<float>(steps[0]), static_cast<float>(steps[1]),
                                static_cast<float>(steps[2]));
    const Eigen::Vector3f normal = corner.cwiseProduct(along).normalized();
    mesh_.vertices.push_back(
        {{corner.x(), corner.y(), corner.z()}, {normal.x(), normal.y(), normal.z()}});
  }

  /// Between the octants on both sides of the plane across `axis`.
  void add_strips(unsigned axis) {
    const unsigned next = (axis + 1) % 3;
    const unsigned last = (axis + 2) % 3;
    for (unsigned octant = 0; octant < 8; ++octant) {
      if ((octant >> axis & 1U) != 0) {
        continue;
      }
      const unsigned across = octant | 1U << axis;
      for (int step = 0; step < parts_; ++step) {
        Steps from{};
        from[next] = step;
        from[last] = parts_ - step;
        Steps to{};
        to[next] = step + 1;
        to[last] = parts_ - step - 1;
        add_quad({index(octant, from), index(octant, to), index(across, to), index(across, from)});
      }
    }
  }

  /// The two sides of the box that `axis` leaves by.
  void add_faces(unsigned axis) {
    const unsigned next = 1U << (axis + 1) % 3;
    const unsigned last = 1U << (axis + 2) % 3;
    Steps tip{};
    tip[axis] = parts_;
    for (const unsigned side : {0U, 1U << axis}) {
      add_quad({index(side, tip), index(side | next, tip), index(side | next | last, tip),
                index(side | last, tip)});
    }
  }

  void add_quad(const std::array<std::uint32_t, 4>& corners) {
    add_triangle(corners[0], corners[1], corners[2]);
    add_triangle(corners[0], corners[2], corners[3]);
  }

  /// Of a box with half extents and radius 1, which no triangle of is flat.
  [[nodiscard]] Eigen::Vector3f place(std::uint32_t vertex) const {
    const RoundedBoxMesh::Vertex& v = mesh_.vertices[vertex];
    return {v.corner[0] + v.normal[0], v.corner[1] + v.normal[1], v.corner[2] + v.normal[2]};
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3f across = (place(b) - place(a)).cross(place(c) - place(a));
    if (across.dot(place(a) + place(b) + place(c)) < 0.0F) {
      std::swap(b, c);
    }
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  int parts_;
  RoundedBoxMesh mesh_;
};

}  // namespace

RoundedBox posed(const RoundedBox& box, const Pose& pose) {
  return {pose.transform(box.centre), pose.orientation.toRotationMatrix() * box.axes,
          box.half_extents_m, box.radius_m};
}

RoundedBoxMesh rounded_box_mesh(int parts) { return Joiner(parts).take(); }

}  // namespace impetus::inline drawing
