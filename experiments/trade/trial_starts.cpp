// SPDX-License-Identifier: MIT
#include "experiments/trade/trial_starts.hpp"

#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline trade {
namespace {

using nlohmann::json;

constexpr double kMostTurn_rad = 5.0 / 180.0 * 3.14159265358979323846;
constexpr double kMostShift = 0.05;  // of the diameter of the bounding sphere

double between_minus_one_and_one(RandomStream& random) { return 2.0 * random.uniform() - 1.0; }

/// Uniform in the unit ball.
Vector3 in_unit_ball(RandomStream& random) {
  while (true) {
    const double x = between_minus_one_and_one(random);
    const double y = between_minus_one_and_one(random);
    const double z = between_minus_one_and_one(random);
    Vector3 point(x, y, z);
    if (point.squaredNorm() <= 1.0) {
      return point;
    }
  }
}

/// About the direction of `vector`, by its length of the greatest turn; to second order, which is
/// as good as exact for so small a turn.
Quaternion small_turn(const Vector3& vector) {
  const Vector3 half = 0.5 * kMostTurn_rad * vector;
  return Quaternion(1.0, half.x(), half.y(), half.z()).normalized();
}

/// Turned about its root and moved as a whole: its hinges stay together.
void jitter_figure(const Figure& figure, const Vector3& shift_m, const Quaternion& turn,
                   std::vector<BodyState>& states) {
  const auto first = static_cast<std::size_t>(figure.first_part);
  const Vector3 root = states[first].pose.position;
  for (std::size_t part = first; figure.has_part(static_cast<std::int32_t>(part)); ++part) {
    BodyState& state = states[part];
    state.pose.position = root + shift_m + turn * (state.pose.position - root);
    state.pose.orientation = (turn * state.pose.orientation).normalized();
    state.linear_momentum = turn * state.linear_momentum;
    state.angular_momentum = turn * state.angular_momentum;
  }
}

/// The figure of which the body is a part, null when of none.
const Figure* figure_with(const World& world, std::size_t body) {
  for (const Figure& figure : world.settings().figures) {
    if (figure.has_part(static_cast<std::int32_t>(body))) {
      return &figure;
    }
  }
  return nullptr;
}

bool has_crowd(const json& scene) {
  return scene.contains("crowd") || scene.contains("figure_crowd");
}

}  // namespace

StagedScene TrialStarts::staged(const std::string& kind, std::int64_t number) const {
  json scene = scene_;
  if (!kind.empty()) {
    scene["engine"]["tree"]["kind"] = kind;
  }
  if (!has_crowd(scene) || kind.empty()) {
    return as_drawn(scene, number);
  }
  StagedScene staged = as_drawn(scene_, number);
  staged.world =
      World(bodies_of(scene, metres_per_degree(screen_.viewing_distance_m), library_).models,
            staged.world.states(), staged.world.settings());
  return staged;
}

StagedScene TrialStarts::as_drawn(const json& scene, std::int64_t number) const {
  StagedScene staged =
      build_scene(scene, screen_, 0.0, library_, "trade/" + std::to_string(number), seed_);
  if (!has_crowd(scene) && number > 1) {
    jitter(staged.world, number);
  }
  return staged;
}

void TrialStarts::jitter(World& world, std::int64_t number) const {
  RandomStream random(seed_, "start " + std::to_string(number));
  std::vector<BodyState> states = world.states();
  for (std::size_t body = 0; body < states.size(); ++body) {
    const BodyModel& model = world.models()[body];
    const Vector3 shift = in_unit_ball(random);
    const Vector3 turn = in_unit_ball(random);
    const Vector3 shift_m = 2.0 * kMostShift * model.tree->bounding_radius_m() * shift;
    if (const Figure* figure = figure_with(world, body)) {
      if (body == static_cast<std::size_t>(figure->first_part)) {
        jitter_figure(*figure, shift_m, small_turn(turn), states);
      }
    } else if (model.inverse_mass > 0.0) {
      Pose& pose = states[body].pose;
      pose.position += shift_m;
      pose.orientation = (small_turn(turn) * pose.orientation).normalized();
    }
  }
  world = World(world.models(), std::move(states), world.settings());
}

}  // namespace impetus::inline trade
