// SPDX-License-Identifier: MIT
#include "engine/trees/builders/medial_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "engine/trees/builders/medial_balls.hpp"
#include "engine/trees/builders/sphere_cover.hpp"
#include "engine/trees/surface_part.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline trees {
namespace {

// Few spheres over a part, chosen so that the next level can follow each of them equally well.
//
// Where the surface under one sphere is more intricate than under the others, its children fit
// worse, and the worst decides the level. Such a sphere is pressed to give some of its surface to
// its neighbours, until that helps no more or makes this level too loose.

/// The spheres of a part, and how well they and their children fit.
struct BalancedCover {
  std::vector<Sphere> spheres;   ///< their power cells are the parts of the children
  double stand_off_m{0.0};       ///< with which one sphere each can cover the cells
  double next_stand_off_m{0.0};  ///< with which as many spheres each can
  double outside_m3{0.0};        ///< volumes of the spheres outside the solid, summed

  /// Which of two covers is better: the product of what should be small. Stand-offs up to `limit_m`
  /// are as good as any; the next level's is a length and so counts more than a volume.
  [[nodiscard]] double cost(double limit_m) const;
};

constexpr int kPresses = 10;
constexpr int kInVain = 3;  ///< presses without success before starting softer from the best
constexpr double kSofter = 0.4;
constexpr double kFirstPress = 0.15;  ///< share of the stand-off

/// What of a part is nearest to one sphere.
struct Cell {
  std::vector<Vector3> points;
  std::vector<InnerPoint> candidates;
};

std::vector<Cell> cells_of(const std::vector<Sphere>& spheres, const std::vector<Vector3>& points,
                           const std::vector<InnerPoint>& candidates) {
  std::vector<Cell> cells(spheres.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    Cell& cell = cells[least_power(spheres, points[p])];
    cell.points.push_back(points[p]);
    cell.candidates.push_back(candidates[p]);
  }
  return cells;
}

/// A cover, and where it is worst.
struct Judgement {
  BalancedCover cover;
  std::size_t worst{0};  ///< the sphere whose children fit worst
};

Judgement judge(const SurfaceDistance& surface, const OutsidePoints& outside,
                const std::vector<Sphere>& spheres, const std::vector<Cell>& cells,
                std::size_t most) {
  Judgement judgement{{spheres}, 0};
  BalancedCover& cover = judgement.cover;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].points.empty()) {
      continue;
    }
    const InnerPoint centre =
        best_centre(surface, cells[i].points, inner_point(surface, spheres[i].centre));
    const double needed_m = stand_off_m(centre, cells[i].points);
    cover.stand_off_m = std::max(cover.stand_off_m, needed_m);
    cover.outside_m3 += outside.volume_m3(centre.point, centre.depth_m + needed_m);
    const double next_m =
        cover_points_quickly(surface, cells[i].points, cells[i].candidates, most).stand_off_m;
    if (next_m > cover.next_stand_off_m) {
      cover.next_stand_off_m = next_m;
      judgement.worst = i;
    }
  }
  return judgement;
}

double BalancedCover::cost(double limit_m) const {
  const double over = std::max(1.0, stand_off_m / limit_m);
  return over * over * next_stand_off_m * std::sqrt(outside_m3);
}

/// `most` spheres or fewer over `points`; candidate i is the medial ball at point i. Above
/// `limit_m`, the stand-off of these spheres counts against a partition.
BalancedCover balanced_cover(const SurfaceDistance& surface, const OutsidePoints& outside,
                             const std::vector<Vector3>& points,
                             const std::vector<InnerPoint>& candidates, std::size_t most,
                             double limit_m) {
  const SphereCover cover = cover_points(surface, outside, points, candidates, most);
  std::vector<Sphere> spheres = spheres_of(cover);
  limit_m = std::max(limit_m, cover.stand_off_m);
  BalancedCover best;
  double least = std::numeric_limits<double>::infinity();
  double press_m = kFirstPress * cover.stand_off_m;
  int in_vain = 0;
  std::size_t worst_of_best = 0;
  for (int turn = 0; turn <= kPresses; ++turn) {
    const Judgement judgement =
        judge(surface, outside, spheres, cells_of(spheres, points, candidates), most);
    const double cost = judgement.cover.cost(limit_m);
    if (cost < least) {
      best = judgement.cover;
      least = cost;
      worst_of_best = judgement.worst;
      in_vain = 0;
      spheres[judgement.worst].radius_m -= press_m;
    } else if (++in_vain < kInVain) {
      spheres[judgement.worst].radius_m -= press_m;
    } else {
      in_vain = 0;
      press_m *= kSofter;
      spheres = best.spheres;
      spheres[worst_of_best].radius_m -= press_m;
    }
  }
  return best;
}

