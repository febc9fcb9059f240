// SPDX-License-Identifier: MIT
#include "engine/trees/coverage.hpp"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "engine/trees/surface_part.hpp"
#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline trees {
namespace {

constexpr int kMostHalvings = 100;
/// Of the mesh's size: what is narrower is rounding.
constexpr double kNarrow = 1e-12;
/// A node must take this share of a piece, else halving gets on faster.
constexpr double kLeastGain = 0.1;
/// Once a triangle is known to be bare somewhere, pieces below this share of that area are not
/// looked into any more but called bare.
constexpr double kIndifferent = 1e-4;

using Polygon = std::vector<Vector3>;

/// A node that stands at the level.
struct CoveringNode {
  Volume volume;
  RoundedBox form;
  Vector3 reach_m;  ///< upright
};

/// A piece of a triangle that is not settled, and the nodes that may hold it.
struct Piece {
  Polygon corners;
  std::vector<const CoveringNode*> candidates;
  double area_m2;
  int halvings;
};

double area_of(const Polygon& polygon) {
  Vector3 twice = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice.norm();
}

/// The index of the corner that the longest side starts from.
std::size_t longest_side(const Polygon& polygon) {
  std::size_t longest = 0;
  double squared_m2 = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double here = (polygon[(i + 1) % polygon.size()] - polygon[i]).squaredNorm();
    if (here > squared_m2) {
      squared_m2 = here;
      longest = i;
    }
  }
  return longest;
}

/// Whether a plane parts the polygon from the volume: one across the volume's axes, or across the
/// line from it to the polygon's middle. Any piece that is small beside its distance is parted.
bool parted(const CoveringNode& node, const Polygon& polygon) {
  Polygon local;
  Vector3 middle = Vector3::Zero();
  for (const Vector3& corner : polygon) {
    local.push_back(node.form.local(corner));
    middle += local.back() / static_cast<double>(polygon.size());
  }
  const Vector3 reach = node.form.reach_m();
  if (!bounds_of(local).overlaps({-reach, reach})) {
    return true;
  }
  const Vector3& half = node.form.half_extents_m;
  const Vector3 direction = middle - middle.cwiseMin(half).cwiseMax(-half);
  const double length = direction.norm();
  const double support = direction.cwiseAbs().dot(half) + length * node.form.radius_m;
  return length > 0.0 && std::all_of(local.begin(), local.end(), [&](const Vector3& corner) {
           return corner.dot(direction) > support;
         });
}

/// What is left of a polygon when the hull of its outline's part in the node is taken away: each
/// chain of the outline outside the node, closed by a chord.
std::vector<Polygon> rest_of(const Polygon& polygon, const CoveringNode& node) {
  std::vector<Polygon> chains;
  const std::size_t count = polygon.size();
  bool met = false;
  Polygon before_first;  // of the outline, up to the first entry: it ends the last chain
  Polygon* chain = &before_first;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3& from = polygon[i];
    const Vector3& to = polygon[(i + 1) % count];
    const bool starts_within = holds(node.volume, from);
    const bool ends_within = holds(node.volume, to);
    // What the node holds decides; at its surface the span may differ by rounding.
    auto span = span_within(node.form, from, to);
    if (starts_within) {
      span = SegmentSpan{0.0, span ? span->end : 0.0};
    } else {
      chain->push_back(from);
      span = ends_within && !span ? SegmentSpan{1.0, 1.0} : span;
    }
    if (!span) {
      continue;
    }
    met = true;
    if (!starts_within) {
      chain->push_back(from + span->begin * (to - from));
    }
    if (ends_within) {
      continue;
    }
    chains.push_back({Vector3(from + span->end * (to - from))});
    chain = &chains.back();
  }
  if (!met) {
    return {polygon};
  }
  if (chains.empty()) {
    return {};
  }
  chains.back().insert(chains.back().end(), before_first.begin(), before_first.end());
  return chains;
}

/// Cut across the middle of the longest side.
std::vector<Polygon> halves_of(const Polygon& polygon) {
  const std::size_t side = longest_side(polygon);
  const Vector3& from = polygon[side];
  const Vector3 along = polygon[(side + 1) % polygon.size()] - from;
  const HalfSpace above{along, along.dot(from + 0.5 * along)};
  const auto [one, other] = cut({{polygon, Vector3::Zero(), 0}}, above);
  std::vector<Polygon> halves;
  for (const SurfacePart& part : {one, other}) {
    for (const Facet& facet : part) {
      halves.push_back(facet.corners);
    }
  }
  return halves;
}

