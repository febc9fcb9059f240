// SPDX-License-Identifier: MIT
#include "experiments/scenes/crowd.hpp"

#include <algorithm>

#include "experiments/scenes/random_places.hpp"

namespace impetus::inline scenes {
namespace {

/// A place where a ball is within the walls and apart from the bodies that have theirs.
std::optional<Vector3> free_place(const std::vector<BodyState>& placed, const Room& room,
                                  double radius_m, RandomStream& stream) {
  constexpr int kMostDraws = 10'000;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Vector3 place = draw_place(room, stream);
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
    state.pose.orientation = draw_orientation(stream);
    state.linear_momentum = start.speed_m_s / model.inverse_mass * draw_direction(stream);
    const Vector3 spin = start.spin_rad_s * draw_direction(stream);
    state.angular_momentum = angular_momentum_at(model, state.pose.orientation, spin);
    states.push_back(state);
  }
  return states;
}

}  // namespace impetus::inline scenes
