// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_bodies.hpp"

#include <filesystem>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/figures/scene_figures.hpp"

namespace impetus::inline scenes {
namespace {

std::string name_of_shape(const ShapeSettings& shape) {
  return shape.kind == ShapeKind::kMesh ? std::filesystem::path(*shape.file).stem().string()
                                        : name_of(shape.kind);
}

}  // namespace

void add_body(const BodyTraits& traits, const BodyShape& shape, const std::string& shape_name,
              SceneBodies& bodies) {
  BodyModel model;
  model.name = traits.name;
  model.tree = shape.tree;
  model.material = traits.material;
  if (!traits.fixed) {
    model.inverse_mass = 1.0 / (traits.density_kg_m3 * shape.unit_mass.mass_kg);
  }
  if (!traits.fixed && !traits.no_spin) {
    model.inverse_inertia = Matrix3(traits.density_kg_m3 * shape.unit_mass.inertia).inverse();
  }
  bodies.models.push_back(std::move(model));
  bodies.looks.push_back({traits.name, shape.radius_m, traits.colour, shape.mesh});
  bodies.shapes.push_back(&shape);
  bodies.shape_names.push_back(shape_name);
}

SceneBodies bodies_of(const Scene& scene, double metres_per_degree, ShapeLibrary& library,
                      int deepest_level) {
  const ShapeFrame frame{metres_per_degree, tree_settings_of(scene.engine, deepest_level)};
  SceneBodies bodies;
  if (scene.crowd) {
    const BodyCrowd& crowd = *scene.crowd;
    const BodyShape& shape = library.shape(crowd.shape, scene.meshes, frame);
    const int material = material_number(scene, crowd.material);
    for (std::size_t i = 0; i < crowd.count; ++i) {
      add_body({std::to_string(i + 1), crowd.colours[i % crowd.colours.size()], crowd.density_kg_m3,
                material, false, scene.no_spin()},
               shape, name_of_shape(crowd.shape), bodies);
    }
    return bodies;
  }
  for (const BodySettings& body : scene.named_bodies()) {
    add_body({body.name, body.colour, body.density_kg_m3, material_number(scene, body.material),
              body.fixed.value_or(false), scene.no_spin()},
             library.shape(body.shape, scene.meshes, frame), name_of_shape(body.shape), bodies);
    bodies.models.back().passes_through = body.passes_through;
    bodies.looks.back().texture = body.texture;
  }
  add_figures(scene, frame, library, bodies);
  return bodies;
}

}  // namespace impetus::inline scenes
