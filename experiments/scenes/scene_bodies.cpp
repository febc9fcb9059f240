// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_bodies.hpp"

#include <cstdlib>
#include <filesystem>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/figures/scene_figures.hpp"
#include "experiments/scenes/scene_meshes.hpp"
#include "experiments/scenes/scene_settings.hpp"
#include "experiments/scenes/scene_tree.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

std::array<float, 3> parse_colour(const std::string& text) {
  const auto number = static_cast<unsigned>(std::strtoul(text.c_str() + 1, nullptr, 16));
  const auto channel = [number](unsigned shift) {
    return static_cast<float>((number >> shift) & 0xffU) / 255.0F;
  };
  return {channel(16), channel(8), channel(0)};
}

std::string name_of_shape(const json& shape) {
  return is_mesh(shape) ? std::filesystem::path(shape["file"].get<std::string>()).stem().string()
                        : shape["kind"].get<std::string>();
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
  bodies.looks.push_back({traits.name, shape.radius_m, parse_colour(traits.colour), shape.mesh});
  bodies.shapes.push_back(&shape);
  bodies.shape_names.push_back(shape_name);
}

SceneBodies bodies_of(const json& scene, double metres_per_degree, ShapeLibrary& library,
                      int deepest_level) {
  const ShapeFrame frame{metres_per_degree, tree_settings_of(scene["engine"], deepest_level)};
  const json meshes = scene.value("meshes", json::object());
  const bool no_spin = scene.contains("imposed") && scene["imposed"].value("no_spin", false);
  SceneBodies bodies;
  if (scene.contains("crowd")) {
    const json& crowd = scene["crowd"];
    const BodyShape& shape = library.shape(crowd["shape"], meshes, frame);
    const json& colours = crowd["colours"];
    for (std::size_t i = 0; i < crowd["count"].get<std::size_t>(); ++i) {
      add_body({std::to_string(i + 1), colours[i % colours.size()].get<std::string>(),
                crowd["density_kg_m3"].get<double>(), material_of(scene, crowd), false, no_spin},
               shape, name_of_shape(crowd["shape"]), bodies);
    }
    return bodies;
  }
  for (const json& body : scene.value("bodies", json::array())) {
    add_body({body["name"].get<std::string>(), body["colour"].get<std::string>(),
              body["density_kg_m3"].get<double>(), material_of(scene, body),
              body.value("fixed", false), no_spin},
             library.shape(body["shape"], meshes, frame), name_of_shape(body["shape"]), bodies);
  }
  add_figures(scene, frame, library, bodies);
  return bodies;
}

Quaternion orientation_of(const json& body) {
  Quaternion orientation = Quaternion::Identity();
  for (const json& turn : body.value("orientation", json::array())) {
    const SineCosine half = sine_cosine_deg(0.5 * turn["angle_deg"].get<double>());
    const auto axis = turn["axis"].get<std::string>();
    const Quaternion one(half.cosine, axis == "x" ? half.sine : 0.0, axis == "y" ? half.sine : 0.0,
                         axis == "z" ? half.sine : 0.0);
    orientation = one * orientation;
  }
  return orientation;
}

Vector3 vector_of(const json& body, const char* key, double unit) {
  const auto numbers = body.value(key, std::vector<double>{0.0, 0.0, 0.0});
  return unit * Vector3(numbers[0], numbers[1], numbers[2]);
}

}  // namespace impetus::inline scenes
