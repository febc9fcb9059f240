// SPDX-License-Identifier: MIT
#include "engine/shapes/self_intersections.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline shapes {
namespace {

/// Above Shewchuk's (7 + 56 ε) ε with ε = 2^-53.
constexpr double kRelativeError = 1e-15;

int sign_of(double value) { return (value > 0.0 ? 1 : 0) - (value < 0.0 ? 1 : 0); }

/// A sum held as parts that do not overlap, smallest first, so that the last has the sum's sign.
class ExactSum {
 public:
  /// Adds sign · x · y · z.
  void add(double sign, double x, double y, double z) {
    const double product = x * y;
    add_product(sign * z, std::fma(x, y, -product));
    add_product(sign * z, product);
  }

  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : sign_of(parts_[size_ - 1]); }

 private:
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }

  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + parts_[i];
      const double of_part = sum - value;
      const double error = (value - (sum - of_part)) + (parts_[i] - of_part);
      if (error != 0.0) {
        parts_[kept++] = error;
      }
      value = sum;
    }
    if (value != 0.0) {
      parts_[kept++] = value;
    }
    size_ = kept;
  }

  std::array<double, 4 * 24 + 1> parts_{};  // 24 products of at most four parts each
  std::size_t size_{0};
};

void add_determinant(ExactSum& sum, double sign, const Vector3& a, const Vector3& b,
                     const Vector3& c) {
  sum.add(sign, a.x(), b.y(), c.z());
  sum.add(sign, a.y(), b.z(), c.x());
  sum.add(sign, a.z(), b.x(), c.y());
  sum.add(-sign, a.z(), b.y(), c.x());
  sum.add(-sign, a.x(), b.z(), c.y());
  sum.add(-sign, a.y(), b.x(), c.z());
}

using Corners = std::array<std::uint32_t, 3>;

constexpr int kNoAxis = -1;

/// An axis along which the triangle can be flattened and keeps an area; none when it has no area.
int flattening_axis(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  int likely = 0;
  (b - a).cross(c - a).cwiseAbs().maxCoeff(&likely);
  for (int i = 0; i < 3; ++i) {
    const int axis = (likely + i) % 3;
    if (turn_across(axis, a, b, c) != 0) {
      return axis;
    }
  }
  return kNoAxis;
}

/// Whether the flattened `point` is in the flattened triangle, its border included.
bool covers(int axis, const Triangle& triangle, const Vector3& point) {
  const auto& [a, b, c] = triangle;
  const std::array<int, 3> turns{turn_across(axis, a, b, point), turn_across(axis, b, c, point),
                                 turn_across(axis, c, a, point)};
  const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
  return *least >= 0 || *most <= 0;
}

/// Whether flattened segments p–q and r–s, not all in line, have a point in common.
bool segments_meet(int axis, const Vector3& p, const Vector3& q, const Vector3& r,
                   const Vector3& s) {
  const int turn_r = turn_across(axis, p, q, r);
  const int turn_s = turn_across(axis, p, q, s);
  const bool in_line = turn_r == 0 && turn_s == 0;
  return !in_line && turn_r * turn_s <= 0 &&
         turn_across(axis, r, s, p) * turn_across(axis, r, s, q) <= 0;
}

/// A segment in the triangle's own plane. One that runs along an edge ends on it or meets the next.
bool meets_in_plane(const Vector3& from, const Vector3& to, const Triangle& triangle) {
  const int axis = flattening_axis(triangle);
  const auto& [a, b, c] = triangle;
  return covers(axis, triangle, from) || covers(axis, triangle, to) ||
         segments_meet(axis, from, to, a, b) || segments_meet(axis, from, to, b, c) ||
         segments_meet(axis, from, to, c, a);
}

/// Whether the segment and the triangle, border included, have a point in common.
bool meets(const Vector3& from, const Vector3& to, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const int side_from = side_of_plane(a, b, c, from);
  const int side_to = side_of_plane(a, b, c, to);
  if (side_from == 0 && side_to == 0) {
    return meets_in_plane(from, to, triangle);
  }
  if (side_from == side_to) {
    return false;
  }
  const std::array<int, 3> turns{side_of_plane(from, to, a, b), side_of_plane(from, to, b, c),
                                 side_of_plane(from, to, c, a)};
  const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
  return *least >= 0 || *most <= 0;
}

