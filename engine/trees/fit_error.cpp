// SPDX-License-Identifier: MIT
#include "engine/trees/fit_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "engine/volumes/rounded_box.hpp"

namespace impetus {
namespace {

/// Above rounding in a bound, as a share of the volume's size.
constexpr double kRounding = 1e-14;
constexpr int kMostAnchors = 4;

/// A ball in the solid, or a point of it.
struct Anchor {
  Vector3 centre;
  double radius_m;
};

/// Dimensions of a cell, each a range: 0 to 2 of the core, 3 of the radius, 4 to 6 of the direction
/// before it is made unit. Those that are one value are not split.
using Range = std::array<double, 2>;
constexpr std::size_t kRadius = 3;
constexpr std::size_t kDirection = 4;

struct Cell {
  std::array<Range, 7> ranges;
  double bound_m;
  std::array<Anchor, kMostAnchors> anchors;
  int anchor_count;
  int rank;  ///< order of making: breaks ties
};

struct Looser {
  bool operator()(const Cell& a, const Cell& b) const {
    return std::pair(a.bound_m, -a.rank) < std::pair(b.bound_m, -b.rank);
  }
};

Vector3 corner_of(const Cell& cell, std::size_t first, unsigned which) {
  return {cell.ranges[first][which & 1U], cell.ranges[first + 1][(which >> 1U) & 1U],
          cell.ranges[first + 2][(which >> 2U) & 1U]};
}

Vector3 middle_of(const Cell& cell, std::size_t first) {
  return {0.5 * (cell.ranges[first][0] + cell.ranges[first][1]),
          0.5 * (cell.ranges[first + 1][0] + cell.ranges[first + 1][1]),
          0.5 * (cell.ranges[first + 2][0] + cell.ranges[first + 2][1])};
}

/// All directions within `cosine` of the unit vector `axis`; without directions, axis zero.
struct Cone {
  Vector3 axis{Vector3::Zero()};
  double cosine{1.0};

  /// The direction of the cone that runs farthest along `v`.
  [[nodiscard]] Vector3 farthest_along(const Vector3& v) const {
    const double along = v.dot(axis);
    const double length = v.norm();
    if (length == 0.0 || axis.isZero() || along >= cosine * length) {
      return length == 0.0 || axis.isZero() ? axis : Vector3(v / length);
    }
    const Vector3 across = v - along * axis;
    const double width = across.norm();
    if (width == 0.0) {  // straight against the axis: the rim is all the same
      return cosine * axis +
             std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) * Vector3(axis.unitOrthogonal());
    }
    return cosine * axis + (std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / width) * across;
  }
};

Cone cone_of(const Cell& cell) {
  const Vector3 middle = middle_of(cell, kDirection);
  if (middle.isZero()) {
    return {};
  }
  Cone cone{middle.normalized(), 1.0};
  for (unsigned which = 0; which < 8; ++which) {
    const Vector3 corner = corner_of(cell, kDirection, which).normalized();
    cone.cosine = std::min(cone.cosine, corner.dot(cone.axis));
  }
  return cone;
}

struct Farthest {
  Vector3 point{Vector3::Zero()};
  double distance_m{-std::numeric_limits<double>::infinity()};
};

/// The point of a cell (or, of its cone's rim, of the volume) farthest from the anchor.
Farthest farthest_from(const Anchor& anchor, const Cell& cell, const Cone& cone) {
  Farthest farthest;
  for (unsigned which = 0; which < 8; ++which) {
    const Vector3 core = corner_of(cell, 0, which);
    const Vector3 direction = cone.farthest_along(core - anchor.centre);
    for (const double radius_m : cell.ranges[kRadius]) {
      const Vector3 point = core + radius_m * direction;
      const double distance_m = (point - anchor.centre).norm() - anchor.radius_m;
      if (distance_m > farthest.distance_m) {
        farthest = {point, distance_m};
      }
    }
  }
  return farthest;
}

class Search {
 public:
  Search(const RoundedBox& volume, const SurfaceDistance& solid, double indifferent_m,
         int most_questions)
      : volume_(volume),
        solid_(solid),
        indifferent_m_(indifferent_m),
        questions_left_(most_questions),
        size_m_(volume.half_extents_m.norm() + volume.radius_m) {}

