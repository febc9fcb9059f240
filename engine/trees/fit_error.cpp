// SPDX-License-Identifier: MIT
#include "engine/trees/fit_error.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "engine/shapes/triangle_distance.hpp"
#include "engine/trees/fit_cell.hpp"
#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline trees {
namespace {

/// Shares of the volume's size: above rounding in a bound, and above what builders add to nodes.
constexpr double kRounding = 1e-14;
constexpr double kSkin = 1e-9;
/// Volumes that these do not settle are worth a box inside the solid, unless the surface about them
/// has so many triangles that its faces are small beside the volume.
constexpr int kEasyQuestions = 60;
/// Half the side of a cube in a ball, over its radius: below 1/√3.
constexpr double kInnerCube = 0.57;
constexpr std::size_t kMostTrianglesForBox = 2'000;

/// The greatest bound first; of equals the cell that was made first.
struct Looser {
  bool operator()(const FitCell& a, const FitCell& b) const {
    return std::pair(a.bound_m, -a.rank) < std::pair(b.bound_m, -b.rank);
  }
};

/// The branch and bound over the cells of one volume.
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
    const int easy = questions_left_ - kEasyQuestions;
    bool boxed = false;
    while (!open_.empty() && questions_left_ > 0 && open_.top().bound_m > enough_m()) {
      if (!boxed && questions_left_ < easy) {
        boxed = true;
        bound_by_inner_box();
        continue;
      }
      FitCell worst = open_.top();
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

  /// Bounds come from points that may lie beside the volume; only its own show how far it reaches.
  double ask(const Vector3& local) {
    --questions_left_;
    const double signed_m = solid_.signed_distance_m(volume_.placed(local));
    const Vector3 beyond = (local.cwiseAbs() - volume_.half_extents_m).cwiseMax(0.0);
    if (beyond.squaredNorm() <= volume_.radius_m * volume_.radius_m) {
      found_m_ = std::max(found_m_, signed_m);
    }
    return signed_m;
  }

  /// Of balls whose inner cubes lie where the surface is known, the largest is kept.
  void note(const Anchor& ball) {
    const Vector3 reach = volume_.reach_m() - Vector3::Constant(kInnerCube * ball.radius_m);
    if ((ball.core[0].cwiseAbs().array() <= reach.array()).all() &&
        ball.radius_m > largest_ball_.radius_m) {
      largest_ball_ = ball;
    }
  }

  /// Balls of the solid near a point, whose signed distance is known.
  std::vector<Anchor> anchors_about(const Vector3& local, double signed_m) {
    if (signed_m <= 0.0) {
      const Anchor ball = ball_about(local, -signed_m);
      note(ball);
      return {ball};
    }
    const NearestOnSurface found = solid_.nearest(volume_.placed(local));
    const Vector3 nearest = volume_.local(found.point);
    Triangle triangle = solid_.corners(found.triangle);
    for (Vector3& corner : triangle) {
      corner = volume_.local(corner);
    }
    // Behind the surface lies a ball of the solid that bounds more of what lies before it.
    std::vector<Anchor> anchors{{Anchor::Kind::kTriangle, triangle, 0.0}};
    const Vector3 behind = nearest + (0.5 * size_m_ / signed_m) * (nearest - local);
    const double behind_m = ask(behind);
    if (behind_m < 0.0) {
      anchors.push_back(ball_about(behind, -behind_m));
      note(anchors.back());
    }
    return anchors;
  }

  void bound(FitCell& cell, const std::vector<Anchor>& fresh, Farthest* where = nullptr) {
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
      cell.remember(anchor);
    }
    cell.bound_m = std::min(cell.bound_m, nearest.distance_m);
    if (where != nullptr) {
      *where = nearest;
    }
  }

  /// Asks about the cell's middle, and about the point that its bound comes from.
  void sharpen(FitCell& cell) {
    const Vector3 core = cell.middle(0);
    const Cone cone = cone_of(cell);
    const Vector3 middle = core + cell.ranges[FitCell::kRadius][1] * cone.axis;
    const double signed_m = ask(middle);
    if (signed_m < 0.0 && lies_inside(cell, cone)) {
      cell.bound_m = kSkin * size_m_;
      return;
    }
    Farthest where;
    bound(cell, anchors_about(middle, signed_m), &where);
    if (cell.bound_m > enough_m() && where.distance_m < std::numeric_limits<double>::infinity()) {
      bound(cell, anchors_about(where.point, ask(where.point)));
    }
  }

  /// Whether a cell that is a box, of which a point lies inside, lies in the solid but for a skin:
  /// no triangle reaches into it.
  bool lies_inside(const FitCell& cell, const Cone& cone) {
    if (cone.cosine < 1.0) {
      return false;
    }
    const Vector3 far = cell.ranges[FitCell::kRadius][1] * cone.axis;
    const Vector3 near = cell.ranges[FitCell::kRadius][0] * cone.axis;
    const Vector3 first = cell.corner(0, 0) + near.cwiseMin(far);
    const Vector3 last = cell.corner(0, 7) + near.cwiseMax(far);
    return is_clear(first, last);
  }

