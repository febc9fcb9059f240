// SPDX-License-Identifier: MIT
#include "engine/trees/builders/medial_tree.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/trees/builders/balanced_cover.hpp"
#include "engine/trees/builders/power_cells.hpp"
#include "engine/trees/builders/surface_samples.hpp"
#include "engine/trees/node_description.hpp"
#include "engine/trees/solid_requirement.hpp"

namespace impetus::inline trees {
namespace {

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

class MedialBuilder {
 public:
  MedialBuilder(const TriangleMesh& solid, const TreeSettings& settings, const Progress& progress)
      : settings_(settings), progress_(progress), description_(solid) {
    const auto [least, most] = bounds_of(solid);
    size_m_ = (most - least).norm();
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
