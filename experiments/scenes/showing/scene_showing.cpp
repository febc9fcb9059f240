// SPDX-License-Identifier: MIT
#include "experiments/scenes/showing/scene_showing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/scenes/plane/named_body.hpp"

namespace impetus::inline scenes {

void apply_showing(const Scene& scene, double hold_s, StagedScene& staged) {
  const ShowingSettings& said = scene.showing;
  staged.still_s = said.still_s;
  staged.duration_s = scene.lasting_s(hold_s);
  staged.unseen_s = said.still_s + scene.moving_s(hold_s) - staged.duration_s;
  if (!said.flashing) {
    return;
  }
  staged.flashing = {{}, said.flashing->hz, said.flashing->colour, said.still_s};
  for (const std::string& name : said.flashing->bodies) {
    staged.flashing.bodies.push_back(place_of_body(scene, name));
  }
}

void add_showing_problems(const Scene& scene, SceneProblems& problems) {
  const ShowingSettings& said = scene.showing;
  const double steps = said.still_s * scene.engine.step_hz;
  if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    problems.add_got("/still_s", "expected a whole number of steps of 1/" +
                                     problems.written("/engine/step_hz") + " s");
  }
  if (said.flashing) {
    if (said.still_s == 0.0) {
      problems.add("/flashing", "expected none without still_s, while which bodies flash");
    }
    for (std::size_t i = 0; i < said.flashing->bodies.size(); ++i) {
      if (place_of_body(scene, said.flashing->bodies[i]) == scene.named_bodies().size()) {
        problems.add_got("/flashing/bodies/" + std::to_string(i), "expected the name of a body");
      }
    }
  }
  if (said.hidden_after_s && (scene.meeting || scene.duration_s)) {
    const double moving_s = scene.moving_s(scene.intended_hold_s());
    if (*said.hidden_after_s >= moving_s) {
      problems.add_got(
          "/hidden_after_s",
          "expected less than the " + nlohmann::json(moving_s).dump() + " s that the scene lasts");
    }
  }
}

}  // namespace impetus::inline scenes
