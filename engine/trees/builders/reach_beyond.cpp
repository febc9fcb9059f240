// SPDX-License-Identifier: MIT
#include "engine/trees/builders/reach_beyond.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline trees {
namespace {

constexpr double kToleranceShare = 0.02;  ///< of the reach
constexpr double kResolution = 1e-3;      ///< of the volume's size

/// The parallelogram centre + s half_u + t half_v, |s|, |t| ≤ 1.
struct Patch {
  Vector3 centre;
  Vector3 half_u;
  Vector3 half_v;

  [[nodiscard]] double half_diagonal_m() const { return half_u.norm() + half_v.norm(); }
};

/// What is to be searched for the greatest signed distance, which `radius_m` is added to.
struct Searched {
  std::vector<Vector3> corners;
  std::vector<Patch> patches;
  double radius_m{0.0};
};

Searched searched_of(const Sphere& sphere) { return {{sphere.centre}, {}, sphere.radius_m}; }

Searched searched_of(const LineSwept& line) {
  return {{line.centre - line.half_axis, line.centre + line.half_axis},
          {{line.centre, line.half_axis, Vector3::Zero()}},
          line.radius_m};
}

Searched searched_of(const RectangleSwept& rectangle) {
  const auto& [centre, u, v, radius_m] = rectangle;
  return {
      {centre - u - v, centre + u - v, centre - u + v, centre + u + v}, {{centre, u, v}}, radius_m};
}

/// A box of half axes as columns.
Searched searched_of(const Vector3& centre, const Matrix3& half_axes) {
  Searched searched;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 signs(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    searched.corners.emplace_back(centre + half_axes * signs);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      searched.patches.push_back({centre + sign * half_axes.col(axis),
                                  half_axes.col((axis + 1) % 3), half_axes.col((axis + 2) % 3)});
    }
  }
  return searched;
}

Searched searched_of(const Box& box) {
  return searched_of(box.centre,
                     box.orientation.toRotationMatrix() * box.half_extents_m.asDiagonal());
}

Searched searched_of(const Cube& cube) {
  return searched_of(cube.centre, cube.half_edge_m * cube.orientation.toRotationMatrix());
}

}  // namespace

RoughDistance::RoughDistance(const SurfaceDistance& exact, const Bounds& bounds, int cells)
    : exact_(&exact), spacing_m_(bounds.sides().maxCoeff() / cells) {
  // Two cells more on each side.
  least_ = bounds.least - Vector3::Constant(2.0 * spacing_m_);
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<int>(bounds.sides()[axis] / spacing_m_) + 6;
  }
  known_m_.assign(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) *
                      static_cast<std::size_t>(counts_[2]),
                  std::numeric_limits<float>::quiet_NaN());
}

double RoughDistance::at(const Eigen::Vector3i& index) const {
  const auto place =
      static_cast<std::size_t>(index[0]) +
      static_cast<std::size_t>(counts_[0]) *
          (static_cast<std::size_t>(index[1]) +
           static_cast<std::size_t>(counts_[1]) * static_cast<std::size_t>(index[2]));
  float& known_m = known_m_[place];
  if (std::isnan(known_m)) {
    known_m =
        static_cast<float>(exact_->signed_distance_m(least_ + spacing_m_ * index.cast<double>()));
  }
  return known_m;
}

double RoughDistance::interpolated_m(const Vector3& point) const {
  const Vector3 place = (point - least_) / spacing_m_;
  Eigen::Vector3i index;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(place[axis] >= 0.0) || place[axis] >= counts_[axis] - 1) {
      return exact_->signed_distance_m(point);
    }
    index[axis] = static_cast<int>(place[axis]);
  }
  double sum_m = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i offset(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = place[axis] - index[axis];
      weight *= offset[axis] == 1 ? share : 1.0 - share;
    }
    sum_m += weight * at(index + offset);
  }
  return sum_m;
}

double reach_beyond_m(const Volume& volume, const DistanceToUse& solid,
                      const ReachSettings& settings) {
  Searched searched = std::visit([](const auto& kind) { return searched_of(kind); }, volume);
  double reach_m = 0.0;
  const auto reach_at = [&](const Vector3& point) {
    const double here_m = solid.signed_distance_m(point) + searched.radius_m;
    reach_m = std::max(reach_m, here_m);
    return here_m;
  };
  for (const Vector3& corner : searched.corners) {
    reach_at(corner);
    if (reach_m > settings.enough_m) {
      return reach_m;
    }
  }
  double size_m = searched.radius_m;
  for (const Patch& patch : searched.patches) {
    size_m = std::max(size_m, patch.half_diagonal_m());
  }
  std::vector<Patch>& queue = searched.patches;
  for (std::size_t i = 0; i < queue.size() && i < static_cast<std::size_t>(settings.most_questions);
       ++i) {
    const Patch patch = queue[i];
    const double bound_m = reach_at(patch.centre) + patch.half_diagonal_m();
    if (reach_m > settings.enough_m) {
      return reach_m;
    }
    if (bound_m > reach_m * (1.0 + kToleranceShare) + kResolution * size_m) {
      const bool along_u = patch.half_u.squaredNorm() >= patch.half_v.squaredNorm();
      const Vector3 half = 0.5 * (along_u ? patch.half_u : patch.half_v);
      const Vector3 u = along_u ? half : patch.half_u;
      const Vector3 v = along_u ? patch.half_v : half;
      queue.push_back({patch.centre - half, u, v});
      queue.push_back({patch.centre + half, u, v});
    }
  }
  return reach_m;
}

}  // namespace impetus::inline trees
