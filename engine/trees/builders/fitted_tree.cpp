// SPDX-License-Identifier: MIT
#include "engine/trees/builders/fitted_tree.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/trees/builders/part_halving.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/builders/volume_fits.hpp"

namespace impetus::inline trees {
namespace {

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
