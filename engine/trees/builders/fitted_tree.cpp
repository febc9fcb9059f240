// SPDX-License-Identifier: MIT
#include "engine/trees/builders/fitted_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/builders/volume_fits.hpp"

namespace impetus::inline trees {
namespace {

// Where to cut a part of the surface in two so that the volumes round the halves fit best.

/// Fits a volume to the part that `shape` is of.
using QuickFit = std::function<Fit(const PartShape& shape)>;

constexpr std::size_t kMostFacets = 600;
constexpr std::array<double, 5> kPlaces{0.5, 0.375, 0.625, 0.25, 0.75};
constexpr std::size_t kFacetPlanes = 2;    ///< along each axis
constexpr double kSameOffsetShare = 1e-7;  ///< of the size
constexpr double kAcross = 1.0 - 1e-9;     ///< cosine
constexpr double kInteriorShare = 1e-3;    ///< of the extent, at both ends
/// A half's extent counts as this much reach: it is what the next cuts have to overcome.
constexpr double kHalfExtentShare = 0.3;

/// Every so manieth facet.
SurfacePart sketch_of(const SurfacePart& part) {
  const std::size_t stride = (part.size() + kMostFacets - 1) / kMostFacets;
  SurfacePart sketch;
  for (std::size_t i = 0; i < part.size(); i += stride) {
    sketch.push_back(part[i]);
  }
  return sketch;
}

/// Where the largest of the facets across `axis` lie along it, the largest area first.
std::vector<double> facet_offsets(const SurfacePart& part, const Vector3& axis, double size_m) {
  std::vector<std::pair<double, double>> by_offset;  // offset, doubled area
  for (const Facet& facet : part) {
    const Vector3 doubled = doubled_area_vector(facet);
    if (std::fabs(doubled.dot(axis)) > kAcross * doubled.norm()) {
      by_offset.emplace_back(axis.dot(facet.corners[0]), doubled.norm());
    }
  }
  std::sort(by_offset.begin(), by_offset.end());
  std::vector<std::pair<double, double>> by_area;  // −doubled area, offset
  for (const auto& [offset, area] : by_offset) {
    if (by_area.empty() || offset - by_area.back().second > kSameOffsetShare * size_m) {
      by_area.emplace_back(0.0, offset);
    }
    by_area.back().first -= area;
  }
  std::sort(by_area.begin(), by_area.end());
  std::vector<double> offsets;
  offsets.reserve(by_area.size());
  for (const auto& [area, offset] : by_area) {
    offsets.push_back(offset);
  }
  return offsets;
}

std::vector<HalfSpace> planes_across(const Vector3& axis, const SurfacePart& part,
                                     const PartShape& shape, double size_m, bool at_places) {
  double least = axis.dot(shape.points.front());
  double most = least;
  for (const Vector3& point : shape.points) {
    least = std::min(least, axis.dot(point));
    most = std::max(most, axis.dot(point));
  }
  const double extent = most - least;
  std::vector<HalfSpace> planes;
  std::size_t of_facets = 0;
  for (const double offset : facet_offsets(part, axis, size_m)) {
    const bool interior =
        offset > least + kInteriorShare * extent && offset < most - kInteriorShare * extent;
    if (interior && of_facets < kFacetPlanes) {
      planes.push_back({axis, offset});
      ++of_facets;
    }
  }
  for (const double place : kPlaces) {
    if (at_places) {
      planes.push_back({axis, least + place * extent});
    }
  }
  return planes;
}

std::vector<HalfSpace> planes_worth_trying(const SurfacePart& part, const PartShape& shape,
                                           const Matrix3& frame, double size_m) {
  std::vector<HalfSpace> planes;
  const auto add = [&](const Vector3& axis, bool at_places) {
    for (const HalfSpace& plane : planes_across(axis, part, shape, size_m, at_places)) {
      planes.push_back(plane);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    add(frame.col(axis), true);
  }
  for (const Vector3& normal : shape.normals) {
    add(normal, false);
  }
  return planes;
}

double cost_of(const SurfacePart& half, const QuickFit& fit) {
  const PartShape shape = shape_of(half);
  const double reach_m =
      fit(shape).reach_m + kHalfExtentShare * bounds_of(shape.points).sides().maxCoeff();
  return reach_m * reach_m * area_m2(half);
}

/// Of planes across the axes of `frame` - at five places along each, and in the largest facets that
/// lie across it, and in its own largest facets - the one that leaves the least sum over both
/// halves of area × (reach + 0.3 extent)², measured on at most 600 facets of the part. None when no
/// plane leaves surface on both sides.
std::optional<HalfSpace> best_halving(const SurfacePart& part, const PartShape& shape,
                                      const Matrix3& frame, double size_m, const QuickFit& fit) {
  const SurfacePart sketch = sketch_of(part);
  std::optional<HalfSpace> best;
  double least = 0.0;
  for (const HalfSpace& plane : planes_worth_trying(part, shape, frame, size_m)) {
    const auto [above, below] = cut(sketch, plane, kSnapShare * size_m);
    if (above.empty() || below.empty()) {
      continue;
    }
    double cost = cost_of(above, fit);
    if (!best || cost < least) {
      cost += cost_of(below, fit);
      if (!best || cost < least) {
        least = cost;
        best = plane;
      }
    }
  }
  return best;
}

// Which kind of volume a node gets.
//
//   kind        cost    one overlap test of two such volumes, relative to 4 for two spheres
//   sphere         4
//   line           9
//   box           25
//   rectangle     30
//
// `swept` takes what reaches least beyond the object, the cheapest of those within 2 %.
// `heterogeneous` takes the least reach × √cost. A tree refined by one level costs about eight
// times the tests and errs about a third as much, so an error falls as the square root of what is
// spent on it: a dearer volume is worth its tests when it does better than that.
// (after Dingliana 2002, sec. 7.3)

/// A kind of volume, how it is fitted, and what its test costs.
struct Row {
  Fit (*fit)(const FitTask& task);
  double cost;
};

// From the cheapest to the dearest: the first wins among equals.
constexpr Row kRows[] = {
    {fit_sphere, 4.0}, {fit_line, 9.0}, {fit_box, 25.0}, {fit_rectangle, 30.0}};

bool belongs(const Row& row, TreeKind kind) {
  return kind == TreeKind::kHeterogeneous || (row.fit == fit_box) == (kind == TreeKind::kBox);
}

constexpr double kNearTie = 1.02;

/// How many times less a kind of `cost` must reach than a sphere.
double price(TreeKind kind, double cost) {
  return kind == TreeKind::kHeterogeneous ? std::sqrt(cost) : 1.0;
}

/// The fit of the kind of volume that suits `kind` best, round the part that `shape` is of. A reach
/// below `negligible_m` counts as that. Precondition: `kind` is kBox, kSwept or kHeterogeneous.
Fit best_fit(TreeKind kind, const PartShape& shape, const RoughDistance& solid,
             const Matrix3& parent_frame, Effort effort, double negligible_m) {
  const FitTask task{&shape, DistanceToUse(solid, bounds_of(shape.points).sides().maxCoeff()),
                     frames_worth_trying(shape, parent_frame, effort), effort};
  Fit best;
  double least = 0.0;
  bool any = false;
  for (const Row& row : kRows) {
    if (!belongs(row, kind)) {
      continue;
    }
    Fit fit = row.fit(task);
    if (effort == Effort::kCareful) {
      fit.reach_m = reach_beyond_m(fit.volume, DistanceToUse(solid));
    }
    const double got = std::max(fit.reach_m, negligible_m) * price(kind, row.cost);
    if (!any || got * kNearTie < least) {
      best = fit;
      least = got;
      any = true;
    }
  }
  return best;
}

/// Shares of the solid's size.
constexpr double kFitMargin = 1e-12;
constexpr double kNegligibleReach = 1e-9;
/// A node that reaches no farther is kept whole when its children would be no better.
constexpr double kUnseen = 5e-4;

/// Cells of the grid of remembered distances: about seven across a node of the last level. Few
/// nodes do not repay a fine grid.
int rough_cells(const TreeSettings& settings) {
  double leaves = 1.0;
  for (int level = 0; level < settings.depth; ++level) {
    leaves *= settings.branching;
  }
  return static_cast<int>(std::clamp(7.0 * std::sqrt(leaves), 32.0, 160.0));
}

/// A node in the making.
struct FittedPiece {
  SurfacePart part;
  PartShape shape;
  Fit fit;
  bool whole{false};  ///< no plane cuts it
};

/// Builds one tree, level by level.
class FittedBuilder {
 public:
  FittedBuilder(const TriangleMesh& solid, const TreeSettings& settings, const Progress& progress)
      : solid_(&solid),
        settings_(&settings),
        progress_(&progress),
        description_(solid),
        bounds_(bounds_of(solid)),
        size_m_(bounds_.sides().maxCoeff()),
        distance_(description_.distance(), bounds_, rough_cells(settings)) {}

  BuiltTree build() {
    std::vector<FittedPiece> level;
    level.push_back(fitted(whole_surface(*solid_), Matrix3::Identity(), nullptr));
    add(level);
    for (level_ = 0; level_ < levels_to_build(*settings_) && !level.empty(); ++level_) {
      level = next_level(std::move(level));
      add(level);
    }
    report(1.0);
    return {VolumeTree(nodes_, std::move(starts_)), std::move(parts_)};
  }

 private:
  [[nodiscard]] double negligible_m() const { return kNegligibleReach * size_m_; }

  void report(double share) const {
    if (*progress_) {
      (*progress_)(share);
    }
  }

  Fit fit(const PartShape& shape, const Matrix3& frame, Effort effort) const {
    return best_fit(settings_->kind, shape, distance_, frame, effort, negligible_m());
  }

  /// The piece with its volume; `outer` has one that holds it, too, unless it is null.
  FittedPiece fitted(SurfacePart part, const Matrix3& frame, const Fit* outer) const {
    FittedPiece piece;
    piece.shape = shape_of(part);
    piece.fit = fit(piece.shape, frame, Effort::kCareful);
    if (outer != nullptr && outer->reach_m < piece.fit.reach_m) {
      piece.fit = *outer;
    } else {
      piece.fit.volume = grown_to_hold(piece.fit.volume, corners_of(part), kFitMargin * size_m_);
    }
    piece.part = std::move(part);
    return piece;
  }

  void add(const std::vector<FittedPiece>& level) {
    if (level.empty()) {
      return;
    }
    starts_.push_back(static_cast<std::int32_t>(nodes_.size()));
    for (const FittedPiece& piece : level) {
      nodes_.push_back({piece.fit.volume, 0, 0, description_.of(piece.fit.volume, piece.part)});
      parts_.push_back(piece.part);
    }
  }

  std::vector<FittedPiece> next_level(std::vector<FittedPiece> level) {
    std::vector<FittedPiece> finer;
    const auto count = static_cast<double>(level.size());
    for (std::size_t i = 0; i < level.size(); ++i) {
      report((level_ + static_cast<double>(i) / count) / levels_to_build(*settings_));
      const double reach_m = level[i].fit.reach_m;
      std::vector<FittedPiece> children = children_of(std::move(level[i]));
      if (children.size() > 1 && !idle(children, reach_m)) {
        VolumeNode& node = nodes_[static_cast<std::size_t>(starts_.back()) + i];
        node.first_child = static_cast<std::int32_t>(nodes_.size() + finer.size());
        node.child_count = static_cast<std::int32_t>(children.size());
        std::move(children.begin(), children.end(), std::back_inserter(finer));
      }
    }
    return finer;
  }

  /// Whether children merely repeat a node that reaches `reach_m`, which nobody sees.
  [[nodiscard]] bool idle(const std::vector<FittedPiece>& children, double reach_m) const {
    return reach_m <= kUnseen * size_m_ &&
           std::all_of(children.begin(), children.end(),
                       [&](const FittedPiece& child) { return child.fit.reach_m >= reach_m; });
  }

  /// The piece itself, alone, when nothing finer would be better.
  std::vector<FittedPiece> children_of(FittedPiece piece) const {
    std::vector<FittedPiece> pieces;
    pieces.push_back(std::move(piece));
    while (pieces.size() < static_cast<std::size_t>(settings_->branching)) {
      const std::size_t worst = worst_of(pieces);
      if (worst == pieces.size()) {
        break;
      }
      halve(pieces, worst);
    }
    return pieces;
  }

  /// The piece that reaches farthest of those worth cutting; their count when there is none.
  [[nodiscard]] std::size_t worst_of(const std::vector<FittedPiece>& pieces) const {
    std::size_t worst = pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const bool worth = !pieces[i].whole && pieces[i].fit.reach_m > negligible_m();
      if (worth && (worst == pieces.size() || pieces[i].fit.reach_m > pieces[worst].fit.reach_m)) {
        worst = i;
      }
    }
    return worst;
  }

  void halve(std::vector<FittedPiece>& pieces, std::size_t index) const {
    FittedPiece& piece = pieces[index];
    const std::optional<HalfSpace> plane = best_halving(
        piece.part, piece.shape, piece.fit.frame, size_m_,
        [&](const PartShape& shape) { return fit(shape, piece.fit.frame, Effort::kQuick); });
    if (!plane) {
      piece.whole = true;
      return;
    }
    auto [above, below] = cut(piece.part, *plane, kSnapShare * size_m_);
    const Fit outer = piece.fit;
    pieces[index] = fitted(std::move(above), outer.frame, &outer);
    pieces.push_back(fitted(std::move(below), outer.frame, &outer));
  }

  const TriangleMesh* solid_;
  const TreeSettings* settings_;
  const Progress* progress_;
  NodeDescription description_;
  Bounds bounds_;
  double size_m_;
  RoughDistance distance_;
  int level_{0};
  std::vector<VolumeNode> nodes_;
  std::vector<std::int32_t> starts_;
  std::vector<SurfacePart> parts_;
};

}  // namespace

BuiltTree build_fitted_tree(const TriangleMesh& solid, const TreeSettings& settings,
                            const Progress& progress) {
  require_buildable(solid, settings);
  return FittedBuilder(solid, settings, progress).build();
}

}  // namespace impetus::inline trees