/// How many samples of a part to fit to, where its children will be split and where they will not,
/// and how many points to estimate volumes by. More of them cost time and gain little.
constexpr std::array<std::size_t, 2> kPoints{300, 400};
constexpr std::size_t kPointsAtTheEnd = 250;
constexpr std::size_t kOutside = 6'000;
/// The root may reach this much farther than it must, to leave less volume outside.
constexpr double kSlackOfTheRoot = 1.04;
/// Shares of the solid's size: what radii exceed their need by, and what is too small to refine.
constexpr double kSphereMargin = 1e-11;
constexpr double kNegligibleError = 1e-9;

/// A node in the making.
struct SpherePart {
  Sphere sphere;
  SurfacePart part;
};

/// Each sphere with its piece; spheres without one are dropped.
std::vector<SpherePart> shared_out(const SurfacePart& part, const std::vector<Sphere>& spheres) {
  std::vector<SurfacePart> cells = power_cells(part, spheres);
  std::vector<SpherePart> result;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    if (!cells[i].empty()) {
      result.push_back({spheres[i], std::move(cells[i])});
    }
  }
  return result;
}

/// The pieces of a node and the stand-off with which its grandchildren can cover it.
struct Split {
  std::vector<SpherePart> cells;
  double next_stand_off_m{0.0};
  OutsidePoints outside{};
};

/// What there is to choose from when a part is covered.
struct Material {
  std::vector<Vector3> points;
  std::vector<InnerPoint> candidates;
  OutsidePoints outside;
};

/// Builds one tree, level by level.
class MedialBuilder {
 public:
  MedialBuilder(const TriangleMesh& solid, const TreeSettings& settings, const Progress& progress)
      : settings_(settings), progress_(progress), description_(solid) {
    size_m_ = bounds_of(solid).sides().norm();
    parts_.push_back(whole_surface(solid));
    add_node(bound(parts_.front()), 0.0);
  }

  BuiltTree build() {
    for (int level = 0; level < levels_to_build(settings_) && split_level(level); ++level) {
    }
    return {VolumeTree(nodes_, starts_), std::move(parts_)};
  }

 private:
  /// Every level takes about as long as the next: more nodes, smaller parts.
  [[nodiscard]] double share_done(int level, std::size_t node, std::size_t nodes) const {
    return (level + static_cast<double>(node) / static_cast<double>(nodes)) /
           levels_to_build(settings_);
  }

  void add_node(const Sphere& sphere, double limit_m) {
    nodes_.push_back({sphere, 0, 0, description_.of(sphere, parts_[nodes_.size()])});
    limits_m_.push_back(limit_m);
  }

  /// False when nothing finer would change anything.
  bool split_level(int level) {
    const auto begin = static_cast<std::size_t>(starts_.back());
    const std::size_t end = nodes_.size();
    const bool look_ahead = level + 2 <= settings_.depth;
    std::vector<Split> splits(end - begin);
    double worst_m = 0.0;
    for (std::size_t node = begin; node < end; ++node) {
      if (progress_) {
        progress_(share_done(level, node - begin, end - begin));
      }
      if (nodes_[node].surface.fit_error_m > kNegligibleError * size_m_) {
        Split& made = splits[node - begin];
        made = look_ahead ? split_with_look_ahead(parts_[node], limits_m_[node])
                          : split_at_once(parts_[node]);
        worst_m = std::max(worst_m, settle(made.cells));
      }
    }
    for (std::size_t node = begin; node < end; ++node) {
      add_children(node, splits[node - begin], worst_m);
    }
    if (nodes_.size() == end) {
      return false;
    }
    starts_.push_back(static_cast<std::int32_t>(end));
    return true;
  }

  /// The worst node decides how far a level reaches beyond the solid; the others use that to leave
  /// as little volume outside as they can.
  void add_children(std::size_t node, Split& split, double worst_m) {
    nodes_[node].child_count = static_cast<std::int32_t>(split.cells.size());
    if (split.cells.empty()) {
      return;
    }
    nodes_[node].first_child = static_cast<std::int32_t>(nodes_.size());
    for (SpherePart& child : split.cells) {
      grow(child, split.outside, worst_m);
      parts_.push_back(std::move(child.part));
      add_node(child.sphere, split.next_stand_off_m);
    }
  }