/// Looks for what of one triangle is bare.
class TriangleCover {
 public:
  TriangleCover(Polygon triangle, const std::vector<const CoveringNode*>& candidates,
                double narrow_m)
      : narrow_m_(narrow_m) {
    add(std::move(triangle), candidates, 0);
  }

  double uncovered_m2() {
    while (!open_.empty()) {
      const Piece piece = open_.top();
      open_.pop();
      settle(piece);
    }
    return bare_m2_;
  }

 private:
  /// The greatest piece first, so that bare ground is found before its ragged edge.
  struct Smaller {
    bool operator()(const Piece& a, const Piece& b) const { return a.area_m2 < b.area_m2; }
  };

  void add(Polygon corners, const std::vector<const CoveringNode*>& candidates, int halvings) {
    const double area = area_of(corners);
    const std::size_t side = corners.size() < 3 ? 0 : longest_side(corners);
    const double length_m = (corners[(side + 1) % corners.size()] - corners[side]).norm();
    if (area <= narrow_m_ * length_m) {
      return;
    }
    Piece piece{std::move(corners), {}, area, halvings};
    for (const CoveringNode* node : candidates) {
      if (std::all_of(piece.corners.begin(), piece.corners.end(),
                      [&](const Vector3& corner) { return holds(node->volume, corner); })) {
        return;
      }
      if (!parted(*node, piece.corners)) {
        piece.candidates.push_back(node);
      }
    }
    if (piece.candidates.empty()) {
      bare_m2_ += area;
    } else {
      open_.push(std::move(piece));
    }
  }

  void settle(const Piece& piece) {
    if (piece.halvings >= kMostHalvings || piece.area_m2 < kIndifferent * bare_m2_) {
      bare_m2_ += piece.area_m2;
      return;
    }
    std::vector<Polygon> best;
    double least_m2 = (1.0 - kLeastGain) * piece.area_m2;
    bool found = false;
    for (const CoveringNode* node : piece.candidates) {
      std::vector<Polygon> rest = rest_of(piece.corners, *node);
      double left_m2 = 0.0;
      for (const Polygon& polygon : rest) {
        left_m2 += area_of(polygon);
      }
      if (left_m2 < least_m2) {
        least_m2 = left_m2;
        best = std::move(rest);
        found = true;
      }
    }
    const int halvings = piece.halvings + (found ? 0 : 1);
    for (Polygon& polygon : found ? best : halves_of(piece.corners)) {
      add(std::move(polygon), piece.candidates, halvings);
    }
  }

  double narrow_m_;
  double bare_m2_{0.0};
  std::priority_queue<Piece, std::vector<Piece>, Smaller> open_;
};

std::vector<CoveringNode> nodes_at(const VolumeTree& tree, int level) {
  std::vector<CoveringNode> nodes;
  for (const std::int32_t index : tree.standing_at(level)) {
    const Volume volume = tree.volume(index);
    const RoundedBox form = rounded_box(volume);
    nodes.push_back({volume, form, upright_reach_m(form)});
  }
  return nodes;
}

std::vector<const CoveringNode*> near(const std::vector<CoveringNode>& nodes,
                                      const Bounds& bounds) {
  std::vector<const CoveringNode*> found;
  for (const CoveringNode& node : nodes) {
    const Vector3 apart =
        (node.form.centre - bounds.most).cwiseMax(bounds.least - node.form.centre) - node.reach_m;
    if ((apart.array() <= 0.0).all()) {
      found.push_back(&node);
    }
  }
  return found;
}

}  // namespace

double uncovered_area_m2(const TriangleMesh& mesh, const VolumeTree& tree, int level) {
  const std::vector<CoveringNode> nodes = nodes_at(tree, level);
  const double narrow_m = kNarrow * bounds_of(mesh).sides().norm();
  double bare_m2 = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Polygon corners{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    TriangleCover cover(corners, near(nodes, bounds_of(corners)), narrow_m);
    bare_m2 += cover.uncovered_m2();
  }
  return bare_m2;
}

}  // namespace impetus::inline trees
