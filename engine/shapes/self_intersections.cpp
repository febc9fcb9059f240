// SPDX-License-Identifier: MIT
#include "engine/shapes/self_intersections.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/shapes/triangle_meeting.hpp"

namespace impetus::inline shapes {
namespace {

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

SelfIntersections find_self_intersections(const TriangleMesh& mesh) {
  return mesh.triangles.empty() ? SelfIntersections{} : BoxTree(mesh).search();
}

}  // namespace impetus::inline shapes