  double upper_bound_m() {
    const double signed_m = ask(Vector3::Zero());
    if (size_m_ + signed_m <= indifferent_m_) {
      return std::max(0.0, size_m_ + signed_m);
    }
    add_first_cells(anchors_about(Vector3::Zero(), signed_m));
    while (!open_.empty() && questions_left_ > 0 && open_.top().bound_m > enough_m()) {
      Cell worst = open_.top();
      open_.pop();
      sharpen(worst);
      if (worst.bound_m > enough_m()) {
        split(worst);
      } else {
        settled_m_ = std::max(settled_m_, worst.bound_m);
      }
    }
    const double bound_m = open_.empty() ? settled_m_ : std::max(settled_m_, open_.top().bound_m);
    return bound_m > 0.0 ? bound_m + kRounding * size_m_ : 0.0;
  }

 private:
  [[nodiscard]] double enough_m() const {
    return std::max(
        {indifferent_m_, found_m_ * (1.0 + kFitTolerance), found_m_ + kFitResolution * size_m_});
  }

  double ask(const Vector3& local) {
    --questions_left_;
    const double signed_m = solid_.signed_distance_m(volume_.placed(local));
    found_m_ = std::max(found_m_, signed_m);
    return signed_m;
  }

  /// Balls of the solid near a point, whose signed distance is known.
  std::vector<Anchor> anchors_about(const Vector3& local, double signed_m) {
    if (signed_m <= 0.0) {
      return {{local, -signed_m}};
    }
    const Vector3 nearest = volume_.local(solid_.nearest(volume_.placed(local)).point);
    // Behind the surface lies a ball of the solid that bounds more of what lies before it.
    std::vector<Anchor> anchors{{nearest, 0.0}};
    const Vector3 behind = nearest + (0.5 * size_m_ / signed_m) * (nearest - local);
    const double behind_m = ask(behind);
    if (behind_m < 0.0) {
      anchors.push_back({behind, -behind_m});
    }
    return anchors;
  }

  void bound(Cell& cell, const std::vector<Anchor>& fresh, Farthest* where = nullptr) {
    const Cone cone = cone_of(cell);
    Farthest nearest{Vector3::Zero(), std::numeric_limits<double>::infinity()};
    const auto consider = [&](const Anchor& anchor) {
      const Farthest farthest = farthest_from(anchor, cell, cone);
      nearest = farthest.distance_m < nearest.distance_m ? farthest : nearest;
    };
    for (int i = 0; i < cell.anchor_count; ++i) {
      consider(cell.anchors[static_cast<std::size_t>(i)]);
    }
    for (const Anchor& anchor : fresh) {
      consider(anchor);
      const int last = std::min(cell.anchor_count, kMostAnchors - 1);
      for (int i = last; i > 0; --i) {
        cell.anchors[static_cast<std::size_t>(i)] = cell.anchors[static_cast<std::size_t>(i) - 1];
      }
      cell.anchors[0] = anchor;
      cell.anchor_count = last + 1;
    }
    cell.bound_m = std::min(cell.bound_m, nearest.distance_m);
    if (where != nullptr) {
      *where = nearest;
    }
  }

  /// Asks about the cell's middle, and about the point that its bound comes from.
  void sharpen(Cell& cell) {
    const Vector3 core = middle_of(cell, 0);
    const Cone cone = cone_of(cell);
    const Vector3 middle = core + cell.ranges[kRadius][1] * cone.axis;
    Farthest where;
    bound(cell, anchors_about(middle, ask(middle)), &where);
    if (cell.bound_m > enough_m() && where.distance_m < std::numeric_limits<double>::infinity()) {
      bound(cell, anchors_about(where.point, ask(where.point)));
    }
  }