  /// Whether no triangle reaches into the box between two corners, but for a skin.
  bool is_clear(const Vector3& first, const Vector3& last) {
    if (!surface_known_) {
      surface_known_ = true;
      surface_ = solid_.triangles_near(volume_.centre, volume_.reach_m().norm());
      for (Triangle& triangle : surface_) {
        for (Vector3& corner : triangle) {
          corner = volume_.local(corner);
        }
      }
    }
    const Vector3 centre = 0.5 * (first + last);
    const Vector3 skin = Vector3::Constant(0.5 * kSkin * size_m_);
    const Vector3 half = (0.5 * (last - first) - skin).cwiseMax(0.0);
    return std::none_of(surface_.begin(), surface_.end(), [&](const Triangle& triangle) {
      return meets_box({triangle[0] - centre, triangle[1] - centre, triangle[2] - centre}, half);
    });
  }

  /// From the cube in the largest ball known inside, each face is moved out as far as the surface
  /// and the volume's reach allow: solids with flat faces fill most of their nodes so.
  void bound_by_inner_box() {
    if (largest_ball_.radius_m <= 0.0 || !is_clear(largest_ball_.core[0], largest_ball_.core[0]) ||
        surface_.size() > kMostTrianglesForBox) {
      return;
    }
    const Vector3 half = Vector3::Constant(kInnerCube * largest_ball_.radius_m);
    const Vector3 reach = volume_.reach_m();
    std::array<Vector3, 2> corners{largest_ball_.core[0] - half, largest_ball_.core[0] + half};
    for (std::size_t side = 0; side < 2; ++side) {
      for (int axis = 0; axis < 3; ++axis) {
        const double limit = side == 0 ? -reach[axis] : reach[axis];
        push_out(corners, side, axis, limit);
      }
    }
    // The skin that was not looked at is given back.
    const Vector3 skin = Vector3::Constant(0.5 * kSkin * size_m_);
    const Anchor box{Anchor::Kind::kBox, {corners[0] + skin, corners[1] - skin, corners[0]}, 0.0};
    std::priority_queue<FitCell, std::vector<FitCell>, Looser> open;
    std::swap(open, open_);
    for (; !open.empty(); open.pop()) {
      FitCell cell = open.top();
      bound(cell, {box});
      open_.push(cell);
    }
  }

  /// Moves one face of a clear box towards the limit while it stays clear.
  void push_out(std::array<Vector3, 2>& corners, std::size_t side, int axis, double limit) {
    double clear = corners[side][axis];
    if ((side == 0) != (limit < clear)) {
      return;  // beyond the volume already
    }
    double beyond = limit;
    for (int step = 0; step < 30; ++step) {
      std::array<Vector3, 2> tried = corners;
      tried[side][axis] = step == 0 ? limit : 0.5 * (clear + beyond);
      const bool is = is_clear(tried[0], tried[1]);
      (is ? clear : beyond) = tried[side][axis];
      if (clear == limit) {
        break;
      }
    }
    corners[side][axis] = clear;
  }

  /// Halves the range along which the bound grows most.
  void split(const FitCell& cell) {
    std::size_t dimension = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cell.ranges.size(); ++i) {
      const auto [low, high] = cell.ranges[i];
      if (low == high) {
        continue;
      }
      FitCell flat = cell;
      flat.bound_m = std::numeric_limits<double>::infinity();
      flat.ranges[i] =
          i == FitCell::kRadius ? Range{high, high} : Range{0.5 * (low + high), 0.5 * (low + high)};
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
      FitCell half = cell;
      half.ranges[dimension] = range;
      add(half);
    }
  }

  void add(FitCell cell) {
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
    FitCell cell{{}, infinity, {}, 0, 0};
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
      cell.ranges[FitCell::kDirection + axis] = free        ? Range{-1.0, 1.0}
                                                : sign == 0 ? Range{0.0, 0.0}
                                                : sign > 0  ? Range{0.0, 1.0}
                                                            : Range{-1.0, 0.0};
      any = any || free || sign != 0;
    }
    cell.ranges[FitCell::kRadius] = {0.0, volume_.radius_m};
    if (!any) {
      cell.ranges[FitCell::kRadius] = {0.0, 0.0};
      add(cell);
      return;
    }
    add_faces(cell);
  }

  /// Directions through the faces of the cube of their ranges that lie away from the origin.
  void add_faces(const FitCell& cell) {
    for (std::size_t i = FitCell::kDirection; i < cell.ranges.size(); ++i) {
      for (const std::size_t end : {0U, 1U}) {
        if (cell.ranges[i][end] != 0.0) {
          FitCell face = cell;
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
  Anchor largest_ball_{};
  bool surface_known_{false};
  std::vector<Triangle> surface_;  ///< all that comes within the volume's reach
  std::priority_queue<FitCell, std::vector<FitCell>, Looser> open_;
};

}  // namespace

double fit_error_m(const Volume& volume, const SurfaceDistance& solid, double indifferent_m,
                   int most_questions) {
  const RoundedBox form = rounded_box(volume);
  return Search(form, solid, indifferent_m, most_questions).upper_bound_m();
}

}  // namespace impetus::inline trees