/// Whether all of `b` lies strictly on one side of the plane of `a`.
bool apart(const Triangle& a, const Triangle& b) {
  const int side = side_of_plane(a[0], a[1], a[2], b[0]);
  return side != 0 && side == side_of_plane(a[0], a[1], a[2], b[1]) &&
         side == side_of_plane(a[0], a[1], a[2], b[2]);
}

/// Triangles share a point exactly when an edge of one meets the other.
bool share_a_point(const Triangle& a, const Triangle& b) {
  if (apart(a, b) || apart(b, a)) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (meets(a[i], a[(i + 1) % 3], b) || meets(b[i], b[(i + 1) % 3], a)) {
      return true;
    }
  }
  return false;
}

/// Triangles with the common corners a[i] and b[j]. What else they share reaches the edge opposite
/// to that corner in one of them.
bool meet_beyond_corner(const Triangle& a, std::size_t i, const Triangle& b, std::size_t j) {
  return meets(a[(i + 1) % 3], a[(i + 2) % 3], b) || meets(b[(j + 1) % 3], b[(j + 2) % 3], a);
}

/// Triangles with a common edge, opposite to a[i] and b[j]: in one plane and on the same side.
bool meet_beyond_edge(const Triangle& a, std::size_t i, const Triangle& b, std::size_t j) {
  const Vector3& from = a[(i + 1) % 3];
  const Vector3& to = a[(i + 2) % 3];
  if (side_of_plane(a[0], a[1], a[2], b[j]) != 0) {
    return false;
  }
  const int axis = flattening_axis(a);
  return turn_across(axis, from, to, a[i]) == turn_across(axis, from, to, b[j]);
}

/// The place in `a` of a corner that `b` has (`wanted`) or has not.
std::size_t corner(const Corners& a, const Corners& b, bool wanted) {
  std::size_t i = 0;
  while (i < 2 && (std::find(b.begin(), b.end(), a[i]) != b.end()) != wanted) {
    ++i;
  }
  return i;
}

