// SPDX-License-Identifier: MIT
#include "experiments/trade/trial_starts.hpp"

#include <utility>

#include "engine/numerics/random_stream.hpp"
#include "engine/numerics/trigonometry.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus {
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
    const Vector3 point(x, y, z);
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

}  // namespace

StagedScene TrialStarts::staged(const std::string& kind, std::int64_t number) const {
  json scene = scene_;
  if (!kind.empty()) {
    scene["engine"]["tree"]["kind"] = kind;
  }
  if (!scene.contains("crowd") || kind.empty()) {
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
  if (!scene.contains("crowd") && number > 1) {
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
    if (model.inverse_mass > 0.0) {
      Pose& pose = states[body].pose;
      pose.position += 2.0 * kMostShift * model.tree->bounding_radius_m() * shift;
      pose.orientation = (small_turn(turn) * pose.orientation).normalized();
    }
  }
  world = World(world.models(), std::move(states), world.settings());
}

}  // namespace impetus
