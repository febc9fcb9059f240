// SPDX-License-Identifier: MIT
#include "experiments/scenes/plane/scene_goal.hpp"

#include <string>

#include "experiments/scenes/plane/named_body.hpp"

namespace impetus::inline scenes {

std::optional<Goal> goal_of(const Scene& scene, double metres_per_degree) {
  if (!scene.goal) {
    return std::nullopt;
  }
  using Side = GoalSettings::Side;
  const GoalSettings& said = *scene.goal;
  Goal goal;
  goal.body = place_of_body(scene, said.body);
  goal.axis = said.side == Side::kLeft || said.side == Side::kRight ? 0 : 1;
  goal.sense = said.side == Side::kLeft || said.side == Side::kBelow ? -1.0 : 1.0;
  goal.line_m = metres_per_degree * scene.plane->place_deg({said.line_px, said.line_px})[goal.axis];
  for (const std::string& name : said.missed_at) {
    goal.missed_at.push_back(place_of_body(scene, name));
  }
  goal.follow_s = said.follow_s;
  return goal;
}

void add_goal_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.goal) {
    return;
  }
  const auto bodies = scene.named_bodies();
  if (!scene.plane) {
    problems.add("/goal", "expected none without a plane, whose pixels its line is said in");
  }
  if (scene.meeting) {
    problems.add("/goal", "expected none where two bodies meet");
  }
  const std::size_t body = place_of_body(scene, scene.goal->body);
  if (body == bodies.size()) {
    problems.add_got("/goal/body", "expected the name of a body");
  } else if (bodies[body].fixed.value_or(false)) {
    problems.add_got("/goal/body", "expected a body that moves");
  }
  for (std::size_t i = 0; i < scene.goal->missed_at.size(); ++i) {
    const std::size_t other = place_of_body(scene, scene.goal->missed_at[i]);
    if (other == bodies.size() || other == body) {
      problems.add_got("/goal/missed_at/" + std::to_string(i), "expected the name of another body");
    }
  }
}

}  // namespace impetus::inline scenes
