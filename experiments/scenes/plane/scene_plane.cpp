// SPDX-License-Identifier: MIT
#include "experiments/scenes/plane/scene_plane.hpp"

#include <string>
#include <utility>

namespace impetus::inline scenes {
namespace {

const std::string kWhy = "without a plane that has pixels";

void add_shape_problem(const Scene& scene, const ShapeSettings& shape, const std::string& place,
                       SceneProblems& problems) {
  if (shape.has_px && !scene.plane) {
    problems.add(place, "expected no measures in pixels " + kWhy);
  }
}

}  // namespace

void add_plane_problems(const Scene& scene, SceneProblems& problems) {
  if (scene.crowd) {
    add_shape_problem(scene, scene.crowd->shape, "/crowd/shape", problems);
  }
  const auto bodies = scene.named_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string place = "/bodies/" + std::to_string(i);
    add_shape_problem(scene, bodies[i].shape, place + "/shape", problems);
    for (const auto& [px, deg] :
         {std::pair("position_px", "position_deg"), std::pair("velocity_px_s", "velocity_deg_s")}) {
      const std::string in_px = place + "/" + px;
      if (problems.says(in_px) && !scene.plane) {
        problems.add_got(in_px, "expected none " + kWhy);
      } else if (problems.says(in_px) && problems.says(place + "/" + deg)) {
        problems.add_got(in_px, std::string("expected none beside ") + deg);
      }
    }
  }
}

}  // namespace impetus::inline scenes