  /// Halves the range along which the bound grows most.
  void split(const Cell& cell) {
    std::size_t dimension = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cell.ranges.size(); ++i) {
      const auto [low, high] = cell.ranges[i];
      if (low == high) {
        continue;
      }
      Cell flat = cell;
      flat.bound_m = std::numeric_limits<double>::infinity();
      flat.ranges[i] =
          i == kRadius ? Range{high, high} : Range{0.5 * (low + high), 0.5 * (low + high)};
      bound(flat, {});
      if (flat.bound_m < least_m) {
        least_m = flat.bound_m;
        dimension = i;
      }
    }
    if (least_m == std::numeric_limits<double>::infinity()) {  // a point: nothing is left to split
      settled_m_ = std::max(settled_m_, cell.bound_m);
      return;
    }
    const auto [low, high] = cell.ranges[dimension];
    for (const Range range : {Range{low, 0.5 * (low + high)}, Range{0.5 * (low + high), high}}) {
      Cell half = cell;
      half.ranges[dimension] = range;
      add(half);
    }
  }

  void add(Cell cell) {
    bound(cell, {});
    cell.rank = made_++;
    if (cell.bound_m > 0.0) {
      open_.push(cell);
    }
  }

  /// The volume is the union, over signs in {−, 0, +} of the three axes, of the core's face of
  /// these signs swept along directions of these signs. An axis without extent has both signs.
  void add_first_cells(const std::vector<Anchor>& anchors) {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          add_sector({x, y, z}, anchors);
        }
      }
    }
  }

  void add_sector(const std::array<int, 3>& signs, const std::vector<Anchor>& anchors) {
    const double infinity = std::numeric_limits<double>::infinity();
    Cell cell{{}, infinity, {}, 0, 0};
    for (const Anchor& anchor : anchors) {
      cell.anchors[static_cast<std::size_t>(cell.anchor_count++)] = anchor;
    }
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double half = volume_.half_extents_m[static_cast<Eigen::Index>(axis)];
      const int sign = signs[axis];
      if ((sign != 0 && half == 0.0) || (sign != 0 && volume_.radius_m == 0.0)) {
        return;  // the sector of sign 0 has it
      }
      cell.ranges[axis] = sign == 0 ? Range{-half, half} : Range{sign * half, sign * half};
      const bool free = volume_.radius_m > 0.0 && half == 0.0;
      cell.ranges[kDirection + axis] = free        ? Range{-1.0, 1.0}
                                       : sign == 0 ? Range{0.0, 0.0}
                                       : sign > 0  ? Range{0.0, 1.0}
                                                   : Range{-1.0, 0.0};
      any = any || free || sign != 0;
    }
    cell.ranges[kRadius] = {0.0, volume_.radius_m};
    if (!any) {
      cell.ranges[kRadius] = {0.0, 0.0};
      add(cell);
      return;
    }
    add_faces(cell);
  }

  /// Directions through the faces of the cube of their ranges that lie away from the origin.
  void add_faces(const Cell& cell) {
    for (std::size_t i = kDirection; i < cell.ranges.size(); ++i) {
      for (const std::size_t end : {0U, 1U}) {
        if (cell.ranges[i][end] != 0.0) {
          Cell face = cell;
          face.ranges[i] = {cell.ranges[i][end], cell.ranges[i][end]};
          add(face);
        }
      }
    }
  }

  const RoundedBox& volume_;
  const SurfaceDistance& solid_;
  double indifferent_m_;
  int questions_left_;
  double size_m_;
  double found_m_{0.0};    ///< the greatest distance found outside
  double settled_m_{0.0};  ///< the greatest bound of cells that are done with
  int made_{0};
  std::priority_queue<Cell, std::vector<Cell>, Looser> open_;
};

}  // namespace

double fit_error_m(const Volume& volume, const SurfaceDistance& solid, double indifferent_m,
                   int most_questions) {
  const RoundedBox form = rounded_box(volume);
  return Search(form, solid, indifferent_m, most_questions).upper_bound_m();
}

}  // namespace impetus