  [[nodiscard]] Material material_of(const SurfacePart& part, std::size_t count) const {
    const SurfaceDistance& surface = description_.distance();
    std::vector<Vector3> points;
    std::vector<InnerPoint> candidates;
    for (const SurfaceSample& sample : samples_and_corners_of(part, count)) {
      points.push_back(sample.point);
      candidates.push_back(medial_ball(surface, sample, size_m_));
    }
    return {points, candidates, OutsidePoints(surface, points, kOutside)};
  }

  /// The one sphere round everything.
  [[nodiscard]] Sphere bound(const SurfacePart& part) const {
    const SurfaceDistance& surface = description_.distance();
    const Material given = material_of(part, kPoints.back());
    const SphereCover cover =
        cover_points(surface, given.outside, given.points, given.candidates, 1);
    SpherePart whole{spheres_of(cover).front(), part};
    const std::vector<Vector3> corners = corners_of(part);
    const InnerPoint& start = cover.centres.front();
    grow(whole, given.outside, kSlackOfTheRoot * stand_off_m(start, corners));
    return whole.sphere;
  }

  [[nodiscard]] Split split_at_once(const SurfacePart& part) const {
    const Material given = material_of(part, kPointsAtTheEnd);
    const SphereCover cover =
        cover_points_quickly(description_.distance(), given.points, given.candidates, most());
    return {shared_out(part, spheres_of(cover)), 0.0, given.outside};
  }

  /// As split_at_once(), with an eye to the level after. Which local optimum a cover ends in is
  /// chance, so several are tried.
  [[nodiscard]] Split split_with_look_ahead(const SurfacePart& part, double limit_m) const {
    Split best;
    BalancedCover best_cover;
    for (const std::size_t count : kPoints) {
      const Material given = material_of(part, count);
      const BalancedCover cover = balanced_cover(description_.distance(), given.outside,
                                                 given.points, given.candidates, most(), limit_m);
      const double at_least_m = std::max(limit_m, cover.stand_off_m);
      if (best_cover.spheres.empty() || cover.cost(at_least_m) < best_cover.cost(at_least_m)) {
        best = {shared_out(part, cover.spheres), cover.next_stand_off_m, given.outside};
        best_cover = cover;
      }
    }
    return best;
  }

  /// Moves each sphere to where it reaches least beyond the solid. Returns
  /// the greatest stand-off.
  double settle(std::vector<SpherePart>& cells) const {
    const SurfaceDistance& surface = description_.distance();
    double worst_m = 0.0;
    for (SpherePart& cell : cells) {
      const Vector3& start = cell.sphere.centre;
      const std::vector<Vector3> corners = corners_of(cell.part);
      const InnerPoint centre = best_centre(surface, corners, inner_point(surface, start));
      const double needed_m = stand_off_m(centre, corners);
      cell.sphere = {centre.point, centre.depth_m + needed_m};
      worst_m = std::max(worst_m, needed_m);
    }
    return worst_m;
  }

  /// Moves a sphere to where least of it lies outside, and grows it until it holds its part.
  void grow(SpherePart& cell, const OutsidePoints& outside, double limit_m) const {
    const SurfaceDistance& surface = description_.distance();
    const std::vector<Vector3> corners = corners_of(cell.part);
    const Vector3& start = cell.sphere.centre;
    const InnerPoint centre =
        leanest_centre(surface, outside, corners, inner_point(surface, start), limit_m);
    cell.sphere = {centre.point,
                   centre.depth_m + stand_off_m(centre, corners) + kSphereMargin * size_m_};
  }

  [[nodiscard]] std::size_t most() const { return static_cast<std::size_t>(settings_.branching); }

  TreeSettings settings_;
  const Progress& progress_;
  NodeDescription description_;
  double size_m_{0.0};
  std::vector<VolumeNode> nodes_;
  std::vector<double> limits_m_;  ///< by node: the stand-off its children should keep to
  std::vector<SurfacePart> parts_;
  std::vector<std::int32_t> starts_{0};
};

}  // namespace

BuiltTree medial_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress) {
  require_buildable(solid, settings);
  return MedialBuilder(solid, settings, progress).build();
}

}  // namespace impetus::inline trees
