// SPDX-License-Identifier: MIT
#include "experiments/scenes/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/numerics/random_stream.hpp"

namespace impetus {
namespace {

double symmetric(RandomStream& stream) { return 2.0 * stream.uniform() - 1.0; }

/// Uniform over the unit sphere, by rejection: no trigonometry.
Vector3 direction(RandomStream& stream) {
  while (true) {
    const double x = symmetric(stream);
    const double y = symmetric(stream);
    const Vector3 point(x, y, symmetric(stream));
    const double square = point.squaredNorm();
    if (square > 1e-4 && square <= 1.0) {
      return point / std::sqrt(square);
    }
  }
}

/// Uniform over rotations: a unit quaternion by rejection.
Quaternion orientation(RandomStream& stream) {
  while (true) {
    const double w = symmetric(stream);
    const double x = symmetric(stream);
    const double y = symmetric(stream);
    const double z = symmetric(stream);
    const double square = w * w + x * x + y * y + z * z;
    if (square > 1e-4 && square <= 1.0) {
      const double scale = 1.0 / std::sqrt(square);
      return Quaternion(scale * w, scale * x, scale * y, scale * z);
    }
  }
}

/// Where the middles of balls may be that are within the walls: a box about `centre`, or less.
struct Room {
  Vector3 centre{Vector3::Zero()};
  Vector3 half_extents_m{Vector3::Zero()};
  const Enclosure* walls{nullptr};  ///< null: all of the box is within
};

Room room_within(const Enclosure& enclosure, double radius_m) {
  if (const auto* cube = std::get_if<ClosedCube>(&enclosure)) {
    return {Vector3::Zero(), Vector3::Constant(cube->half_edge_m - radius_m), nullptr};
  }
  constexpr int kCorners = 8;
  Eigen::AlignedBox3d box;
  for (int index = 0; index < kCorners; ++index) {
    box.extend(corner(enclosure, index));
  }
  return {box.center(), 0.5 * box.sizes(), &enclosure};
}

/// A place where a ball is within the walls and apart from the bodies that have theirs.
std::optional<Vector3> free_place(const std::vector<BodyState>& placed, const Room& room,
                                  double radius_m, RandomStream& stream) {
  constexpr int kMostDraws = 10'000;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const double x = symmetric(stream);
    const double y = symmetric(stream);
    const Vector3 share(x, y, symmetric(stream));
    const Vector3 place = room.centre + room.half_extents_m.cwiseProduct(share);
    if (room.walls != nullptr && reaches_wall(*room.walls, Sphere{place, radius_m})) {
      continue;
    }
    const bool apart = std::all_of(placed.begin(), placed.end(), [&](const BodyState& other) {
      return (other.pose.position - place).squaredNorm() > 4.0 * radius_m * radius_m;
    });
    if (apart) {
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<BodyState>> crowd_states(const std::vector<BodyModel>& models,
                                                   const Enclosure& enclosure,
                                                   const CrowdStart& start) {
  RandomStream stream(start.seed, start.name);
  const Room room = room_within(enclosure, start.radius_m);
  if (room.half_extents_m.minCoeff() < 0.0) {
    return std::nullopt;
  }
  std::vector<BodyState> states;
  for (const BodyModel& model : models) {
    const auto place = free_place(states, room, start.radius_m, stream);
    if (!place) {
      return std::nullopt;
    }
    BodyState state;
    state.pose.position = *place;
    state.pose.orientation = orientation(stream);
    state.linear_momentum = start.speed_m_s / model.inverse_mass * direction(stream);
    const Vector3 spin = start.spin_rad_s * direction(stream);
    state.angular_momentum = angular_momentum_at(model, state.pose.orientation, spin);
    states.push_back(state);
  }
  return states;
}

}  // namespace impetus
