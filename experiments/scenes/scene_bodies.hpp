// A scene's bodies as the engine's models and the stage's looks.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline scenes {

/// Bodies by index, each with the shape it has; the shapes are the library's. `shape_names` are
/// what the shapes are called: by their kind or file, a figure's by its part.
struct SceneBodies {
  std::vector<BodyModel> models;
  std::vector<DrawnBody> looks;
  std::vector<const BodyShape*> shapes;
  std::vector<std::string> shape_names{};
  std::vector<Figure> figures{};  ///< whose parts are the last of the bodies
};

/// What bodies of one shape may differ in.
struct BodyTraits {
  std::string name;
  Colour colour{};
  double density_kg_m3{0.0};
  int material{0};
  bool fixed{false};
  bool no_spin{false};
};

void add_body(const BodyTraits& traits, const BodyShape& shape, const std::string& shape_name,
              SceneBodies& bodies);

/// The bodies a scene names one by one, or its crowd: "1", "2", ... in the crowd's colours in turn;
/// then the parts of its figures, figure by figure: "anna/head". Trees are not built beyond
/// `deepest_level`. Precondition: the shapes' checks find nothing.
SceneBodies bodies_of(const Scene& scene, double metres_per_degree, ShapeLibrary& library,
                      int deepest_level = kGreatestTreeDepth);

}  // namespace impetus::inline scenes
