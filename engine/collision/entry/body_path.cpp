// SPDX-License-Identifier: MIT
#include "engine/collision/entry/body_path.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline collision {
namespace {

bool moves_between(const BodyPath& path, double begin, double end) {
  return path.begin <= begin && end <= path.stop;
}

Vector3 velocity_of(const BodyPath& path) {
  return (path.end.position - path.start.position) / (path.stop - path.begin);
}

/// Of the whole way, as if it were all turned at the fastest (radians).
double fastest_turn(const BodyPath& path) {
  const Quaternion turn = path.start.orientation.conjugate() * path.end.orientation;
  const double sine = turn.vec().norm();
  return sine > 0.0 ? 4.0 * sine / (1.0 + std::abs(turn.w())) : 0.0;
}

double turning_of(const BodyPath& path) { return fastest_turn(path) / (path.stop - path.begin); }

/// Of a point on its arc, by its turning and by how that changes: for x = tan(Θ/4), 16 x² + 16 x³.
double bend_of(const BodyPath& path, double turning) {
  return turning * turning * (1.0 + 0.25 * turning * (path.stop - path.begin));
}

}  // namespace

Pose pose_at(const BodyPath& path, double time) {
  if (time >= path.stop) {
    return path.end;
  }
  if (time <= path.begin) {
    return path.start;
  }
  const double share = (time - path.begin) / (path.stop - path.begin);
  const Quaternion& from = path.start.orientation;
  const Quaternion& to = path.end.orientation;
  const double side = from.dot(to) < 0.0 ? -share : share;
  const Quaternion turned(Eigen::Vector4d((1.0 - share) * from.coeffs() + side * to.coeffs()));
  return {path.start.position + share * (path.end.position - path.start.position),
          turned.normalized()};
}

Vector3 turning_at(const BodyPath& path, double time) {
  const double length = path.stop - path.begin;
  const double share = std::clamp((time - path.begin) / length, 0.0, 1.0);
  const Quaternion turn = path.end.orientation * path.start.orientation.conjugate();
  const double side = turn.w() < 0.0 ? -2.0 : 2.0;
  const double slower = 1.0 - 2.0 * share * (1.0 - share) * (1.0 - std::abs(turn.w()));
  return side / (slower * length) * turn.vec();
}

bool reach_holds(const Pose& pose, double reach_m) {
  constexpr double kFar = 1e5;
  constexpr double kStretch = 1e-11;
  return pose.position.allFinite() && pose.position.cwiseAbs().maxCoeff() <= kFar * reach_m &&
         std::abs(pose.orientation.squaredNorm() - 1.0) <= kStretch;
}

double farthest_m(const BodyPath& path, double reach_m) {
  return (path.end.position - path.start.position).norm() + fastest_turn(path) * reach_m;
}

Stretches stretches_of(const BodyPath& a, const BodyPath& b) {
  std::array<double, 4> times{a.begin, a.stop, b.begin, b.stop};
  std::sort(times.begin(), times.end());
  Stretches stretches;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    RelativeStretch stretch;
    stretch.begin = times[i];
    stretch.end = times[i + 1];
    const bool a_moves = moves_between(a, stretch.begin, stretch.end);
    const bool b_moves = moves_between(b, stretch.begin, stretch.end);
    if (!(stretch.begin < stretch.end) || (!a_moves && !b_moves)) {
      continue;
    }
    if (a_moves) {
      stretch.velocity += velocity_of(a);
      stretch.turn_a = turning_of(a);
      stretch.bend_a = bend_of(a, stretch.turn_a);
    }
    if (b_moves) {
      stretch.velocity -= velocity_of(b);
      stretch.turn_b = turning_of(b);
      stretch.bend_b = bend_of(b, stretch.turn_b);
    }
    stretches.add(stretch);
  }
  return stretches;
}

double way_from(double from, const Stretches& stretches, double reach_a_m, double reach_b_m) {
  double way_m = 0.0;
  for (const RelativeStretch& stretch : stretches) {
    const double share = stretch.end - std::max(from, stretch.begin);
    if (share > 0.0) {
      way_m += share * stretch.fastest(reach_a_m, reach_b_m);
    }
  }
  return way_m;
}

}  // namespace impetus::inline collision