Triangle placed(const TriangleMesh& mesh, const Corners& corners) {
  return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

constexpr std::size_t kTrianglesPerLeaf = 4;

Bounds box_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return bounds_of(std::array{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
}

void count(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, SelfIntersections& found) {
  const TriangleMeeting how = meeting(mesh, mesh.triangles[a], mesh.triangles[b]);
  found.crossing_pairs += how == TriangleMeeting::kCrossing ? 1 : 0;
  found.folded_pairs += how == TriangleMeeting::kFolded ? 1 : 0;
}

/// A binary tree of boxes over the triangles: the children of node n are 2n + 1 and 2n + 2, and a
/// node's triangles are a run of `order_`.
class BoxTree {
 public:
  explicit BoxTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    for (const auto& triangle : mesh.triangles) {
      boxes_.push_back(box_of(mesh, triangle));
    }
    build(0, 0, order_.size());
  }

  SelfIntersections search() {
    within(0);
    return found_;
  }

 private:
  /// A box about a run of triangles.
  struct Node {
    Bounds box;
    std::size_t begin;
    std::size_t end;

    [[nodiscard]] std::size_t size() const { return end - begin; }
    [[nodiscard]] bool is_leaf() const { return size() <= kTrianglesPerLeaf; }
  };

  void build(std::size_t index, std::size_t begin, std::size_t end) {
    Bounds box = boxes_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) {
      box.include(boxes_[order_[i]]);
    }
    nodes_.resize(std::max(nodes_.size(), index + 1));
    nodes_[index] = {box, begin, end};
    if (nodes_[index].is_leaf()) {
      return;
    }
    int axis = 0;
    box.sides().maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto place = [this, axis](std::uint32_t triangle) {
      return boxes_[triangle].least[axis] + boxes_[triangle].most[axis];
    };
    const auto at = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end),
                     [&place](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    build(2 * index + 1, begin, middle);
    build(2 * index + 2, middle, end);
  }

  void within(std::size_t index) {
    const Node& node = nodes_[index];
    if (!node.is_leaf()) {
      within(2 * index + 1);
      within(2 * index + 2);
      between(2 * index + 1, 2 * index + 2);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      for (std::size_t j = i + 1; j < node.end; ++j) {
        test(order_[i], order_[j]);
      }
    }
  }

  void between(std::size_t a, std::size_t b) {
    if (!nodes_[a].box.overlaps(nodes_[b].box)) {
      return;
    }
    if (nodes_[a].size() < nodes_[b].size()) {
      std::swap(a, b);
    }
    if (!nodes_[a].is_leaf()) {
      between(2 * a + 1, b);
      between(2 * a + 2, b);
      return;
    }
    for (std::size_t i = nodes_[a].begin; i < nodes_[a].end; ++i) {
      for (std::size_t j = nodes_[b].begin; j < nodes_[b].end; ++j) {
        test(order_[i], order_[j]);
      }
    }
  }

  void test(std::uint32_t a, std::uint32_t b) {
    if (boxes_[a].overlaps(boxes_[b])) {
      count(mesh_, a, b, found_);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Bounds> boxes_;
  std::vector<Node> nodes_;
  SelfIntersections found_;
};

}  // namespace

int side_of_plane(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d - a;
  const double determinant = u.cross(v).dot(w);
  const Vector3 size(std::abs(u.y() * v.z()) + std::abs(u.z() * v.y()),
                     std::abs(u.z() * v.x()) + std::abs(u.x() * v.z()),
                     std::abs(u.x() * v.y()) + std::abs(u.y() * v.x()));
  if (std::abs(determinant) > kRelativeError * size.dot(w.cwiseAbs())) {
    return sign_of(determinant);
  }
  ExactSum sum;
  add_determinant(sum, 1.0, b, c, d);
  add_determinant(sum, -1.0, a, c, d);
  add_determinant(sum, 1.0, a, b, d);
  add_determinant(sum, -1.0, a, b, c);
  return sum.sign();
}

int turn_across(int axis, const Vector3& a, const Vector3& b, const Vector3& c) {
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  const double left = (b[x] - a[x]) * (c[y] - a[y]);
  const double right = (b[y] - a[y]) * (c[x] - a[x]);
  if (std::abs(left - right) > kRelativeError * (std::abs(left) + std::abs(right))) {
    return sign_of(left - right);
  }
  ExactSum sum;
  sum.add(1.0, b[x], c[y], 1.0);
  sum.add(-1.0, b[y], c[x], 1.0);
  sum.add(-1.0, a[x], c[y], 1.0);
  sum.add(1.0, a[y], c[x], 1.0);
  sum.add(1.0, a[x], b[y], 1.0);
  sum.add(-1.0, a[y], b[x], 1.0);
  return sum.sign();
}

TriangleMeeting meeting(const TriangleMesh& mesh, const Corners& a, const Corners& b) {
  const auto shared = std::count_if(a.begin(), a.end(), [&b](std::uint32_t vertex) {
    return std::find(b.begin(), b.end(), vertex) != b.end();
  });
  const Triangle of_a = placed(mesh, a);
  const Triangle of_b = placed(mesh, b);
  if (shared == 3 || flattening_axis(of_a) == kNoAxis || flattening_axis(of_b) == kNoAxis) {
    return TriangleMeeting::kNone;
  }
  if (shared == 0) {
    return share_a_point(of_a, of_b) ? TriangleMeeting::kCrossing : TriangleMeeting::kNone;
  }
  const bool folded = shared == 1
                          ? meet_beyond_corner(of_a, corner(a, b, true), of_b, corner(b, a, true))
                          : meet_beyond_edge(of_a, corner(a, b, false), of_b, corner(b, a, false));
  return folded ? TriangleMeeting::kFolded : TriangleMeeting::kNone;
}

SelfIntersections find_self_intersections(const TriangleMesh& mesh) {
  return mesh.triangles.empty() ? SelfIntersections{} : BoxTree(mesh).search();
}

}  // namespace impetus::inline shapes
