// SPDX-License-Identifier: MIT
#include "experiments/run/touching.hpp"

#include <algorithm>

#include "experiments/run/frame_poses.hpp"

namespace impetus::inline run {

StagedScene scene_at_onset(const StagedScene& scene) {
  StagedScene anew = scene;
  anew.world = World(scene.world.models(), scene.start, scene.world.settings());
  return anew;
}

bool touch_by_the_end(const StagedScene& scene, const NamedPair& names) {
  const std::int64_t last = steps_until(scene.whole_s(), scene.step_hz);
  const std::vector<BodyModel>& models = scene.world.models();
  const auto name_of = [&](std::int32_t body) {
    return is_wall(body) ? std::string() : models[static_cast<std::size_t>(body)].name;
  };
  const auto are_the_two = [&](const CollisionReport& collision) {
    const NamedPair touching{name_of(collision.bodies.a), name_of(collision.bodies.b)};
    return touching == names || touching == NamedPair{names[1], names[0]};
  };
  SceneRun run(scene_at_onset(scene));
  while (run.number() < last) {
    const std::vector<CollisionReport>& collisions = run.step_whole().collisions;
    if (std::any_of(collisions.begin(), collisions.end(), are_the_two)) {
      return true;
    }
  }
  return false;
}

}  // namespace impetus::inline run
