// A scene's body by its name.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// Its place among the bodies that are named, or one past the last.
inline std::size_t place_of_body(const Scene& scene, const std::string& name) {
  const auto bodies = scene.named_bodies();
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const BodySettings& body) { return body.name == name; });
  return static_cast<std::size_t>(found - bodies.begin());
}

}  // namespace impetus::inline scenes
